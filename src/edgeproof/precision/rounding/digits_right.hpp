// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof {

/// The largest number of digits that is counted, also for a relative error of 0.
constexpr unsigned most_digits_right = 1000;

/// Returns -log10 |x/exact - 1| for the number of the ball that is worst for x, limited by the bits
/// of both. 0 for negative values, for a NaN, and if the ball contains zero and x is not zero.
[[nodiscard]] double digits_reached(const Real& x, const Ball& exact);
/// The same rounded down; 0 for less than one digit.
[[nodiscard]] unsigned digits_right(const Real& x, const Ball& exact);
/// Returns -log10 of the relative radius of the ball, rounded down.
[[nodiscard]] unsigned digits_proved(const Ball& x);

} // namespace edgeproof

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof {

/// Digits counted no further than this: what a relative error of 0 has.
constexpr unsigned most_digits_right = 1000;

/// -log10 |x/exact - 1| for the number of the ball that is worst for x, no more than its bits can
/// tell; 0 for fewer than none, for a NaN, and where the ball holds zero and x is not zero.
[[nodiscard]] double digits_reached(const Real& x, const Ball& exact);
/// The same rounded down, and 0 for fewer than one digit.
[[nodiscard]] unsigned digits_right(const Real& x, const Ball& exact);
/// -log10 of the ball's relative radius, rounded down.
[[nodiscard]] unsigned digits_proved(const Ball& x);

} // namespace edgeproof

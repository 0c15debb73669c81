// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::formula {

/// An enclosure of a constant. Throws BudgetError where ball arithmetic cannot give one.
[[nodiscard]] Ball ball_of(const Exact& x, long bits);

/// The bits that carry so many decimal digits, with a few to spare.
[[nodiscard]] long bits_for(unsigned digits);

/// The value, where it is seen to be rational.
[[nodiscard]] std::optional<Rational> rational_of(const Exact& x);

} // namespace edgeproof::formula

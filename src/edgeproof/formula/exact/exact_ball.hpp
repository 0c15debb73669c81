// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>

namespace edgeproof::formula {

/// Returns an enclosure of a constant. Throws BudgetError if ball arithmetic finds none.
[[nodiscard]] Ball ball_of(const Exact& x, long bits);

/// Returns the number of bits for `digits` decimal digits, with a few guard bits.
[[nodiscard]] long bits_for(unsigned digits);

/// Returns the value if it is recognised as rational.
[[nodiscard]] std::optional<Rational> rational_of(const Exact& x);

} // namespace edgeproof::formula

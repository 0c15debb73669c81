// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <optional>
#include <string_view>

namespace edgeproof::formula {

/// Returns a finite enclosure of a constant expression, by ball arithmetic at `bits` bits; its ends
/// have 2 bits more. Nothing if the balls do not exclude a point where the expression is undefined.
/// Throws Error for an integral, and for a name without a value.
[[nodiscard]] std::optional<Ball> enclose(const Expr& constant, long bits);

/// The environment in which an expression without variables is evaluated in balls (evaluate.hpp).
struct BallConstants {
    long bits;
    [[nodiscard]] Ball number(const Rational& q) const { return {q, bits}; }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
    /// Throws Error, because there are no variables.
    [[noreturn]] static Ball symbol(std::string_view name);
};

/// Returns an enclosure of a constant at a working precision of `bits`.
[[nodiscard]] Ball enclosed_constant(const Exact& x, long bits);
/// The same for an expression without variables.
[[nodiscard]] Ball enclosed_constant(const Expr& e, long bits);

/// Returns an enclosure of a constant. Throws BudgetError if ball arithmetic finds none.
[[nodiscard]] Ball ball_of(const Exact& x, long bits);

/// Returns the number of bits for `digits` decimal digits, with a few guard bits.
[[nodiscard]] long bits_for(unsigned digits);

/// Returns the value if it is recognised as rational.
[[nodiscard]] std::optional<Rational> rational_of(const Exact& x);

} // namespace edgeproof::formula

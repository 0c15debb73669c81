// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <string_view>

namespace edgeproof::formula {

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

} // namespace edgeproof::formula

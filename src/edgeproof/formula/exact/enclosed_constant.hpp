// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <string_view>

namespace edgeproof::formula {

/// What an expression without variables is evaluated in, by balls (evaluate.hpp).
struct BallConstants {
    long bits;
    [[nodiscard]] Ball number(const Rational& q) const { return {q, bits}; }
    [[nodiscard]] Ball pi() const { return Ball::pi(bits); }
    /// Throws Error: there are no variables.
    [[noreturn]] static Ball symbol(std::string_view name);
};

/// A constant in a ball.
[[nodiscard]] Ball enclosed_constant(const Exact& x, long bits);
/// The same of an expression without variables.
[[nodiscard]] Ball enclosed_constant(const Expr& e, long bits);

} // namespace edgeproof::formula

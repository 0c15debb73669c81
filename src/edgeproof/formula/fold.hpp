// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace edgeproof::formula {

/// The size of a rational: the bits of numerator and denominator together.
[[nodiscard]] std::size_t bits_of(const Rational& q);

/// Returns the root of this degree, if it is rational and q is not negative.
[[nodiscard]] std::optional<Rational> exact_root(const Rational& q, unsigned long degree);

/// Returns q^n, with 0^0 = 1.
[[nodiscard]] Rational whole_power(const Rational& q, unsigned long n);

/// Larger exact results are not folded but evaluated numerically.
inline constexpr std::size_t max_folded_bits = std::size_t{1} << 17U;

/// Returns the exact rational value of a node with rational children; nothing if it is irrational,
/// undefined (1/0) or too large.
[[nodiscard]] std::optional<Rational> fold(Expr::Kind kind, Builtin f, std::span<const Expr> args);

/// A number in an expression, "12.5e-3", and the position after it.
struct DecimalToken {
    Rational value;
    std::size_t end = 0;
};

/// Returns the exact number that begins at `start`, where there is a digit or a point. An `e`
/// without digits after it is left for a name. `bits` counts the bits of all numbers of the
/// expression so far. Throws FormulaError for a point without digits, a second point, an exponent
/// beyond 100,000, and numbers of more than 4,000,000 bits together.
[[nodiscard]] DecimalToken decimal_token(std::string_view text, std::size_t start,
                                         std::size_t& bits);

} // namespace edgeproof::formula

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::formula {

/// The size of a rational: the bits of numerator and denominator together.
[[nodiscard]] std::size_t bits_of(const Rational& q);

/// Larger exact results are not folded but evaluated numerically.
inline constexpr std::size_t max_folded_bits = std::size_t{1} << 17U;

/// Returns the exact rational value of a node with rational children; nothing if it is irrational,
/// undefined (1/0) or too large.
[[nodiscard]] std::optional<Rational> fold(Expr::Kind kind, Builtin f, std::span<const Expr> args);

} // namespace edgeproof::formula

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::formula {

/// Size of a rational: bits of numerator and denominator together.
[[nodiscard]] std::size_t bits_of(const Rational& q);

/// Exact results larger than this are left unfolded; they are then evaluated numerically.
inline constexpr std::size_t max_folded_bits = std::size_t{1} << 17U;

/// The exact rational that a node with rational children comes to; nothing if it is irrational,
/// undefined (1/0) or too large.
[[nodiscard]] std::optional<Rational> fold(Expr::Kind kind, Builtin f, std::span<const Expr> args);

} // namespace edgeproof::formula

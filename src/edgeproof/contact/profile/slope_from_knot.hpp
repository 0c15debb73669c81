// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::contact {

/// Returns a slope g'(x) as a function of the distance x - knot; the symbol of the distance is x
/// again. Parts that are linear in x and vanish at the knot lose their constant exactly. So (x -
/// 1/5)^(3/2) keeps its digits at any distance from 1/5.
[[nodiscard]] formula::Expr slope_from_knot(const formula::Expr& slope, const formula::Expr& knot);

/// Returns the same function with polynomials of rational coefficients multiplied out. Returns
/// nothing where no part of the slope vanishes at the knot, or where the knot is 0: then x itself
/// has all digits.
[[nodiscard]] std::optional<formula::Expr> slope_near_zero(const formula::Expr& slope,
                                                           const formula::Expr& knot);

/// A slope near a knot that is a branch point of it, written without the branch point. With
/// w^root = |x - knot|, (x - knot)^(3/2) becomes w^3 for root = 2 (docs/curved-slopes.md, "What is
/// integrated").
struct SlopeAtRoot {
    formula::Expr slope; ///< as a function of w >= 0; the symbol is called x
    long root = 1;       ///< the least common denominator of the exponents of x - knot
};

/// Returns this form for the side to the right or to the left of the knot. Returns nothing if no
/// power of a multiple of x - knot has a rational exponent that is not an integer, or if the common
/// denominator is greater than 24.
[[nodiscard]] std::optional<SlopeAtRoot>
slope_at_root(const formula::Expr& slope, const formula::Expr& knot, bool to_the_right);

} // namespace edgeproof::contact

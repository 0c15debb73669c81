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

} // namespace edgeproof::contact

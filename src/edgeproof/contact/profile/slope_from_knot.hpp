// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <optional>

namespace edgeproof::contact {

/// A slope g'(x) as a function of the distance x - knot, called x again: parts that are linear in
/// x lose their constant exactly where they vanish on the knot, so that (x - 1/5)^(3/2) keeps its
/// digits however near to 1/5.
[[nodiscard]] formula::Expr slope_from_knot(const formula::Expr& slope, const formula::Expr& knot);

/// The same, with polynomials of rational coefficients multiplied out, where a part of it vanishes
/// on the knot, and the knot is not 0; else nothing: x itself serves as well.
[[nodiscard]] std::optional<formula::Expr> slope_beside_zero(const formula::Expr& slope,
                                                             const formula::Expr& knot);

} // namespace edgeproof::contact

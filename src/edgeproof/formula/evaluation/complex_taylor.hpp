// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/arb_values.hpp"

namespace edgeproof::formula {

/// True if complex_taylor supports every function in e, whose only variable is x.
[[nodiscard]] bool has_complex_taylor(const Expr& e);

/// Computes the Taylor series of e(x) about x = at with `terms` terms. Each coefficient is an
/// enclosure for every point of the complex ball `at`. Where e may not be holomorphic on the whole
/// ball (a branch cut, a pole) the coefficients are not finite.
/// @param[out] series coefficients
/// @param e expression in x
/// @param at centre
/// @param terms number of coefficients
/// @param bits working precision
void complex_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits);

/// The same for the real points of a ball where e is defined, holomorphic or not: x^(3/2) and its
/// first derivative are enclosed also near 0.
void real_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits);

} // namespace edgeproof::formula

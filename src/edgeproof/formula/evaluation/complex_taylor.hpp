// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/acb_include.hpp"

namespace edgeproof::formula {

/// True where complex_taylor knows every function in e, whose only variable is x.
[[nodiscard]] bool has_complex_taylor(const Expr& e);

/// The Taylor series of e(x) about x = at, `terms` terms, each an enclosure for every point of the
/// ball `at`, which is complex. Where e may not be holomorphic on the whole ball (a branch cut, a
/// pole) the coefficients are not finite.
void complex_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits);

/// The same of the real points of a ball where e is defined, holomorphic or not: x^(3/2) is
/// enclosed beside 0 as well, and its first derivative.
void real_taylor(acb_poly_t series, const Expr& e, const acb_t at, long terms, long bits);

} // namespace edgeproof::formula

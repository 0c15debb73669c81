// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace GiNaC {
class ex;
} // namespace GiNaC

namespace edgeproof::audit::ginac {

/// A polynomial with rational coefficients as the product of a number and powers of polynomials
/// that are irreducible over the integers. What is no symbol and no number in it (a function, say)
/// counts as a variable.
///
/// By FLINT (fmpz_mpoly_factor): GiNaC's own factor() draws places at random, in an order of the
/// variables that differs from run to run, and now and then does not end.
[[nodiscard]] GiNaC::ex polynomial_factors(const GiNaC::ex& polynomial);

} // namespace edgeproof::audit::ginac

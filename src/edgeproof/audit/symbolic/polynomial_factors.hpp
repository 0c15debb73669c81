// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace GiNaC {
class ex;
} // namespace GiNaC

namespace edgeproof::audit::ginac {

/// Returns a polynomial with rational coefficients as the product of a number and powers of
/// polynomials that are irreducible over the integers. Parts that are neither symbols nor numbers,
/// such as functions, count as variables.
///
/// This uses FLINT (fmpz_mpoly_factor), because GiNaC's factor() uses random points and an order of
/// the variables that differs from run to run, and sometimes does not terminate.
[[nodiscard]] GiNaC::ex polynomial_factors(const GiNaC::ex& polynomial);

} // namespace edgeproof::audit::ginac

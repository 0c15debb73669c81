// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <mutex>
#include <string_view>
#include <vector>

namespace GiNaC {
class ex;
} // namespace GiNaC

/// Conversion between expressions of Edgeproof and GiNaC. GiNaC is not thread-safe: callers must
/// hold `hold()`. Its order of terms changes from run to run, so that results are sorted.
namespace edgeproof::audit::ginac {

[[nodiscard]] std::unique_lock<std::recursive_mutex> hold();

/// Returns the symbol with this name, always the same one. All symbols are real; lengths, moduli
/// and similar quantities are positive.
[[nodiscard]] GiNaC::ex symbol(std::string_view name);
/// Converts an expression. Functions that GiNaC does not have, and integrals, become symbols, which
/// are converted back by to_expr.
[[nodiscard]] GiNaC::ex from_expr(const formula::Expr& e);
/// True if the name is inside a part that becomes a symbol; derivatives by it are then wrong.
[[nodiscard]] bool hides(const formula::Expr& e, std::string_view name);
[[nodiscard]] formula::Expr to_expr(const GiNaC::ex& e);

/// True if e is shown to vanish identically, with half-integer powers and symbolic exponents taken
/// into account (bases positive). False means only that this was not shown.
[[nodiscard]] bool is_zero(const GiNaC::ex& e);
/// Returns q_0, q_1, ... with e = (q_0 + q_1 s + ...)/sqrt(hi - s). Throws DomainError if e does
/// not have this form.
[[nodiscard]] std::vector<GiNaC::ex> polynomial_over_root(const GiNaC::ex& e, const GiNaC::ex& s,
                                                          const GiNaC::ex& hi);
/// Returns one fraction with separate factors, and with sums collected by derivatives of P.
[[nodiscard]] formula::Expr tidy(const GiNaC::ex& e);

} // namespace edgeproof::audit::ginac

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"

#include <ginac/ginac.h>

#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Conversion between expressions of Edgeproof and GiNaC. GiNaC is not thread-safe: callers must
/// hold `hold()`. Its order of terms changes from run to run, so that results are sorted.
namespace edgeproof::audit::ginac {

using formula::Expr;

using GiNaC::ex;

[[nodiscard]] std::unique_lock<std::recursive_mutex> hold();

/// Calls take(part) for each factor of a product, or for an expression that is none.
template <class Take> void for_each_factor(const ex& e, const Take& take) {
    if (!GiNaC::is_a<GiNaC::mul>(e)) {
        take(e);
        return;
    }
    for (const ex& factor : e) {
        take(factor);
    }
}
/// The same for the terms of a sum.
template <class Take> void for_each_term(const ex& e, const Take& take) {
    if (!GiNaC::is_a<GiNaC::add>(e)) {
        take(e);
        return;
    }
    for (const ex& term : e) {
        take(term);
    }
}

/// Returns the symbol with this name, always the same one. All symbols are real; lengths, moduli
/// and similar quantities are positive.
[[nodiscard]] ex symbol(std::string_view name);
/// Converts an expression. Functions that GiNaC does not have, and integrals, become symbols, which
/// are converted back by to_expr.
[[nodiscard]] ex from_expr(const Expr& e);
/// True if the name is inside a part that becomes a symbol; derivatives by it are then wrong.
[[nodiscard]] bool hides(const Expr& e, std::string_view name);
[[nodiscard]] Expr to_expr(const ex& e);
/// Throws Error if a number is not rational.
[[nodiscard]] Rational rational_of(const ex& number);
/// Returns number * over / under, with the factors sorted by their texts. `number` is positive.
[[nodiscard]] Expr quotient(const Rational& number, std::vector<Expr> over,
                            std::vector<Expr> under);

/// True if e is shown to vanish identically, with half-integer powers and symbolic exponents taken
/// into account (bases positive). False means only that this was not shown.
[[nodiscard]] bool is_zero(const ex& e);
/// Returns q_0, q_1, ... with e = (q_0 + q_1 s + ...)/sqrt(hi - s). Throws DomainError if e does
/// not have this form.
[[nodiscard]] std::vector<ex> polynomial_over_root(const ex& e, const ex& s, const ex& hi);
/// Returns one fraction with separate factors, and with sums collected by derivatives of P.
[[nodiscard]] Expr tidy(const ex& e);

/// Returns a polynomial with rational coefficients as the product of a number and powers of
/// polynomials that are irreducible over the integers. Parts that are neither symbols nor numbers,
/// such as functions, count as variables.
///
/// This uses FLINT (fmpz_mpoly_factor), because GiNaC's factor() uses random points and an order of
/// the variables that differs from run to run, and sometimes does not terminate.
[[nodiscard]] ex polynomial_factors(const ex& polynomial);

/// Replaces roots by symbols, because GiNaC's `normal` treats a^(1/2) and (2 a)^(1/2) as
/// independent. Here roots are taken of irreducible factors only; each is a symbol w with the rule
/// w^n = factor. The result is a rational function, for which `normal` decides.
class Roots {
public:
    /// Returns e as a rational function, with symbols for roots and other transcendental parts.
    ex rational(const ex& e);
    /// Returns `rational` as one fraction in lowest terms, with powers of roots reduced.
    ex fraction(const ex& e);
    /// Returns a polynomial with every w^k, k >= n, reduced by w^n = factor.
    [[nodiscard]] ex reduced(ex polynomial) const;
    /// Returns e with the roots and other parts put back.
    [[nodiscard]] ex restored(ex e) const;
    /// True if a root or another transcendental part in `whole` contains s.
    [[nodiscard]] bool involves(const ex& whole, const ex& s) const;
    /// Returns the root for which the symbol s was introduced; 0 if there is none.
    [[nodiscard]] ex root_meaning(const ex& s) const;

private:
    struct Root {
        ex base;
        int index;
        ex symbol;
    };
    ex atom(const ex& e);
    ex root(const ex& base, int index);
    ex power(const ex& base, const ex& exponent);
    ex fractional(const ex& base, const GiNaC::numeric& q);
    ex prime_power(const ex& prime, const GiNaC::numeric& q);
    ex number_power(GiNaC::numeric n, const GiNaC::numeric& q);
    ex one_root(const ex& base, const GiNaC::numeric& q);

    std::vector<std::pair<ex, ex>> atoms_;
    std::vector<Root> roots_;
};

} // namespace edgeproof::audit::ginac

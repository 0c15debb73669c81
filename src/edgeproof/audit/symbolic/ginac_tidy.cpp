// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::audit::ginac {
namespace {

using GiNaC::is_a;
using GiNaC::numeric;

std::vector<ex> force_derivatives() {
    std::vector<ex> all;
    for (int k = 1; k <= 9; ++k) {
        all.push_back(symbol("P" + std::to_string(k)));
    }
    return all;
}

/// A product with separate factors, in an order independent of GiNaC's.
class Factored {
public:
    bool minus = false;
    Rational number{1};

    void multiply(const Expr& base, const Rational& exponent) {
        for (auto& [known, k] : factors_) {
            if (known == base) {
                k += exponent;
                return;
            }
        }
        factors_.emplace_back(base, exponent);
    }
    void divide_by(const Factored& o) {
        minus = minus != o.minus;
        number /= o.number;
        for (const auto& [base, k] : o.factors_) {
            multiply(base, -k);
        }
    }
    [[nodiscard]] bool is_one() const { return factors_.empty() && number == 1; }
    /// Returns the product without the sign.
    [[nodiscard]] Expr magnitude() const { return quotient(number, side(true), side(false)); }

private:
    [[nodiscard]] std::vector<Expr> side(bool over) const {
        std::vector<Expr> all;
        for (const auto& [base, exponent] : factors_) {
            const Rational k = over ? exponent : Rational(-exponent);
            if (k > 0) {
                all.push_back(k == 1                ? base
                              : k == Rational(1, 2) ? Expr::call("sqrt", {base})
                                                    : pow(base, formula::quotient_of(k)));
            }
        }
        return all;
    }
    std::vector<std::pair<Expr, Rational>> factors_;
};

Factored factored(const ex& polynomial, const Roots& roots, bool collect);

/// A term of a sum: true if it is subtracted, and its magnitude.
using Term = std::pair<bool, Expr>;

/// Returns the sum over P1, P2, ... of factored coefficients.
std::vector<Term> collected(const ex& sum, const Roots& roots) {
    std::vector<Term> terms;
    ex rest = sum.expand();
    for (const ex& P : force_derivatives()) {
        const ex c = rest.coeff(P, 1);
        if (c.is_zero()) {
            continue;
        }
        rest = (rest - c * P).expand();
        const Factored f = factored(c, roots, false);
        const Expr name = to_expr(P);
        terms.emplace_back(f.minus, f.is_one() ? name : f.magnitude() * name);
    }
    if (!rest.is_zero()) {
        const Factored f = factored(rest, roots, false);
        terms.emplace_back(f.minus, f.magnitude());
    }
    return terms;
}

Expr sum_of(const std::vector<Term>& terms, bool turned) {
    Expr e = terms[0].first != turned ? -terms[0].second : terms[0].second;
    for (std::size_t i = 1; i < terms.size(); ++i) {
        e = terms[i].first != turned ? e - terms[i].second : e + terms[i].second;
    }
    return e;
}

/// Returns the formula of a sum or of its negative (then the second value is true). The shorter
/// text is chosen, so that the choice is the same on every run.
std::pair<Expr, bool> sum_text(const ex& sum, const Roots& roots, bool collect) {
    const std::vector<ex> derivatives = force_derivatives();
    const bool linear = collect && std::ranges::any_of(derivatives, [&](const ex& P) {
                            return sum.degree(P) == 1;
                        });
    const std::vector<Term> terms = linear ? collected(sum, roots) : std::vector<Term>{};
    const Expr e = linear ? sum_of(terms, false) : to_expr(roots.restored(sum));
    const Expr turned = linear ? sum_of(terms, true) : to_expr(roots.restored((-sum).expand()));
    const std::string s = to_text(e);
    const std::string t = to_text(turned);
    if (t.size() < s.size() || (t.size() == s.size() && t < s)) {
        return {turned, true};
    }
    return {e, false};
}

Factored factored(const ex& polynomial, const Roots& roots, bool collect) {
    Factored result;
    const auto take_number = [&](const ex& n, long k) {
        Rational q = rational_of(n);
        if (q < 0) {
            q = -q;
            result.minus = result.minus != (k % 2 != 0);
        }
        for (long j = 0; j < k; ++j) {
            result.number *= q;
        }
    };
    const auto take = [&](const ex& factor) {
        ex base = factor;
        numeric k(1);
        if (is_a<GiNaC::power>(factor) && is_a<numeric>(factor.op(1))) {
            base = factor.op(0);
            k = GiNaC::ex_to<numeric>(factor.op(1));
        }
        if (is_a<numeric>(base)) {
            take_number(base, k.to_long());
            return;
        }
        const Rational exponent = rational_of(k);
        if (is_a<GiNaC::add>(base)) {
            const ex content = base.integer_content();
            take_number(content, k.to_long());
            const auto [text, turned] = sum_text((base / content).expand(), roots, collect);
            result.minus = result.minus != (turned && !k.is_even());
            result.multiply(text, exponent);
            return;
        }
        const ex meaning = roots.root_meaning(base);
        if (is_a<GiNaC::power>(meaning)) {
            // The root of a sum counts as a power of the sum, which is written as in other places.
            const ex inside = roots.restored(meaning.op(0));
            result.multiply(is_a<GiNaC::add>(inside) ? sum_text(inside, roots, collect).first
                                                     : to_expr(inside),
                            exponent * rational_of(meaning.op(1)));
            return;
        }
        const ex restored = roots.restored(base);
        if (is_a<GiNaC::power>(restored) && is_a<numeric>(restored.op(1))) {
            result.multiply(to_expr(restored.op(0)), exponent * rational_of(restored.op(1)));
        } else {
            result.multiply(to_expr(restored), exponent);
        }
    };
    const ex whole = polynomial_factors(polynomial);
    for_each_factor(whole, take);
    return result;
}

} // namespace

Expr tidy(const ex& e) {
    Roots roots;
    const ex fraction = roots.fraction(e);
    const ex over = fraction.numer();
    if (over.is_zero()) {
        return Expr::number(0);
    }
    Factored result = factored(over, roots, true);
    result.divide_by(factored(fraction.denom(), roots, false));
    const Expr magnitude = result.magnitude();
    return result.minus ? -magnitude : magnitude;
}

} // namespace edgeproof::audit::ginac

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ginac_bridge.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <string>
#include <vector>

/// GiNaC's `normal` knows nothing of roots: to it a^(1/2) and (2 a)^(1/2) have nothing in common.
/// Here every root is taken of irreducible factors only, each with a symbol w of its own and the
/// rule w^n = factor; what is left is a rational function, and `normal` decides.
namespace edgeproof::ginac {
namespace {

using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::numeric;

class Roots {
public:
    /// e as a rational function of symbols, roots and other transcendental parts being symbols.
    ex rational(const ex& e) {
        if (is_a<GiNaC::power>(e)) {
            return power(e.op(0), e.op(1));
        }
        if (is_a<GiNaC::add>(e)) {
            ex sum = 0;
            for (const ex& term : e) {
                sum += rational(term);
            }
            return sum;
        }
        if (is_a<GiNaC::mul>(e)) {
            ex product = 1;
            for (const ex& factor : e) {
                product *= rational(factor);
            }
            return product;
        }
        if (is_a<GiNaC::function>(e)) {
            return atom(e.map([](const ex& part) { return part.normal(); }));
        }
        if (is_a<GiNaC::constant>(e)) {
            return atom(e);
        }
        return e;
    }

    /// A polynomial with every w^k, k >= n, put down by w^n = factor.
    ex reduced(ex polynomial) {
        polynomial = polynomial.expand();
        // Roots found later may hold earlier ones: from the last to the first.
        for (auto it = roots_.rbegin(); it != roots_.rend(); ++it) {
            const int top = polynomial.degree(it->symbol);
            ex lower = 0;
            for (int k = std::min(0, polynomial.ldegree(it->symbol)); k <= top; ++k) {
                const ex c = polynomial.coeff(it->symbol, k);
                lower +=
                    c * GiNaC::pow(it->symbol, k % it->index) * GiNaC::pow(it->base, k / it->index);
            }
            polynomial = lower.expand();
        }
        return polynomial;
    }

    /// With the roots and other parts back in their places.
    ex restored(ex e) const {
        for (auto it = roots_.rbegin(); it != roots_.rend(); ++it) {
            e = e.subs(it->symbol == GiNaC::pow(it->base, numeric(1, it->index)));
        }
        for (auto it = atoms_.rbegin(); it != atoms_.rend(); ++it) {
            e = e.subs(it->second == it->first);
        }
        return e;
    }

    /// Whether a root or another transcendental part that is left holds s.
    [[nodiscard]] bool involves(const ex& whole, const ex& s) const {
        return std::any_of(roots_.begin(), roots_.end(),
                           [&](const Root& r) { return whole.has(r.symbol) && r.base.has(s); }) ||
               std::any_of(atoms_.begin(), atoms_.end(), [&](const auto& atom) {
                   return whole.has(atom.second) && atom.first.has(s);
               });
    }

    [[nodiscard]] ex root_meaning(const ex& s) const {
        for (const Root& r : roots_) {
            if (r.symbol.is_equal(s)) {
                return GiNaC::pow(r.base, numeric(1, r.index));
            }
        }
        return 0;
    }

private:
    struct Root {
        ex base;
        int index;
        ex symbol;
    };

    ex atom(const ex& e) {
        for (const auto& [meaning, symbol] : atoms_) {
            if (meaning.is_equal(e)) {
                return symbol;
            }
        }
        atoms_.emplace_back(e, GiNaC::possymbol("atom" + std::to_string(atoms_.size())));
        return atoms_.back().second;
    }

    ex root(const ex& base, int index) {
        for (const Root& r : roots_) {
            if (r.index == index && (r.base - base).normal().is_zero()) {
                return r.symbol;
            }
        }
        roots_.push_back({base, index, GiNaC::possymbol("root" + std::to_string(roots_.size()))});
        return roots_.back().symbol;
    }

    ex power(const ex& base, const ex& exponent) {
        const ex e = exponent.expand();
        if (is_a<numeric>(e)) {
            const auto& q = GiNaC::ex_to<numeric>(e);
            if (q.is_integer()) {
                return GiNaC::pow(rational(base), q);
            }
            if (q.is_rational() && q.denom().to_int() <= 12) {
                return fractional(base, q);
            }
            return atom(GiNaC::power(base, e));
        }
        // base^(2 m + 1/2) = (base^m)^2 base^(1/2)
        ex product = 1;
        const auto take = [&](const ex& term) {
            if (is_a<numeric>(term)) {
                product *= power(base, term);
                return;
            }
            numeric coefficient(1);
            ex rest = term;
            if (is_a<GiNaC::mul>(term)) {
                for (const ex& factor : term) {
                    if (is_a<numeric>(factor)) {
                        coefficient = GiNaC::ex_to<numeric>(factor);
                        rest = term / coefficient;
                    }
                }
            }
            const ex one = atom(GiNaC::power(base.normal(), rest));
            product *= coefficient.is_integer() ? ex(GiNaC::pow(one, coefficient))
                                                : fractional(one, coefficient);
        };
        if (is_a<GiNaC::add>(e)) {
            for (const ex& term : e) {
                take(term);
            }
        } else {
            take(e);
        }
        return product;
    }

    /// base^q for a base taken to be positive: factors of definite sign are taken out, the others
    /// stay together, as the sign of each alone is not known.
    ex fractional(const ex& base, const numeric& q) {
        const ex fraction = rational(base).normal();
        ex product = 1;
        ex rest = 1;
        for (const bool over : {true, false}) {
            const ex part = GiNaC::factor(reduced(over ? fraction.numer() : fraction.denom()));
            const auto take = [&](const ex& factor) {
                ex prime = factor;
                numeric k(1);
                if (is_a<GiNaC::power>(factor) && is_a<numeric>(factor.op(1))) {
                    prime = factor.op(0);
                    k = GiNaC::ex_to<numeric>(factor.op(1));
                }
                const int sign = definite_sign(prime);
                if (sign == 0) {
                    rest *= GiNaC::pow(prime, over ? k : -k);
                    return;
                }
                if (sign < 0 && !k.is_even()) {
                    rest = -rest;
                }
                product *= prime_power((prime * sign).expand(), k * (over ? q : -q));
            };
            if (is_a<GiNaC::mul>(part)) {
                for (const ex& factor : part) {
                    take(factor);
                }
            } else {
                take(part);
            }
        }
        rest = rest.normal();
        return rest.is_equal(1) ? product : product * one_root(rest, q);
    }

    /// 1 or -1 for a polynomial all of whose terms have that sign, 0 for any other.
    static int definite_sign(const ex& polynomial) {
        const ex p = polynomial.expand();
        int sign = 0;
        const auto take = [&](const ex& term) {
            int s = 1;
            const auto factor = [&](const ex& f) {
                const ex base = is_a<GiNaC::power>(f) ? f.op(0) : f;
                if (is_a<numeric>(f)) {
                    s = GiNaC::ex_to<numeric>(f).is_negative() ? -s : s;
                } else if (!base.info(GiNaC::info_flags::positive) &&
                           !(is_a<GiNaC::power>(f) && f.op(1).info(GiNaC::info_flags::even))) {
                    s = 0;
                }
            };
            if (is_a<GiNaC::mul>(term)) {
                for (const ex& f : term) {
                    factor(f);
                }
            } else {
                factor(term);
            }
            return s;
        };
        if (!is_a<GiNaC::add>(p)) {
            return take(p);
        }
        for (const ex& term : p) {
            const int s = take(term);
            if (s == 0 || (sign != 0 && s != sign)) {
                return 0;
            }
            sign = s;
        }
        return sign;
    }

    ex prime_power(const ex& prime, const numeric& q) {
        if (is_a<numeric>(prime)) {
            const auto& n = GiNaC::ex_to<numeric>(prime);
            if (n.is_positive()) {
                return number_power(n.numer(), q) * number_power(n.denom(), -q);
            }
        }
        return one_root(prime, q);
    }

    /// By primes, so that sqrt(8) is 2 sqrt(2).
    ex number_power(numeric n, const numeric& q) {
        ex product = 1;
        for (int p = 2; p <= 1000 && !n.is_equal(1); ++p) {
            int k = 0;
            while (GiNaC::irem(n, numeric(p)).is_zero()) {
                n = GiNaC::iquo(n, numeric(p));
                ++k;
            }
            if (k > 0) {
                product *= one_root(numeric(p), q * k);
            }
        }
        return n.is_equal(1) ? product : product * one_root(n, q);
    }

    ex one_root(const ex& base, const numeric& q) {
        const numeric index = q.denom();
        if (index.is_equal(1)) {
            return GiNaC::pow(base, q);
        }
        // base^q = base^floor(q) w^(rest)
        const numeric whole = GiNaC::iquo(q.numer() - GiNaC::mod(q.numer(), index), index);
        const numeric rest = q.numer() - whole * index;
        return GiNaC::pow(base, whole) * GiNaC::pow(root(base, index.to_int()), rest);
    }

    std::vector<std::pair<ex, ex>> atoms_;
    std::vector<Root> roots_;
};

std::vector<ex> force_derivatives() {
    std::vector<ex> all;
    for (int k = 1; k <= 9; ++k) {
        all.push_back(symbol("P" + std::to_string(k)));
    }
    return all;
}

Expr product_of(const std::vector<Expr>& factors) {
    Expr p = factors.front();
    for (std::size_t i = 1; i < factors.size(); ++i) {
        p = p * factors[i];
    }
    return p;
}

/// 3/2 rather than 1.5.
Expr quotient_of(const Rational& q) {
    const Expr top = Expr::number(Rational(numerator(q)));
    return denominator(q) == 1 ? top : top / Expr::number(Rational(denominator(q)));
}

/// A product with its factors apart, in an order that does not depend on GiNaC's.
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
    /// Without the sign.
    [[nodiscard]] Expr magnitude() const {
        std::vector<Expr> over = side(true);
        std::vector<Expr> under = side(false);
        const Rational top(numerator(number));
        const Rational bottom(denominator(number));
        if (top != 1 || over.empty()) {
            over.insert(over.begin(), Expr::number(top));
        }
        if (bottom != 1) {
            under.insert(under.begin(), Expr::number(bottom));
        }
        return under.empty() ? product_of(over) : product_of(over) / product_of(under);
    }

private:
    [[nodiscard]] std::vector<Expr> side(bool over) const {
        std::vector<Expr> all;
        for (const auto& [base, exponent] : factors_) {
            const Rational k = over ? exponent : Rational(-exponent);
            if (k > 0) {
                all.push_back(k == 1                ? base
                              : k == Rational(1, 2) ? Expr::call("sqrt", {base})
                                                    : pow(base, quotient_of(k)));
            }
        }
        std::sort(all.begin(), all.end(), [](const Expr& x, const Expr& y) {
            const std::string s = to_text(x);
            const std::string t = to_text(y);
            return s.size() != t.size() ? s.size() < t.size() : s < t;
        });
        return all;
    }
    std::vector<std::pair<Expr, Rational>> factors_;
};

Factored factored(const ex& polynomial, const Roots& roots, bool collect);

/// Sum over P1, P2, ... of factored coefficients.
Expr collected(const ex& sum, const Roots& roots) {
    std::vector<std::pair<bool, Expr>> terms;
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
    Expr e = terms[0].first ? -terms[0].second : terms[0].second;
    for (std::size_t i = 1; i < terms.size(); ++i) {
        e = terms[i].first ? e - terms[i].second : e + terms[i].second;
    }
    return e;
}

/// The text of a sum, and whether it is that of its negative: the shorter of the two, so that the
/// choice is the same on every run.
std::pair<Expr, bool> sum_text(const ex& sum, const Roots& roots, bool collect) {
    const std::vector<ex> derivatives = force_derivatives();
    const bool linear = collect && std::any_of(derivatives.begin(), derivatives.end(),
                                               [&](const ex& P) { return sum.degree(P) == 1; });
    const auto text_of = [&](const ex& e) {
        return linear ? collected(e, roots) : to_expr(roots.restored(e));
    };
    const Expr e = text_of(sum);
    const Expr turned = text_of((-sum).expand());
    const std::string s = to_text(e);
    const std::string t = to_text(turned);
    if (t.size() < s.size() || (t.size() == s.size() && t < s)) {
        return {turned, true};
    }
    return {e, false};
}

Rational rational_of(const ex& number) {
    const Expr n = to_expr(number);
    if (n.rational() == nullptr) {
        throw Error("a symbolic result holds a number that is not rational");
    }
    return *n.rational();
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
            // The root of a sum counts as a power of the sum, written as it is elsewhere.
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
    const ex whole = GiNaC::factor(polynomial.expand());
    if (is_a<GiNaC::mul>(whole)) {
        for (const ex& factor : whole) {
            take(factor);
        }
    } else {
        take(whole);
    }
    return result;
}

} // namespace

bool is_zero(const ex& e) {
    if (e.is_zero() || e.expand().is_zero()) {
        return true;
    }
    Roots roots;
    const ex fraction = roots.rational(e).normal();
    return roots.reduced(fraction.numer()).normal().is_zero();
}

std::vector<ex> polynomial_over_root(const ex& e, const ex& s, const ex& hi) {
    Roots roots;
    const ex fraction = roots.rational(e * GiNaC::sqrt(hi - s)).normal();
    const ex whole = (roots.reduced(fraction.numer()) / roots.reduced(fraction.denom())).normal();
    if (whole.denom().has(s) || roots.involves(whole, s)) {
        throw DomainError("an integrand is no polynomial over the square root of the distance "
                          "from its upper end");
    }
    const ex under = whole.denom();
    const ex over = whole.numer().expand();
    std::vector<ex> q;
    for (int k = 0; k <= over.degree(s); ++k) {
        q.push_back(roots.restored(over.coeff(s, k) / under));
    }
    return q;
}

Expr tidy(const ex& e) {
    Roots roots;
    ex fraction = roots.rational(e).normal();
    fraction = (roots.reduced(fraction.numer()) / roots.reduced(fraction.denom())).normal();
    const ex over = fraction.numer();
    if (over.is_zero()) {
        return Expr::number(0);
    }
    Factored result = factored(over, roots, true);
    result.divide_by(factored(fraction.denom(), roots, false));
    const Expr magnitude = result.magnitude();
    return result.minus ? -magnitude : magnitude;
}

} // namespace edgeproof::ginac

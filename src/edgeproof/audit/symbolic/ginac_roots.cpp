// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"

#include <algorithm>

namespace edgeproof::audit::ginac {

using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// Returns 1 or -1 for a polynomial whose terms all have that sign, 0 for any other.
int definite_sign(const ex& polynomial) {
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
        for_each_factor(term, factor);
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

} // namespace

ex Roots::rational(const ex& e) {
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

ex Roots::reduced(ex polynomial) const {
    polynomial = polynomial.expand();
    // Later roots may contain earlier ones; therefore go from the last to the first.
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

ex Roots::restored(ex e) const {
    for (auto it = roots_.rbegin(); it != roots_.rend(); ++it) {
        e = e.subs(it->symbol == GiNaC::pow(it->base, numeric(1, it->index)));
    }
    for (auto it = atoms_.rbegin(); it != atoms_.rend(); ++it) {
        e = e.subs(it->second == it->first);
    }
    return e;
}

bool Roots::involves(const ex& whole, const ex& s) const {
    return std::ranges::any_of(
               roots_, [&](const Root& r) { return whole.has(r.symbol) && r.base.has(s); }) ||
           std::ranges::any_of(atoms_, [&](const auto& atom) {
               return whole.has(atom.second) && atom.first.has(s);
           });
}

ex Roots::root_meaning(const ex& s) const {
    for (const Root& r : roots_) {
        if (r.symbol.is_equal(s)) {
            return GiNaC::pow(r.base, numeric(1, r.index));
        }
    }
    return 0;
}

ex Roots::atom(const ex& e) {
    for (const auto& [meaning, symbol] : atoms_) {
        if (meaning.is_equal(e)) {
            return symbol;
        }
    }
    atoms_.emplace_back(e, GiNaC::possymbol("atom" + std::to_string(atoms_.size())));
    return atoms_.back().second;
}

ex Roots::root(const ex& base, int index) {
    for (const Root& r : roots_) {
        if (r.index == index && (r.base - base).normal().is_zero()) {
            return r.symbol;
        }
    }
    roots_.push_back({base, index, GiNaC::possymbol("root" + std::to_string(roots_.size()))});
    return roots_.back().symbol;
}

ex Roots::power(const ex& base, const ex& exponent) {
    const ex e = exponent.expand();
    if (is_a<numeric>(e)) {
        const auto& q = GiNaC::ex_to<numeric>(e);
        if (q.is_integer()) {
            return GiNaC::pow(rational(base), q);
        }
        if (q.is_rational() && q.denom() <= numeric(12)) {
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
    for_each_term(e, take);
    return product;
}

/// Returns base^q for a base assumed to be positive. Factors of definite sign are taken out;
/// the others stay together, as their separate signs are not known.
ex Roots::fractional(const ex& base, const numeric& q) {
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
        for_each_factor(part, take);
    }
    rest = rest.normal();
    return rest.is_equal(1) ? product : product * one_root(rest, q);
}

ex Roots::prime_power(const ex& prime, const numeric& q) {
    if (is_a<numeric>(prime)) {
        const auto& n = GiNaC::ex_to<numeric>(prime);
        if (n.is_positive()) {
            return number_power(n.numer(), q) * number_power(n.denom(), -q);
        }
    }
    return one_root(prime, q);
}

/// Factors the number, so that sqrt(8) becomes 2 sqrt(2).
ex Roots::number_power(numeric n, const numeric& q) {
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

ex Roots::one_root(const ex& base, const numeric& q) {
    const numeric index = q.denom();
    if (index.is_equal(1)) {
        return GiNaC::pow(base, q);
    }
    // base^q = base^floor(q) w^(rest)
    const numeric whole = GiNaC::iquo(q.numer() - GiNaC::mod(q.numer(), index), index);
    const numeric rest = q.numer() - whole * index;
    return GiNaC::pow(base, whole) * GiNaC::pow(root(base, index.to_int()), rest);
}

ex Roots::fraction(const ex& e) {
    const ex whole = rational(e).normal();
    return (reduced(whole.numer()) / reduced(whole.denom())).normal();
}

} // namespace edgeproof::audit::ginac

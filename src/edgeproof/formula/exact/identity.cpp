// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/exact/identity.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/formula/exact/exact_number.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::formula {
namespace {

/// Powers of variables, by the numbers of the variables.
using Monomial = std::map<std::size_t, int>;
using Polynomial = std::map<Monomial, Rational>;

constexpr std::size_t most_terms = 400;
constexpr int most_power = 64;
constexpr unsigned most_trial_divisor = 1000;
constexpr long bits_of_finiteness = 256;

/// Thrown if there is no normal form here: then no proof is found.
struct NoNormalForm {};

struct Ratio {
    Polynomial over;
    Polynomial under;
};

Polynomial constant_polynomial(const Rational& q) {
    return q == 0 ? Polynomial{} : Polynomial{{{}, q}};
}
Ratio fraction_of(const Rational& q) {
    return {constant_polynomial(q), constant_polynomial(Rational(1))};
}

Polynomial sum_of(const Polynomial& x, const Polynomial& y, const Rational& factor) {
    Polynomial z = x;
    for (const auto& [m, c] : y) {
        Rational& at = z[m];
        at += c * factor;
        if (at == 0) {
            z.erase(m);
        }
    }
    return z;
}

/// Returns q if x = q y.
std::optional<Rational> constant_ratio(const Polynomial& x, const Polynomial& y) {
    if (x.empty()) {
        return Rational(0);
    }
    if (x.size() != y.size()) {
        return std::nullopt;
    }
    const Rational q = x.begin()->second / y.begin()->second;
    const bool same = std::equal(x.begin(), x.end(), y.begin(), [&](const auto& s, const auto& t) {
        return s.first == t.first && s.second == q * t.second;
    });
    return same ? std::optional(q) : std::nullopt;
}

class NormalForm {
public:
    [[nodiscard]] Ratio of(const Expr& e) {
        if (const Rational* q = e.rational()) {
            return fraction_of(*q);
        }
        switch (e.kind()) {
        case Expr::Kind::pi:
            return pi();
        case Expr::Kind::symbol:
            return alone(variable("symbol " + e.name(), false));
        case Expr::Kind::neg:
            return product(of(e.arg(0)), fraction_of(Rational(-1)));
        case Expr::Kind::add:
            return sum(of(e.arg(0)), of(e.arg(1)), 1);
        case Expr::Kind::sub:
            return sum(of(e.arg(0)), of(e.arg(1)), -1);
        case Expr::Kind::mul:
            return product(of(e.arg(0)), of(e.arg(1)));
        case Expr::Kind::div:
            return product(of(e.arg(0)), inverse(of(e.arg(1))));
        case Expr::Kind::pow: {
            const Rational* k = e.arg(1).rational();
            if (k != nullptr && abs(*k) <= most_power && denominator(*k) == 1) {
                return whole_power(of(e.arg(0)), k->convert_to<long>());
            }
            if (k != nullptr && abs(*k) <= most_power && denominator(*k) == 2) {
                return whole_power(root(of(e.arg(0))), Rational(*k * 2).convert_to<long>());
            }
            return alone(variable("power " + text(of(e.arg(0))) + text(of(e.arg(1))), false));
        }
        case Expr::Kind::call:
            return call(e);
        default:
            throw NoNormalForm{};
        }
    }

private:
    struct Variable {
        bool positive = false;            ///< proved to be positive
        std::optional<Polynomial> square; ///< the square, if the variable is a root
    };
    [[nodiscard]] std::size_t variable(const std::string& name, bool positive,
                                       std::optional<Polynomial> square = {}) {
        const auto [at, is_new] = numbers_.emplace(name, variables_.size());
        if (is_new) {
            variables_.push_back({positive, std::move(square)});
        }
        return at->second;
    }
    [[nodiscard]] static Ratio alone(std::size_t variable) {
        return {{{{{variable, 1}}, Rational(1)}}, constant_polynomial(Rational(1))};
    }
    [[nodiscard]] Polynomial product(const Polynomial& x, const Polynomial& y) const {
        if (x.size() * y.size() > most_terms * most_terms) {
            throw NoNormalForm{};
        }
        Polynomial z;
        for (const auto& [m, c] : x) {
            for (const auto& [n, d] : y) {
                Monomial powers = m;
                Polynomial squares = constant_polynomial(Rational(c * d));
                for (const auto& [v, k] : n) {
                    int& power = powers[v];
                    power += k;
                    if (power > most_power) {
                        throw NoNormalForm{};
                    }
                    if (variables_[v].square && power >= 2) {
                        power -= 2; // each factor contains it at most once
                        squares = product(squares, *variables_[v].square);
                    }
                    if (power == 0) {
                        powers.erase(v);
                    }
                }
                if (squares.size() == 1 && squares.begin()->first.empty()) {
                    z = sum_of(z, {{powers, squares.begin()->second}}, Rational(1));
                } else {
                    z = sum_of(z, product(squares, {{powers, Rational(1)}}), Rational(1));
                }
            }
        }
        if (z.size() > most_terms) {
            throw NoNormalForm{};
        }
        return z;
    }
    /// Replaces a constant ratio by a number, and cancels common powers of all terms.
    [[nodiscard]] Ratio reduced(Ratio f) const {
        if (const auto q = constant_ratio(f.over, f.under)) {
            return fraction_of(*q);
        }
        for (std::size_t v = 0; v < variables_.size(); ++v) {
            int shared = most_power;
            for (const Polynomial* p : {&f.over, &f.under}) {
                for (const auto& [m, c] : *p) {
                    const auto at = m.find(v);
                    shared = std::min(shared, at == m.end() ? 0 : at->second);
                }
            }
            if (shared == 0) {
                continue;
            }
            for (Polynomial* p : {&f.over, &f.under}) {
                Polynomial less;
                for (const auto& [m, c] : *p) {
                    Monomial n = m;
                    if ((n[v] -= shared) == 0) {
                        n.erase(v);
                    }
                    less[n] = c;
                }
                *p = std::move(less);
            }
        }
        const Rational leading = f.under.begin()->second;
        for (Polynomial* p : {&f.over, &f.under}) {
            for (auto& [m, c] : *p) {
                c /= leading;
            }
        }
        return f;
    }
    [[nodiscard]] Ratio sum(const Ratio& x, const Ratio& y, int sign) const {
        if (x.under == y.under) {
            return reduced({sum_of(x.over, y.over, Rational(sign)), x.under});
        }
        return reduced({sum_of(product(x.over, y.under), product(y.over, x.under), Rational(sign)),
                        product(x.under, y.under)});
    }
    [[nodiscard]] Ratio product(const Ratio& x, const Ratio& y) const {
        return reduced({product(x.over, y.over), product(x.under, y.under)});
    }
    [[nodiscard]] static Ratio inverse(const Ratio& x) {
        if (x.over.empty()) {
            throw NoNormalForm{};
        }
        return {x.under, x.over};
    }
    [[nodiscard]] Ratio whole_power(const Ratio& x, long k) const {
        if (k < 0) {
            return whole_power(inverse(x), -k);
        }
        if (k > most_power) {
            throw NoNormalForm{};
        }
        Ratio y = fraction_of(Rational(1));
        for (long i = 0; i < k; ++i) {
            y = product(y, x);
        }
        return y;
    }
    /// The root of n/d = n d/d^2, as roots of primes and of the part without small prime factors.
    [[nodiscard]] Ratio root_of_rational(const Rational& q) {
        if (q < 0) {
            throw NoNormalForm{};
        }
        if (q == 0) {
            return fraction_of(q);
        }
        Integer rest = numerator(q) * denominator(q);
        Integer outside = 1;
        Ratio y = fraction_of(Rational(1));
        const auto with_root = [&](const Integer& p) {
            y = product(y,
                        alone(variable("sqrt " + p.str(), true, constant_polynomial(Rational(p)))));
        };
        for (unsigned p = 2; p < most_trial_divisor; ++p) {
            while (rest % (p * p) == 0) {
                rest /= p * p;
                outside *= p;
            }
            if (rest % p == 0) {
                rest /= p;
                with_root(Integer(p));
            }
        }
        const Integer whole = sqrt(rest);
        if (whole * whole == rest) {
            outside *= whole;
        } else {
            with_root(rest);
        }
        return product(y, fraction_of(Rational(outside, denominator(q))));
    }
    [[nodiscard]] Ratio root(const Ratio& x) {
        if (x.over.empty()) {
            return x;
        }
        const Ratio f = reduced(x);
        const auto monomial = [](const Polynomial& p) { return p.size() == 1; };
        if (monomial(f.over) && monomial(f.under)) {
            // The root of a product: even powers of positive factors are extracted.
            Rational number = f.over.begin()->second / f.under.begin()->second;
            Ratio outside = fraction_of(Rational(1));
            Ratio inside = outside;
            for (const Polynomial* p : {&f.over, &f.under}) {
                for (const auto& [v, k] : p->begin()->first) {
                    const Ratio factor = p == &f.over ? alone(v) : inverse(alone(v));
                    if (!variables_[v].positive) {
                        inside = product(inside, whole_power(factor, k));
                        continue;
                    }
                    outside = product(outside, whole_power(factor, k / 2));
                    inside = product(inside, whole_power(factor, k % 2));
                }
            }
            outside = product(outside, root_of_rational(number));
            if (constant_ratio(inside.over, inside.under) == Rational(1)) {
                return outside;
            }
            return product(outside, alone(variable("root " + text(inside), true)));
        }
        const bool whole = f.under.size() == 1 && f.under.begin()->first.empty();
        return alone(
            variable("root " + text(f), true, whole ? std::optional(f.over) : std::nullopt));
    }
    [[nodiscard]] Ratio arc_cosine(const Ratio& x) {
        const Ratio f = reduced(x);
        const bool negative = !f.over.empty() && f.over.begin()->second < 0;
        if (negative) {
            return sum(pi(), arc_cosine(product(f, fraction_of(Rational(-1)))), -1);
        }
        const Ratio squared = product(f, f);
        if (const auto square = constant_ratio(squared.over, squared.under)) {
            if (const auto part = part_of_pi(*square)) {
                return product(pi(), fraction_of(*part));
            }
        }
        return alone(variable("acos " + text(f), true));
    }
    [[nodiscard]] Ratio call(const Expr& e) {
        std::vector<Ratio> args;
        for (const Expr& arg : e.args()) {
            args.push_back(of(arg));
        }
        if (e.builtin() == Builtin::sqrt) {
            return root(args[0]);
        }
        if (e.builtin() == Builtin::acos) {
            return arc_cosine(args[0]);
        }
        if (e.builtin() == Builtin::abs || e.builtin() == Builtin::log) {
            if (const auto q = constant_ratio(args[0].over, args[0].under)) {
                if (e.builtin() == Builtin::abs) {
                    return fraction_of(abs(*q));
                }
                if (*q == 1) {
                    return fraction_of(Rational(0));
                }
            }
        }
        std::string name = "call " + e.name();
        for (const Ratio& arg : args) {
            name += " " + text(arg);
        }
        return alone(variable(name, false));
    }
    [[nodiscard]] static std::string text(const Polynomial& p) {
        std::string all = "(";
        for (const auto& [m, c] : p) {
            all += c.str();
            for (const auto& [v, k] : m) {
                all += " v" + std::to_string(v) + "^" + std::to_string(k);
            }
            all += ";";
        }
        return all + ")";
    }
    [[nodiscard]] static std::string text(const Ratio& f) {
        return text(f.over) + "/" + text(f.under);
    }
    [[nodiscard]] Ratio pi() { return alone(variable("pi", true)); }

    std::map<std::string, std::size_t> numbers_;
    std::vector<Variable> variables_;
};

} // namespace

bool proved_zero(const Expr& e) {
    try {
        if (!NormalForm().of(e).over.empty()) {
            return false;
        }
        return !free_symbols(e).empty() || enclose(e, bits_of_finiteness).has_value();
    } catch (const NoNormalForm&) {
        return false;
    } catch (const Error&) {
        return false; // no value, or a tree that is too high
    }
}

std::optional<int> decided_sign(const Expr& e, long bits) {
    if (const Rational* q = e.rational()) {
        return q->sign();
    }
    bool tried = false;
    for (long k = 128; k <= bits; k *= 4) {
        try {
            if (const auto x = enclose(e, k)) {
                if (certainly_positive(*x) || certainly_negative(*x)) {
                    return x->midpoint().sign();
                }
            }
        } catch (const Error&) {
            return std::nullopt;
        }
        if (!std::exchange(tried, true) && proved_zero(e)) {
            return 0;
        }
    }
    return std::nullopt;
}

} // namespace edgeproof::formula

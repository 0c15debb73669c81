// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"

#include "edgeproof/formula/fold.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <numeric>

namespace edgeproof::algebra {
namespace {

using Kind = Generator::Kind;

constexpr unsigned least_unlikely_prime = 1000;

[[noreturn]] void refuse_power() {
    throw Error("a power beyond " + std::to_string(Form::most_power) +
                " is not worked out by symbols");
}

Form whole_power(const Form& x, const Integer& n) {
    if (abs(n) > Form::most_power) {
        refuse_power();
    }
    if (n < 0) {
        return Form(1) / whole_power(x, -n);
    }
    Form y(1);
    Form square = x;
    for (auto k = n.convert_to<unsigned>(); k != 0; k >>= 1U) {
        if ((k & 1U) != 0) {
            y *= square;
        }
        if (k > 1) {
            square *= square;
        }
    }
    return y;
}

} // namespace

/// A factor whose powers are defined by themselves: it is positive wherever the whole power is.
struct Form::Part {
    Form base;
    Rational exponent;
};

/// Writes a base as a product of such parts. The product of the factors of unknown sign is one
/// part; its exponent is odd, because x^3 > 0 only if x > 0, but x^2 > 0 also for x < 0.
std::vector<Form::Part> Form::parts() const {
    std::vector<Part> all;
    std::vector<std::pair<Form, long>> unknown;
    int sign = 1;
    for (const bool above : {true, false}) {
        const auto [constant, powers] = (above ? over_ : under_).factors();
        sign *= constant.sign();
        Integer rest = abs(constant);
        const auto add_number = [&](const Integer& n, long k) {
            all.push_back({Form(Rational(n)), Rational(above ? k : -k)});
        };
        for (unsigned p = 2; p < least_unlikely_prime && rest > 1; ++p) {
            long k = 0;
            for (; rest % p == 0; ++k) {
                rest /= p;
            }
            if (k > 0) {
                add_number(Integer(p), k);
            }
        }
        // The prime factors of the rest have more than 9 bits.
        for (auto k = rest > 1 ? std::clamp(msb(rest) / 9, 1UL, 64UL) : 0; k > 0; --k) {
            if (const auto root = formula::exact_root(Rational(rest), k)) {
                add_number(Integer(numerator(*root)), static_cast<long>(k));
                break;
            }
        }
        for (const auto& [p, power] : powers) {
            const Form factor = canonical(generators_, p, Polynomial(generators_.size(), 1));
            const long k = above ? static_cast<long>(power) : -static_cast<long>(power);
            if (const int s = factor.sign(); s == 0) {
                unknown.emplace_back(factor, k);
            } else {
                all.push_back({s > 0 ? factor : -factor, Rational(k)});
                sign = s < 0 && k % 2 != 0 ? -sign : sign;
            }
        }
    }
    long common = 0;
    for (const auto& [factor, k] : unknown) {
        common = std::gcd(common, k);
    }
    if (unknown.empty()) {
        return sign > 0 ? all : throw DomainError("a power of a negative number");
    }
    // The first factor has a positive exponent, so that x/y and y/x become one part.
    std::ranges::sort(unknown, {}, [](const auto& factor) { return factor.first.key(); });
    common = common % 2 == 0 ? 1 : common;
    common = unknown[0].second > 0 ? common : -common;
    Form rest(sign);
    for (const auto& [factor, k] : unknown) {
        rest *= whole_power(factor, k / common);
    }
    all.push_back({std::move(rest), Rational(common)});
    return all;
}

/// base^exponent for a part.
Form Form::root(const Form& base, const Rational& exponent) {
    const Integer index(denominator(exponent));
    if (index == 1) {
        return whole_power(base, Integer(numerator(exponent)));
    }
    if (const Generator* g = base.generator(); g != nullptr && g->kind == Kind::root) {
        return root(g->parts[0], exponent / g->index);
    }
    if (base == Form(1)) {
        return {1};
    }
    if (index > Form::most_power) {
        refuse_power();
    }
    Integer whole = numerator(exponent) / index;
    if (whole * index > numerator(exponent)) {
        --whole;
    }
    const Form w(Generator{Kind::root,
                           "root " + base.key(),
                           "",
                           {base},
                           index.convert_to<unsigned long>(),
                           true,
                           0,
                           {}});
    return whole_power(base, whole) * whole_power(w, numerator(exponent) - whole * index);
}

Form pow(const Form& x, const Rational& q) {
    if (denominator(q) == 1) {
        return whole_power(x, Integer(numerator(q)));
    }
    if (x.is_zero()) {
        return q > 0 ? Form() : throw DomainError("division by zero");
    }
    Form y(1);
    for (const Form::Part& part : x.parts()) {
        y *= Form::root(part.base, part.exponent * q);
    }
    return y;
}

/// The terms of a sum, each as a rational number and a product without one.
std::vector<std::pair<Rational, Form>> Form::terms() const {
    std::vector<std::pair<Rational, Form>> all;
    const Integer common = under_.content();
    const Form over_number = Form(Rational(common));
    over_.for_each_term([&](const Integer& c, const Exponents& e) {
        const Polynomial monomial =
            Polynomial(generators_.size(), 1).with_exponents(generators_.size(), [&](const auto&) {
                return e;
            });
        all.emplace_back(Rational(c, common),
                         canonical(generators_, monomial, under_) * over_number);
    });
    return all;
}

/// base^exponent for a part, or exp(exponent) for the base 0; the exponent is one of `terms`.
Form Form::power(const Form& base, const Form& exponent) {
    if (const Generator* g = base.generator(); g != nullptr) {
        if (g->kind == Kind::root) {
            return pow(g->parts[0], exponent / Form(Rational(g->index)));
        }
        if (g->kind == Kind::power && g->parts.size() == 2) {
            return pow(g->parts[0], exponent * g->parts[1]);
        }
    }
    const bool exponential = base.is_zero();
    return Form(Generator{Kind::power,
                          "power " + base.key() + "^" + exponent.key(),
                          "",
                          exponential ? std::vector{exponent} : std::vector{base, exponent},
                          1,
                          true,
                          0,
                          {}});
}

Form pow(const Form& x, const Form& y) {
    if (const auto q = y.rational()) {
        return pow(x, *q);
    }
    if (x.is_zero()) {
        throw Error("zero to a power that is not a number");
    }
    Form product(1);
    for (const Form::Part& part : x.parts()) {
        for (const auto& [number, term] : (y * Form(part.exponent)).terms()) {
            product *= term == Form(1) ? Form::root(part.base, number)
                                       : Form::root(Form::power(part.base, term), number);
        }
    }
    return product;
}

Form exp(const Form& x) {
    Form product(1);
    for (const auto& [number, term] : x.terms()) {
        const Generator* g = term.generator();
        const bool log = g != nullptr && g->kind == Kind::call && g->name == "log";
        product *= log ? pow(g->parts[0], number) : Form::root(Form::power(Form(), term), number);
    }
    return product;
}

} // namespace edgeproof::algebra

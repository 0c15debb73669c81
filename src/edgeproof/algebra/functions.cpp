// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <map>

namespace edgeproof::algebra {

using Kind = Generator::Kind;

namespace {

/// Returns h/pi for the angle h, 0 <= h <= pi/2, whose cosine has this square, if it is one of the
/// five with a rational square (DLMF table 4.17.1).
std::optional<Rational> part_of_pi(const std::optional<Rational>& square_of_cosine) {
    static const std::map<Rational, Rational> table{{0, Rational(1, 2)},
                                                    {Rational(1, 4), Rational(1, 3)},
                                                    {Rational(1, 2), Rational(1, 4)},
                                                    {Rational(3, 4), Rational(1, 6)},
                                                    {1, 0}};
    const auto known = square_of_cosine ? table.find(*square_of_cosine) : table.end();
    return known == table.end() ? std::nullopt : std::optional(known->second);
}

/// Returns cos(pi q), if it is simple.
std::optional<Form> cosine(Rational q) {
    q = abs(q);
    q -= Rational(Integer(numerator(q) / denominator(q)) / 2 * 2); // of the period 2
    const bool turned = q > Rational(1, 2) && q < Rational(3, 2);
    const Rational h = q > Rational(3, 2) ? Rational(2 - q)
                       : turned           ? Rational(abs(Rational(1 - q)))
                                          : q;
    for (const int square : {0, 1, 2, 3, 4}) {
        if (part_of_pi(Rational(square, 4)) == h) {
            const Form size = sqrt(Form(Rational(square, 4)));
            return turned ? -size : size;
        }
    }
    return {};
}

/// Returns the angle between 0 and pi with this cosine, if it is a multiple of pi/12, found from
/// the cosine or from the cosine of twice the angle.
std::optional<Form> angle(const Form& cosine) {
    const Form square = cosine * cosine;
    if (const auto part = part_of_pi(square.rational())) {
        return Form::pi() * Form(cosine.sign() < 0 ? Rational(1 - *part) : *part);
    }
    const Form twice = 2 * square - 1;
    const auto part = part_of_pi(Form(twice * twice).rational());
    const auto sign = part ? decided_sign(cosine.expr()) : std::nullopt;
    if (!sign) {
        return {};
    }
    const Rational half = (twice.sign() < 0 ? Rational(1 - *part) : *part) / 2;
    return Form::pi() * Form(*sign < 0 ? Rational(1 - half) : half);
}

/// Returns gamma(q) for a positive q that is a whole number or a half more.
std::optional<Form> factorial(Rational q) {
    if (q > Form::most_power) {
        throw Error("gamma of a number beyond " + std::to_string(Form::most_power) +
                    " is not worked out by symbols");
    }
    if (q <= 0 || denominator(q) > 2) {
        return {};
    }
    Rational product(1);
    for (; q > 1; product *= q) {
        q -= 1;
    }
    return Form(product) * (q == 1 ? Form(1) : sqrt(Form::pi()));
}

bool is_inverse(Builtin f, std::string_view of) {
    return (f == Builtin::sin && of == "asin") || (f == Builtin::cos && of == "acos") ||
           (f == Builtin::tan && of == "atan");
}

enum class Parity { even, odd, none };
Parity parity(Builtin f) {
    using enum Builtin;
    static constexpr Builtin even[] = {cos, cosh, abs};
    static constexpr Builtin odd[] = {sin, tan, asin, atan, sinh, tanh, asinh, atanh, sgn};
    return std::ranges::find(even, f) != std::end(even) ? Parity::even
           : std::ranges::find(odd, f) != std::end(odd) ? Parity::odd
                                                        : Parity::none;
}

} // namespace

std::optional<Form> Form::exponent() const {
    if (over_.size() != 1 || under_.size() != 1 || over_.leading() != 1 || under_.leading() != 1) {
        return {};
    }
    Form sum;
    for (std::size_t i = 0; i < generators_.size(); ++i) {
        const Generator& g = *generators_[i];
        const Generator* e = g.kind == Kind::root ? g.parts[0].generator() : &g;
        if (e == nullptr || e->kind != Kind::power || e->parts.size() != 1) {
            return {};
        }
        const long k = static_cast<long>(over_.degree(i)) - static_cast<long>(under_.degree(i));
        sum += e->parts[0] * Form(Rational(k, g.index));
    }
    return sum;
}

std::optional<Form> Form::special(Builtin f, const Form& x) {
    const auto q = x.rational();
    const auto angle_in_pi = [&] { return (x / pi()).rational(); };
    const auto from_right_angle = [](const std::optional<Form>& h) {
        return h ? std::optional(pi() / Form(2) - *h) : std::nullopt;
    };
    if (const Generator* g = x.generator(); g != nullptr && is_inverse(f, g->name)) {
        return g->parts[0];
    }
    switch (f) {
    case Builtin::sqrt:
        return pow(x, Rational(1, 2));
    case Builtin::exp:
        return exp(x);
    case Builtin::log:
        return q && *q > 0 && *q < 1 ? std::optional(-log(Form(1 / *q))) : x.exponent();
    case Builtin::gamma:
        return q ? factorial(*q) : std::nullopt;
    case Builtin::abs:
        return x.is_zero() || x.sign() > 0 ? std::optional(x) : std::nullopt;
    case Builtin::sgn:
        return x.is_zero()     ? std::optional(x)
               : x.sign() != 0 ? std::optional(Form(x.sign()))
                               : std::nullopt;
    case Builtin::acos:
        return angle(x);
    case Builtin::asin:
        return from_right_angle(angle(x));
    case Builtin::atan: { // cos^2 = 1/(1 + tan^2)
        const auto square = Form(x * x).rational();
        return square ? angle(sqrt(Form(1 / (1 + *square)))) : std::nullopt;
    }
    case Builtin::cos: {
        const auto h = angle_in_pi();
        return h ? cosine(*h) : std::nullopt;
    }
    case Builtin::sin: {
        const auto h = angle_in_pi();
        return h ? cosine(*h - Rational(1, 2)) : std::nullopt;
    }
    case Builtin::tan: {
        const auto over = special(Builtin::sin, x);
        const auto under = special(Builtin::cos, x);
        return over && under && !under->is_zero() ? std::optional(*over / *under) : std::nullopt;
    }
    case Builtin::sinh:
    case Builtin::tanh:
        return x.is_zero() ? std::optional(x) : std::nullopt;
    case Builtin::cosh:
        return x.is_zero() ? std::optional(Form(1)) : std::nullopt;
    default:
        return {};
    }
}

Form Form::call(Builtin f, std::span<const Form> x) {
    const bool one = x.size() == 1;
    const bool with_parity = f == Builtin::acos || parity(f) != Parity::none;
    if (one && with_parity && x[0].expr().kind() == Expr::Kind::neg) {
        const Form opposite = -x[0];
        const Form y = call(f, {&opposite, 1});
        return f == Builtin::acos ? pi() - y : parity(f) == Parity::even ? y : -y;
    }
    if (auto y = one ? special(f, x[0]) : std::nullopt) {
        return *std::move(y);
    }
    return call(std::string(name_of(f)), x);
}

Form Form::call(const std::string& function, std::span<const Form> x) {
    std::string key = function;
    for (const Form& part : x) {
        key += " " + part.key();
    }
    return Form(
        Generator{Kind::call, std::move(key), function, {x.begin(), x.end()}, 1, false, 0, {}});
}

namespace {

Form rate_of_call(const Generator& g, std::string_view name) {
    if (!g.holds(name)) {
        return {};
    }
    const auto builtin = formula::find_builtin(g.name);
    if (builtin && g.parts.size() == 1) {
        const Form& x = g.parts[0];
        const Form inner = x.derivative(name);
        switch (builtin->id) {
        case Builtin::log:
            return inner / x;
        case Builtin::sin:
            return cos(x) * inner;
        case Builtin::cos:
            return -sin(x) * inner;
        case Builtin::tan:
            return inner / (cos(x) * cos(x));
        case Builtin::asin:
            return inner / sqrt(1 - x * x);
        case Builtin::acos:
            return -inner / sqrt(1 - x * x);
        case Builtin::atan:
            return inner / (1 + x * x);
        default:
            break;
        }
    }
    throw Error("no derivative by " + std::string(name) +
                " in symbols: " + (g.expr ? to_text(*g.expr) : g.name));
}

} // namespace

Form Form::derivative(std::string_view name) const {
    const Polynomial one(generators_.size(), 1);
    Form over;  // the derivative of the numerator
    Form under; // and of the denominator
    for (std::size_t i = 0; i < generators_.size(); ++i) {
        const Generator& g = *generators_[i];
        const Form self({generators_[i]}, Polynomial::variable(1, 0), Polynomial(1, 1));
        Form rate;
        if (g.kind == Kind::name) {
            rate = g.name == name ? 1 : 0;
        } else if (g.kind == Kind::root) {
            rate = self * g.parts[0].derivative(name) / (g.parts[0] * Form(Rational(g.index)));
        } else if (g.kind == Kind::power) {
            const Form& exponent = g.parts.back();
            rate = exponent.derivative(name);
            if (g.parts.size() == 2) {
                const Form& base = g.parts[0];
                const Form of_base = base.derivative(name);
                rate = (rate.is_zero() ? Form() : rate * log(base)) + exponent * of_base / base;
            }
            rate *= self;
        } else {
            rate = rate_of_call(g, name);
        }
        if (!rate.is_zero()) {
            over += canonical(generators_, over_.derivative(i), one) * rate;
            under += canonical(generators_, under_.derivative(i), one) * rate;
        }
    }
    return (over - *this * under) / canonical(generators_, under_, one);
}

} // namespace edgeproof::algebra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/expr.hpp"

#include <algorithm>

namespace edgeproof::formula {
namespace {

using Kind = Expr::Kind;

enum Precedence { additive = 1, multiplicative = 2, sign = 3, power = 4, atom = 5 };

Precedence precedence(Kind kind) {
    switch (kind) {
    case Kind::add:
    case Kind::sub:
        return additive;
    case Kind::mul:
    case Kind::div:
        return multiplicative;
    case Kind::neg:
        return sign;
    case Kind::pow:
        return power;
    default:
        return atom;
    }
}

/// A terminating decimal q >= 0 as digits and a power of ten: q = digits * 10^exponent. The last
/// digit is not 0, unless the digits are "0".
struct Decimal {
    std::string digits;
    long exponent;
};

Decimal decimal_of(const Rational& q) {
    std::string digits;
    long exponent = 0;
    const auto* const whole = mpq_numref(q.backend().data());
    if (Integer d(denominator(q)); d == 1) {
        digits = mpz_fits_ulong_p(whole) != 0 ? std::to_string(mpz_get_ui(whole))
                                              : Integer(numerator(q)).str();
    } else {
        const Integer five(5);
        Integer rest;
        const auto twos = mpz_scan1(d.backend().data(), 0);
        mpz_tdiv_q_2exp(rest.backend().data(), d.backend().data(), twos);
        const auto fives =
            mpz_remove(rest.backend().data(), rest.backend().data(), five.backend().data());
        const auto places = std::max(twos, fives);
        Integer scale;
        mpz_ui_pow_ui(scale.backend().data(), 10, places);
        digits = Integer(numerator(q) * (scale / d)).str();
        exponent = -static_cast<long>(places);
    }
    const std::size_t last = digits.find_last_not_of('0');
    if (last != std::string::npos) {
        exponent += static_cast<long>(digits.size() - last - 1);
        digits.resize(last + 1);
    } else {
        exponent = 0;
    }
    return {std::move(digits), exponent};
}

/// Returns a number as text: plain if that is short, else as 1.25e-30.
std::string number_text(const Rational& q) {
    constexpr long most_zeros_behind = 6;
    constexpr long most_zeros_before = 4;
    const auto [digits, exponent] = decimal_of(q);
    const long size = static_cast<long>(digits.size());
    const long point = size + exponent; // digits before the decimal point
    const auto zeros = [](long n) { return std::string(static_cast<std::size_t>(n), '0'); };
    const auto with_point = [&digits = digits](long at) {
        const auto n = static_cast<std::size_t>(at);
        return n < digits.size() ? digits.substr(0, n) + '.' + digits.substr(n) : digits;
    };
    if (exponent >= 0 && exponent <= most_zeros_behind) {
        return digits + zeros(exponent);
    }
    if (exponent < 0 && point > 0) {
        return with_point(point);
    }
    if (exponent < 0 && -point <= most_zeros_before) {
        return "0." + zeros(-point) + digits;
    }
    return with_point(1) + 'e' + std::to_string(point - 1);
}

class TextPrinter {
public:
    std::string operator()(const Expr& e) const {
        switch (e.kind()) {
        case Kind::number:
            return number_text(e.number());
        case Kind::pi:
            return "Pi";
        case Kind::symbol:
            return e.name();
        case Kind::neg:
            // "-(-x)": these parentheses are for the reader; the tree does not need them.
            return '-' + wrapped(e.arg(0), e.arg(0).kind() == Kind::neg ? power : sign);
        case Kind::add:
            return infix(e, " + ", additive, multiplicative);
        case Kind::sub:
            return infix(e, " - ", additive, multiplicative);
        case Kind::mul:
            return infix(e, "*", multiplicative, sign);
        case Kind::div:
            return infix(e, "/", multiplicative, sign);
        case Kind::pow:
            return infix(e, "^", atom, power);
        default:
            return call(e);
        }
    }

private:
    std::string wrapped(const Expr& e, Precedence least) const {
        const std::string text = (*this)(e);
        return precedence(e.kind()) < least ? '(' + text + ')' : text;
    }
    std::string infix(const Expr& e, const char* op, Precedence left, Precedence right) const {
        const Expr& second = e.arg(1);
        return wrapped(e.arg(0), left) + op +
               wrapped(second, second.kind() == Kind::neg ? power : right);
    }
    std::string call(const Expr& e) const {
        std::string text = e.name() + '(';
        for (std::size_t i = 0; i < e.args().size(); ++i) {
            text += (i == 0 ? "" : ", ") + (*this)(e.args()[i]);
        }
        return text + ')';
    }
};

} // namespace

std::string to_text(const Expr& e) { return TextPrinter()(e); }

} // namespace edgeproof::formula

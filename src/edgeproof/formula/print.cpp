// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/expr.hpp"

#include <algorithm>
#include <array>
#include <cctype>

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

/// A terminating decimal q >= 0 as digits and a power of ten: q = digits * 10^exponent, the digits
/// ending in none of 0 unless they are "0".
struct Decimal {
    std::string digits;
    long exponent;
};

Decimal decimal_of(const Rational& q) {
    std::string digits;
    long exponent = 0;
    if (Integer d(denominator(q)); d == 1) {
        digits = Integer(numerator(q)).str();
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

/// How a number is written: plainly where that is short, as 1.25e-30 otherwise.
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
            // "-(-x)": the tree does not need these parentheses, the eye does.
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

std::string symbol_tex(std::string_view name) {
    static constexpr std::array greek{
        "alpha", "beta",  "gamma", "delta",  "epsilon", "zeta", "eta", "theta", "kappa", "lambda",
        "mu",    "nu",    "xi",    "rho",    "sigma",   "tau",  "phi", "chi",   "psi",   "omega",
        "Gamma", "Delta", "Theta", "Lambda", "Sigma",   "Phi",  "Psi", "Omega", "varphi"};
    std::size_t stem = name.size();
    while (stem > 0 && std::isdigit(static_cast<unsigned char>(name[stem - 1])) != 0) {
        --stem;
    }
    std::string subscript(name.substr(stem));
    std::string base(name.substr(0, stem));
    if (const std::size_t bar = base.find('_'); bar != std::string::npos && bar > 0) {
        subscript = base.substr(bar + 1) + subscript;
        std::erase(subscript, '_');
        base.resize(bar);
    }
    if (std::ranges::find(greek, base) != greek.end()) {
        base = '\\' + base;
    } else if (base.size() > 1) {
        std::string escaped;
        for (const char c : base) {
            escaped += c == '_' ? std::string("\\_") : std::string(1, c);
        }
        base = "\\mathrm{" + escaped + '}';
    }
    return subscript.empty() ? base : base + "_{" + subscript + '}';
}

class TexPrinter {
public:
    explicit TexPrinter(const std::function<std::string(std::string_view)>& symbol)
        : symbol_(symbol) {}

    std::string operator()(const Expr& e) const {
        switch (e.kind()) {
        case Kind::number:
            return number(e.number());
        case Kind::pi:
            return "\\pi";
        case Kind::symbol:
            return name(e.name());
        case Kind::neg:
            return '-' + wrapped(e.arg(0), e.arg(0).kind() == Kind::neg ? power : multiplicative);
        case Kind::add:
            return infix(e, " + ", additive, multiplicative);
        case Kind::sub:
            return infix(e, " - ", additive, multiplicative);
        case Kind::mul:
            return infix(e, product_sign(e), multiplicative, multiplicative);
        case Kind::div:
            return "\\frac{" + (*this)(e.arg(0)) + "}{" + (*this)(e.arg(1)) + '}';
        case Kind::pow:
            return power_tex(e);
        case Kind::call:
            return call(e);
        case Kind::integral:
            return binder("\\int", "", e);
        case Kind::pv:
            return binder("\\mathrm{p.v.}\\!\\!\\int", "", e);
        case Kind::sum:
            return binder("\\sum", e.arg(1).name(), e);
        }
        return {};
    }

private:
    std::string name(std::string_view n) const { return symbol_ ? symbol_(n) : symbol_tex(n); }

    static std::string number(const Rational& q) {
        std::string text = number_text(q);
        if (const std::size_t e = text.find('e'); e != std::string::npos) {
            const std::string power = "10^{" + text.substr(e + 1) + '}';
            text = text.substr(0, e) == "1" ? power : text.substr(0, e) + "\\cdot " + power;
        }
        return text;
    }
    static const char* product_sign(const Expr& e) {
        // Two numbers side by side would read as one.
        const Expr* right = &e.arg(1);
        while (right->kind() == Kind::pow || right->kind() == Kind::mul) {
            right = &right->arg(0);
        }
        return right->kind() == Kind::number || right->kind() == Kind::div ? " \\cdot " : " ";
    }
    static std::string parentheses(const std::string& text) {
        return "\\left(" + text + "\\right)";
    }
    std::string wrapped(const Expr& e, Precedence least) const {
        const std::string text = (*this)(e);
        // A fraction is set as one block, whatever its precedence in a line of text.
        const Precedence own = e.kind() == Kind::div ? sign : precedence(e.kind());
        return own < least ? parentheses(text) : text;
    }
    std::string infix(const Expr& e, const char* op, Precedence left, Precedence right) const {
        const Expr& second = e.arg(1);
        return wrapped(e.arg(0), left) + op +
               wrapped(second, second.kind() == Kind::neg ? power : right);
    }
    std::string power_tex(const Expr& e) const {
        const Expr& base = e.arg(0);
        const bool bare =
            base.kind() == Kind::symbol || base.kind() == Kind::pi ||
            (base.kind() == Kind::number && number(base.number()).find('e') == std::string::npos);
        std::string text = (*this)(base);
        // A name with a subscript or prime takes braces; a number with a power of ten, brackets.
        if (!bare || text.find("\\cdot") != std::string::npos ||
            text.find('^') != std::string::npos) {
            text = parentheses(text);
        }
        return '{' + text + "}^{" + exponent(e.arg(1)) + '}';
    }
    /// Exponents stay on one line: 3/2, not a built-up fraction.
    std::string exponent(const Expr& e) const {
        if (e.kind() == Kind::div) {
            return wrapped(e.arg(0), multiplicative) + '/' + wrapped(e.arg(1), power);
        }
        return (*this)(e);
    }
    std::string call(const Expr& e) const {
        static constexpr std::array upright{"exp",  "sin",  "cos", "tan", "sinh",
                                            "cosh", "tanh", "max", "min"};
        switch (e.builtin()) {
        case Builtin::sqrt:
            return "\\sqrt{" + (*this)(e.arg(0)) + '}';
        case Builtin::abs:
            return "\\left|" + (*this)(e.arg(0)) + "\\right|";
        case Builtin::log:
            return "\\ln" + parentheses((*this)(e.arg(0)));
        case Builtin::gamma:
            return "\\Gamma" + parentheses((*this)(e.arg(0)));
        case Builtin::asin:
        case Builtin::acos:
        case Builtin::atan:
            return "\\arc" + e.name().substr(1) + parentheses((*this)(e.arg(0)));
        default:
            break;
        }
        std::string head;
        if (e.builtin() == Builtin::none) {
            head = name(e.name());
        } else if (std::ranges::find(upright, e.name()) != upright.end()) {
            head = '\\' + e.name();
        } else {
            head = "\\operatorname{" + e.name() + '}';
        }
        std::string list;
        for (std::size_t i = 0; i < e.args().size(); ++i) {
            list += (i == 0 ? "" : ", ") + (*this)(e.args()[i]);
        }
        return head + parentheses(list);
    }
    std::string binder(const std::string& sign_of, const std::string& index, const Expr& e) const {
        const std::string lower =
            index.empty() ? (*this)(e.arg(2)) : name(index) + " = " + (*this)(e.arg(2));
        const std::string body = wrapped(e.arg(0), multiplicative);
        const std::string tail = index.empty() ? " \\,\\mathrm{d}" + name(e.arg(1).name()) : "";
        return "{" + sign_of + "_{" + lower + "}^{" + (*this)(e.arg(3)) + "} " + body + tail + '}';
    }

    const std::function<std::string(std::string_view)>& symbol_;
};

} // namespace

std::string to_text(const Expr& e) { return TextPrinter()(e); }

std::string to_tex(const Expr& e, const std::function<std::string(std::string_view)>& symbol) {
    return TexPrinter(symbol)(e);
}

} // namespace edgeproof::formula

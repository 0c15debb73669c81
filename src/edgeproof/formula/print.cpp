// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/rounding/text.hpp"

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

/// Returns a number as text: plain if that is short, else as 1.25e-30.
std::string number_text(const Rational& q) {
    constexpr long most_zeros_behind = 6;
    constexpr long most_zeros_before = 4;
    const auto [negative, digits, point] = terminating_decimal(q).value();
    const long zeros_behind = point - static_cast<long>(digits.size());
    if (zeros_behind >= 0 ? zeros_behind <= most_zeros_behind : -point <= most_zeros_before) {
        return exact_text(q);
    }
    return digits.substr(0, 1) + (digits.size() > 1 ? '.' + digits.substr(1) : "") + 'e' +
           std::to_string(point - 1);
}

std::string wrapped(const Expr& e, Precedence least) {
    const std::string text = to_text(e);
    return precedence(e.kind()) < least ? '(' + text + ')' : text;
}

std::string infix(const Expr& e, const char* op, Precedence left, Precedence right) {
    const Expr& second = e.arg(1);
    return wrapped(e.arg(0), left) + op +
           wrapped(second, second.kind() == Kind::neg ? power : right);
}

} // namespace

std::string to_text(const Expr& e) {
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
        break;
    }
    std::string text = e.name() + '(';
    for (std::size_t i = 0; i < e.args().size(); ++i) {
        text += (i == 0 ? "" : ", ") + to_text(e.args()[i]);
    }
    return text + ')';
}

} // namespace edgeproof::formula

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/parity.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::formula {
namespace {

Parity of_sum(Parity x, Parity y) { return x == y ? x : Parity::undecided; }

Parity of_product(Parity x, Parity y) {
    if (x == Parity::undecided || y == Parity::undecided) {
        return Parity::undecided;
    }
    return x == y ? Parity::even : Parity::odd;
}

/// The parity of a power of an odd base; the exponent, without x, must be an integer.
Parity of_power(const Expr& exponent) {
    const Rational* q = exponent.rational();
    if (q == nullptr || boost::multiprecision::denominator(*q) != 1) {
        return Parity::undecided;
    }
    return boost::multiprecision::numerator(*q) % 2 == 0 ? Parity::even : Parity::odd;
}

/// The parity of a built-in function of one odd argument.
Parity of_odd_argument(Builtin f) {
    using enum Builtin;
    static constexpr std::array even_functions{cos, cosh, abs};
    static constexpr std::array odd_functions{sin, tan, asin, atan, sinh, tanh, asinh, atanh, sgn};
    return std::ranges::find(even_functions, f) != even_functions.end() ? Parity::even
           : std::ranges::find(odd_functions, f) != odd_functions.end() ? Parity::odd
                                                                        : Parity::undecided;
}

} // namespace

Parity parity(const Expr& e, std::string_view variable) {
    using Kind = Expr::Kind;
    const auto part = [&](std::size_t i) { return parity(e.arg(i), variable); };
    switch (e.kind()) {
    case Kind::number:
    case Kind::pi:
        return Parity::even;
    case Kind::symbol:
        return e.name() == variable ? Parity::odd : Parity::even;
    case Kind::neg:
        return part(0);
    case Kind::add:
    case Kind::sub:
        return of_sum(part(0), part(1));
    case Kind::mul:
    case Kind::div:
        return of_product(part(0), part(1));
    case Kind::pow:
    case Kind::call: {
        const Parity first = part(0);
        for (std::size_t i = 1; i < e.args().size(); ++i) {
            if (part(i) != Parity::even) {
                return Parity::undecided;
            }
        }
        if (first != Parity::odd) {
            return first;
        }
        return e.kind() == Kind::pow  ? of_power(e.arg(1))
               : e.args().size() == 1 ? of_odd_argument(e.builtin())
                                      : Parity::undecided;
    }
    default:
        // An integral or a sum.
        return holds_symbol(e, variable) ? Parity::undecided : Parity::even;
    }
}

bool odd_but_for_a_constant(const Expr& e, std::string_view variable) {
    using Kind = Expr::Kind;
    const auto constant = [&](const Expr& part) { return !holds_symbol(part, variable); };
    const auto shown = [&](std::size_t i) { return odd_but_for_a_constant(e.arg(i), variable); };
    if (constant(e) || parity(e, variable) == Parity::odd) {
        return true;
    }
    switch (e.kind()) {
    case Kind::neg:
        return shown(0);
    case Kind::add:
    case Kind::sub:
        return shown(0) && shown(1);
    case Kind::mul:
        return (constant(e.arg(0)) && shown(1)) || (constant(e.arg(1)) && shown(0));
    case Kind::div:
        return constant(e.arg(1)) && shown(0);
    case Kind::call:
        return e.builtin() == Builtin::acos && parity(e.arg(0), variable) == Parity::odd;
    default:
        return false;
    }
}

} // namespace edgeproof::formula

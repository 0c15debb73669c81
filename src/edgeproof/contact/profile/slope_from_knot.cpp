// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/profile/slope_from_knot.hpp"
#include "edgeproof/contact/profile/profile.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::contact {
namespace {

/// The first irrational constant in e, such as pi or sqrt(2).
std::optional<formula::Expr> irrational_part(const formula::Expr& e) {
    if (e.rational() != nullptr) {
        return std::nullopt;
    }
    if (e.kind() == formula::Expr::Kind::pi || e.kind() == formula::Expr::Kind::call ||
        e.kind() == formula::Expr::Kind::pow) {
        return e;
    }
    for (const formula::Expr& part : e.args()) {
        if (const auto found = irrational_part(part)) {
            return found;
        }
    }
    return std::nullopt;
}

formula::Expr with_symbol_for(const formula::Expr& e, const formula::Expr& part,
                              const formula::Expr& symbol) {
    if (e == part) {
        return symbol;
    }
    std::vector<formula::Expr> args;
    for (const formula::Expr& x : e.args()) {
        args.push_back(with_symbol_for(x, part, symbol));
    }
    return args.empty() ? e : formula::Expr::with_args(e, std::move(args));
}

/// True if a constant is 0 for any value of its irrational parts, for example pi/3 - 2*(pi/6).
bool zero_by_form(const formula::Expr& e) {
    if (const Rational* q = e.rational()) {
        return *q == 0;
    }
    const auto part = irrational_part(e);
    const auto linear =
        part ? as_linear(with_symbol_for(e, *part, formula::Expr::symbol("part")), "part")
             : std::nullopt;
    return linear && zero_by_form(linear->at_origin) && zero_by_form(linear->rate);
}

using Polynomial = std::vector<Rational>; ///< coefficients, the constant first

constexpr std::size_t most_coefficients = 33;

Polynomial product(const Polynomial& f, const Polynomial& g) {
    Polynomial h(f.size() + g.size() - 1, Rational(0));
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t j = 0; j < g.size(); ++j) {
            h[i + j] += f[i] * g[j];
        }
    }
    return h;
}

/// e as a polynomial in the distance x - knot; nothing if it is not one with rational coefficients.
std::optional<Polynomial> as_polynomial(const formula::Expr& e, const Rational& knot) {
    if (const Rational* q = e.rational()) {
        return Polynomial{*q};
    }
    if (e.kind() == formula::Expr::Kind::symbol) {
        return Polynomial{knot, Rational(1)};
    }
    if (e.kind() == formula::Expr::Kind::call || e.args().empty()) {
        return {};
    }
    const auto f = as_polynomial(e.arg(0), knot);
    if (!f) {
        return {};
    }
    if (e.kind() == formula::Expr::Kind::neg) {
        return product(*f, {Rational(-1)});
    }
    const auto g = e.args().size() == 2 ? as_polynomial(e.arg(1), knot) : std::nullopt;
    if (!g) {
        return {};
    }
    switch (e.kind()) {
    case formula::Expr::Kind::add:
    case formula::Expr::Kind::sub: {
        Polynomial sum = *f;
        sum.resize(std::max(f->size(), g->size()), Rational(0));
        for (std::size_t i = 0; i < g->size(); ++i) {
            sum[i] += e.kind() == formula::Expr::Kind::add ? (*g)[i] : Rational(-(*g)[i]);
        }
        return sum;
    }
    case formula::Expr::Kind::mul:
        return f->size() + g->size() <= most_coefficients ? std::optional(product(*f, *g))
                                                          : std::nullopt;
    case formula::Expr::Kind::div:
        return g->size() == 1 && (*g)[0] != 0 ? std::optional(product(*f, {Rational(1 / (*g)[0])}))
                                              : std::nullopt;
    case formula::Expr::Kind::pow: {
        if (g->size() != 1 || denominator((*g)[0]) != 1 || (*g)[0] < 0 ||
            (*g)[0] * f->size() >= most_coefficients) {
            return {};
        }
        Polynomial power{Rational(1)};
        for (long n = numerator((*g)[0]).convert_to<long>(); n > 0; --n) {
            power = product(power, *f);
        }
        return power;
    }
    default:
        return {};
    }
}

/// The polynomial by Horner's rule, without its constant, which is 0.
formula::Expr without_constant(const Polynomial& f) {
    const formula::Expr x = formula::Expr::symbol("x");
    formula::Expr sum = formula::Expr::number(f.back());
    for (std::size_t i = f.size() - 1; i-- > 0;) {
        sum = f[i] == 0 ? sum * x : sum * x + formula::Expr::number(f[i]);
    }
    return sum;
}

/// e as a function of x - knot. With `expand`, polynomials are multiplied out; then the sign of
/// their rate can no longer be read from the form, for example from a square.
formula::Expr moved_to(const formula::Expr& knot, const formula::Expr& e, bool expand,
                       bool* vanishes) {
    if (!free_symbols(e).contains("x")) {
        return e;
    }
    if (const Rational* at = knot.rational(); expand && at != nullptr) {
        const auto f = as_polynomial(e, *at);
        if (f && f->size() > 2 && (*f)[0] == 0 && f->back() != 0) {
            *vanishes = true;
            return without_constant(*f);
        }
    }
    if (const auto linear = as_linear(e, "x")) {
        const formula::Expr there = linear->at_origin + linear->rate * knot;
        const formula::Expr moved = linear->rate * formula::Expr::symbol("x");
        const Rational* q = there.rational();
        *vanishes = *vanishes || zero_by_form(there);
        return zero_by_form(there) ? moved
                                   : (q != nullptr ? formula::Expr::number(*q) : there) + moved;
    }
    std::vector<formula::Expr> args;
    for (const formula::Expr& x : e.args()) {
        args.push_back(moved_to(knot, x, expand, vanishes));
    }
    return formula::Expr::with_args(e, std::move(args));
}

} // namespace

formula::Expr slope_from_knot(const formula::Expr& slope, const formula::Expr& knot) {
    bool vanishes = false;
    return moved_to(knot, slope, false, &vanishes);
}

std::optional<formula::Expr> slope_near_zero(const formula::Expr& slope,
                                             const formula::Expr& knot) {
    if (const Rational* q = knot.rational(); q != nullptr && *q == 0) {
        return std::nullopt;
    }
    bool vanishes = false;
    formula::Expr moved = moved_to(knot, slope, true, &vanishes);
    return vanishes ? std::optional(std::move(moved)) : std::nullopt;
}

namespace {

constexpr long largest_root = 24;

/// (factor x)^exponent.
struct PowerOfX {
    formula::Expr factor;
    Rational exponent;
};

std::optional<PowerOfX> power_of_x(const formula::Expr& e) {
    const bool root =
        e.kind() == formula::Expr::Kind::call && e.builtin() == formula::Builtin::sqrt;
    if (!root && e.kind() != formula::Expr::Kind::pow) {
        return {};
    }
    const Rational* exponent = root ? nullptr : e.arg(1).rational();
    const auto linear = as_linear(e.arg(0), "x");
    const Rational* constant = linear ? linear->at_origin.rational() : nullptr;
    if ((!root && exponent == nullptr) || constant == nullptr || *constant != 0) {
        return {};
    }
    return PowerOfX{linear->rate, root ? Rational(1, 2) : *exponent};
}

void collect(const formula::Expr& e, long& root) {
    if (const auto power = power_of_x(e)) {
        const Integer least = denominator(power->exponent);
        root = least > largest_root ? largest_root + 1 : std::lcm(root, least.convert_to<long>());
        return;
    }
    for (const formula::Expr& part : e.args()) {
        if (root <= largest_root) {
            collect(part, root);
        }
    }
}

/// e with +w^root or -w^root in place of x (docs/curved-slopes.md, "What is integrated").
formula::Expr with_root(const formula::Expr& e, long root, bool positive) {
    const formula::Expr w = formula::Expr::symbol("x");
    const auto signed_by_side = [&](const formula::Expr& x) { return positive ? x : -x; };
    if (const auto power = power_of_x(e)) {
        const formula::Expr n = formula::Expr::number(Rational(power->exponent * root));
        return pow(signed_by_side(power->factor), formula::Expr::number(power->exponent)) *
               pow(w, n);
    }
    if (e.kind() == formula::Expr::Kind::symbol) {
        return signed_by_side(pow(w, formula::Expr::number(Rational(root))));
    }
    if (e.args().empty()) {
        return e;
    }
    std::vector<formula::Expr> args;
    for (const formula::Expr& part : e.args()) {
        args.push_back(with_root(part, root, positive));
    }
    return formula::Expr::with_args(e, std::move(args));
}

} // namespace

std::optional<SlopeAtRoot> slope_at_root(const formula::Expr& slope, const formula::Expr& knot,
                                         bool to_the_right) {
    const formula::Expr moved = slope_from_knot(slope, knot);
    long root = 1;
    collect(moved, root);
    if (root == 1 || root > largest_root) {
        return {};
    }
    return SlopeAtRoot{with_root(moved, root, to_the_right), root};
}

} // namespace edgeproof::contact

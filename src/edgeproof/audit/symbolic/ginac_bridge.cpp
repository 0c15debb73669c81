// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"

#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>

namespace edgeproof::audit::ginac {
namespace {

/// True for names that may be negative or zero.
bool has_either_sign(std::string_view name) {
    static constexpr std::string_view names[] = {"x", "s", "M", "alpha", "Q", "sig0", "y"};
    if (std::find(std::begin(names), std::end(names), name) != std::end(names)) {
        return true;
    }
    return name.size() == 2 && (name[0] == 'P' || name[0] == 'b') && name[1] >= '1' &&
           name[1] <= '9';
}

struct Tables {
    std::map<std::string, GiNaC::ex, std::less<>> symbols;
    /// The expressions (integrals and unknown functions) that are replaced by symbols.
    std::map<std::string, formula::Expr, std::less<>> opaque;
};

Tables& tables() {
    static Tables t;
    return t;
}

GiNaC::ex opaque(const formula::Expr& e) {
    const std::string name = "[" + to_text(e) + "]";
    tables().opaque.emplace(name, e);
    return symbol(name);
}

GiNaC::numeric number(const Rational& q) {
    const std::string text = q.str();
    return GiNaC::numeric(text.c_str());
}

Rational rational(const GiNaC::numeric& n) {
    if (!n.is_rational()) {
        throw Error("a symbolic result holds a number that is not rational");
    }
    const auto integer = [](const GiNaC::numeric& i) {
        std::ostringstream text;
        text << i;
        return Integer(text.str());
    };
    return {integer(n.numer()), integer(n.denom())};
}

constexpr long most_worked_out = 1000;

/// Returns base^exponent. GiNaC expands powers of numbers and of sums, however long this takes;
/// therefore throws Error for exponents too large for a formula of mechanics.
GiNaC::ex power(const GiNaC::ex& base, const GiNaC::ex& exponent) {
    if (GiNaC::is_a<GiNaC::numeric>(exponent) &&
        GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(exponent)) > most_worked_out) {
        throw Error("a power beyond " + std::to_string(most_worked_out) +
                    " is not worked out by symbols");
    }
    return GiNaC::power(base, exponent);
}

/// Returns gamma of x, with the same limit for a number, as GiNaC computes factorials.
GiNaC::ex gamma(const GiNaC::ex& x) {
    if (GiNaC::is_a<GiNaC::numeric>(x) &&
        GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(x)) > most_worked_out) {
        throw Error("gamma of a number beyond " + std::to_string(most_worked_out) +
                    " is not worked out by symbols");
    }
    return GiNaC::tgamma(x);
}

GiNaC::ex call(const formula::Expr& e) {
    const auto x = [&](std::size_t i) { return from_expr(e.arg(i)); };
    switch (e.builtin()) {
    case formula::Builtin::sqrt:
        return GiNaC::sqrt(x(0));
    case formula::Builtin::exp:
        return GiNaC::exp(x(0));
    case formula::Builtin::log:
        return GiNaC::log(x(0));
    case formula::Builtin::sin:
        return GiNaC::sin(x(0));
    case formula::Builtin::cos:
        return GiNaC::cos(x(0));
    case formula::Builtin::tan:
        return GiNaC::tan(x(0));
    case formula::Builtin::asin:
        return GiNaC::asin(x(0));
    case formula::Builtin::acos:
        return GiNaC::acos(x(0));
    case formula::Builtin::atan:
        return GiNaC::atan(x(0));
    case formula::Builtin::gamma:
        return gamma(x(0));
    default:
        return opaque(e);
    }
}

formula::Expr function_to_expr(const GiNaC::function& f) {
    static const std::map<std::string, std::string, std::less<>> names{
        {"exp", "exp"},   {"log", "log"},   {"sin", "sin"},   {"cos", "cos"},      {"tan", "tan"},
        {"asin", "asin"}, {"acos", "acos"}, {"atan", "atan"}, {"tgamma", "gamma"}, {"abs", "abs"}};
    const auto it = names.find(f.get_name());
    if (it == names.end()) {
        throw Error("a symbolic result holds the function " + f.get_name());
    }
    std::vector<formula::Expr> args;
    for (const GiNaC::ex& part : f) {
        args.push_back(to_expr(part));
    }
    return formula::Expr::call(it->second, std::move(args));
}

struct Signed {
    bool minus = false;
    formula::Expr e;
};

/// Returns a product as numerator/denominator, with the number in front.
Signed product_to_expr(const GiNaC::ex& e) {
    Rational coefficient(1);
    std::vector<formula::Expr> over;
    std::vector<formula::Expr> under;
    const auto take = [&](const GiNaC::ex& factor) {
        if (GiNaC::is_a<GiNaC::numeric>(factor)) {
            coefficient *= rational(GiNaC::ex_to<GiNaC::numeric>(factor));
            return;
        }
        if (GiNaC::is_a<GiNaC::power>(factor)) {
            const GiNaC::ex& exponent = factor.op(1);
            if (GiNaC::is_a<GiNaC::numeric>(exponent) &&
                GiNaC::ex_to<GiNaC::numeric>(exponent).is_negative()) {
                under.push_back(to_expr(GiNaC::power(factor.op(0), -exponent)));
                return;
            }
        }
        over.push_back(to_expr(factor));
    };
    if (GiNaC::is_a<GiNaC::mul>(e)) {
        for (const GiNaC::ex& factor : e) {
            take(factor);
        }
    } else {
        take(e);
    }
    const auto in_order = [](const formula::Expr& x, const formula::Expr& y) {
        const std::string s = to_text(x);
        const std::string t = to_text(y);
        return s.size() != t.size() ? s.size() < t.size() : s < t;
    };
    std::sort(over.begin(), over.end(), in_order);
    std::sort(under.begin(), under.end(), in_order);
    const bool minus = coefficient < 0;
    if (minus) {
        coefficient = -coefficient;
    }
    const Integer top = numerator(coefficient);
    const Integer bottom = denominator(coefficient);
    if (top != 1 || over.empty()) {
        over.insert(over.begin(), formula::Expr::number(Rational(top)));
    }
    if (bottom != 1) {
        under.insert(under.begin(), formula::Expr::number(Rational(bottom)));
    }
    const auto product = [](const std::vector<formula::Expr>& factors) {
        formula::Expr p = factors.front();
        for (std::size_t i = 1; i < factors.size(); ++i) {
            p = p * factors[i];
        }
        return p;
    };
    const formula::Expr numerator_part = product(over);
    return {minus, under.empty() ? numerator_part : numerator_part / product(under)};
}

} // namespace

std::unique_lock<std::recursive_mutex> hold() {
    static std::recursive_mutex mutex;
    return std::unique_lock(mutex);
}

GiNaC::ex symbol(std::string_view name) {
    auto& symbols = tables().symbols;
    auto it = symbols.find(name);
    if (it == symbols.end()) {
        const std::string text(name);
        const bool signed_name = has_either_sign(name) || text.front() == '[';
        it = symbols
                 .emplace(text, signed_name ? GiNaC::ex(GiNaC::realsymbol(text))
                                            : GiNaC::ex(GiNaC::possymbol(text)))
                 .first;
    }
    return it->second;
}

GiNaC::ex from_expr(const formula::Expr& e) {
    using Kind = formula::Expr::Kind;
    const auto x = [&](std::size_t i) { return from_expr(e.arg(i)); };
    switch (e.kind()) {
    case Kind::number:
        return number(e.number());
    case Kind::pi:
        return GiNaC::Pi;
    case Kind::symbol:
        return symbol(e.name());
    case Kind::neg:
        return -x(0);
    case Kind::add:
        return x(0) + x(1);
    case Kind::sub:
        return x(0) - x(1);
    case Kind::mul:
        return x(0) * x(1);
    case Kind::div: {
        const GiNaC::ex under = x(1);
        if (under.is_zero()) {
            throw DomainError("division by zero in " + to_text(e));
        }
        return x(0) / under;
    }
    case Kind::pow:
        return power(x(0), x(1));
    case Kind::call:
        return call(e);
    default:
        return opaque(e);
    }
}

bool hides(const formula::Expr& e, std::string_view name) {
    using formula::Builtin;
    static constexpr Builtin known[] = {Builtin::sqrt, Builtin::exp,  Builtin::log,  Builtin::sin,
                                        Builtin::cos,  Builtin::tan,  Builtin::asin, Builtin::acos,
                                        Builtin::atan, Builtin::gamma};
    const bool becomes_symbol = e.is_binder() || (e.kind() == formula::Expr::Kind::call &&
                                                  std::find(std::begin(known), std::end(known),
                                                            e.builtin()) == std::end(known));
    if (becomes_symbol) {
        return free_symbols(e).contains(std::string(name));
    }
    return std::any_of(e.args().begin(), e.args().end(),
                       [&](const formula::Expr& part) { return hides(part, name); });
}

formula::Expr to_expr(const GiNaC::ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
        return formula::Expr::number(rational(GiNaC::ex_to<GiNaC::numeric>(e)));
    }
    if (e.is_equal(GiNaC::Pi)) {
        return formula::Expr::pi();
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
        const std::string name = GiNaC::ex_to<GiNaC::symbol>(e).get_name();
        const auto it = tables().opaque.find(name);
        return it == tables().opaque.end() ? formula::Expr::symbol(name) : it->second;
    }
    if (GiNaC::is_a<GiNaC::add>(e)) {
        std::vector<std::pair<std::string, Signed>> terms;
        for (const GiNaC::ex& term : e) {
            Signed s = product_to_expr(term);
            std::string key = to_text(s.e);
            terms.emplace_back(std::move(key), std::move(s));
        }
        // Positive terms come first, so that a sum begins with a minus only if necessary.
        std::sort(terms.begin(), terms.end(), [](const auto& p, const auto& q) {
            return p.second.minus != q.second.minus ? q.second.minus : p.first < q.first;
        });
        formula::Expr sum = terms[0].second.minus ? -terms[0].second.e : terms[0].second.e;
        for (std::size_t i = 1; i < terms.size(); ++i) {
            const Signed& s = terms[i].second;
            sum = s.minus ? sum - s.e : sum + s.e;
        }
        return sum;
    }
    if (GiNaC::is_a<GiNaC::mul>(e)) {
        const Signed s = product_to_expr(e);
        return s.minus ? -s.e : s.e;
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
        const GiNaC::ex& exponent = e.op(1);
        if (GiNaC::is_a<GiNaC::numeric>(exponent)) {
            const Rational q = rational(GiNaC::ex_to<GiNaC::numeric>(exponent));
            const formula::Expr base = to_expr(e.op(0));
            if (q < 0) {
                return formula::Expr::number(1) / to_expr(GiNaC::power(e.op(0), -exponent));
            }
            return q == Rational(1, 2) ? formula::Expr::call("sqrt", {base})
                                       : pow(base, formula::quotient_of(q));
        }
        return pow(to_expr(e.op(0)), to_expr(exponent));
    }
    if (GiNaC::is_a<GiNaC::function>(e)) {
        return function_to_expr(GiNaC::ex_to<GiNaC::function>(e));
    }
    std::ostringstream text;
    text << e;
    throw Error("a symbolic result is of a kind that has no formula: " + text.str());
}

} // namespace edgeproof::audit::ginac

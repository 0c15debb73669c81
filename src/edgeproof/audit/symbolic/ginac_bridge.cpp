// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"

#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
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
    std::map<std::string, ex, std::less<>> symbols;
    /// The expressions (integrals and unknown functions) that are replaced by symbols.
    std::map<std::string, Expr, std::less<>> opaque;
};

Tables& tables() {
    static Tables t;
    return t;
}

ex opaque(const Expr& e) {
    const std::string name = "[" + to_text(e) + "]";
    tables().opaque.emplace(name, e);
    return symbol(name);
}

GiNaC::numeric number(const Rational& q) {
    const std::string text = q.str();
    return GiNaC::numeric(text.c_str());
}

/// GiNaC expands powers of numbers and of sums and computes factorials, however long this takes;
/// therefore throws Error for numbers too large for a formula of mechanics.
void refuse_large(const ex& number, const std::string& what) {
    constexpr long most_worked_out = 1000;
    if (GiNaC::is_a<GiNaC::numeric>(number) &&
        GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(number)) > most_worked_out) {
        throw Error(what + " beyond " + std::to_string(most_worked_out) +
                    " is not worked out by symbols");
    }
}

ex power(const ex& base, const ex& exponent) {
    refuse_large(exponent, "a power");
    return GiNaC::power(base, exponent);
}

ex gamma(const ex& x) {
    refuse_large(x, "gamma of a number");
    return GiNaC::tgamma(x);
}

/// A function that GiNaC has, and its name there.
struct Known {
    formula::Builtin id;
    std::string_view name;
    ex (*of)(const ex& x);
};
constexpr std::array known_functions{
    Known{formula::Builtin::sqrt, "", [](const ex& x) { return ex(GiNaC::sqrt(x)); }},
    Known{formula::Builtin::exp, "exp", [](const ex& x) { return ex(GiNaC::exp(x)); }},
    Known{formula::Builtin::log, "log", [](const ex& x) { return ex(GiNaC::log(x)); }},
    Known{formula::Builtin::sin, "sin", [](const ex& x) { return ex(GiNaC::sin(x)); }},
    Known{formula::Builtin::cos, "cos", [](const ex& x) { return ex(GiNaC::cos(x)); }},
    Known{formula::Builtin::tan, "tan", [](const ex& x) { return ex(GiNaC::tan(x)); }},
    Known{formula::Builtin::asin, "asin", [](const ex& x) { return ex(GiNaC::asin(x)); }},
    Known{formula::Builtin::acos, "acos", [](const ex& x) { return ex(GiNaC::acos(x)); }},
    Known{formula::Builtin::atan, "atan", [](const ex& x) { return ex(GiNaC::atan(x)); }},
    Known{formula::Builtin::gamma, "tgamma", gamma}};

const Known* find_known(const Expr& e) {
    const auto* const row = std::ranges::find(known_functions, e.builtin(), &Known::id);
    return e.kind() == Expr::Kind::call && row != known_functions.end() ? row : nullptr;
}

Expr function_to_expr(const GiNaC::function& f) {
    const auto* const row = std::ranges::find(known_functions, f.get_name(), &Known::name);
    if (row == known_functions.end() && f.get_name() != "abs") {
        throw Error("a symbolic result holds the function " + f.get_name());
    }
    std::vector<Expr> args;
    for (const ex& part : f) {
        args.push_back(to_expr(part));
    }
    return Expr::call(row == known_functions.end() ? "abs" : name_of(row->id), std::move(args));
}

struct Signed {
    bool minus = false;
    Expr e;
};

/// Returns a product as numerator/denominator, with the number in front.
Signed product_to_expr(const ex& e) {
    Rational coefficient(1);
    std::vector<Expr> over;
    std::vector<Expr> under;
    const auto take = [&](const ex& factor) {
        if (GiNaC::is_a<GiNaC::numeric>(factor)) {
            coefficient *= rational_of(factor);
            return;
        }
        if (GiNaC::is_a<GiNaC::power>(factor)) {
            const ex& exponent = factor.op(1);
            if (GiNaC::is_a<GiNaC::numeric>(exponent) &&
                GiNaC::ex_to<GiNaC::numeric>(exponent).is_negative()) {
                under.push_back(to_expr(GiNaC::power(factor.op(0), -exponent)));
                return;
            }
        }
        over.push_back(to_expr(factor));
    };
    for_each_factor(e, take);
    const bool minus = coefficient < 0;
    return {minus, quotient(minus ? Rational(-coefficient) : coefficient, std::move(over),
                            std::move(under))};
}

} // namespace

std::unique_lock<std::recursive_mutex> hold() {
    static std::recursive_mutex mutex;
    return std::unique_lock(mutex);
}

Rational rational_of(const ex& number) {
    const auto& n = GiNaC::ex_to<GiNaC::numeric>(number);
    if (!n.is_rational()) {
        throw Error("a symbolic result holds a number that is not rational");
    }
    std::ostringstream text;
    text << n;
    return Rational(text.str());
}

Expr quotient(const Rational& number, std::vector<Expr> over, std::vector<Expr> under) {
    const auto put_before = [](const Integer& n, std::vector<Expr>& factors, bool even_one) {
        // In an order that does not depend on GiNaC's.
        std::ranges::sort(factors, {}, [](const Expr& e) {
            std::string text = to_text(e);
            const std::size_t size = text.size();
            return std::pair(size, std::move(text));
        });
        if (n != 1 || even_one) {
            factors.insert(factors.begin(), Expr::number(Rational(n)));
        }
    };
    put_before(numerator(number), over, over.empty());
    put_before(denominator(number), under, false);
    const auto product = [](const std::vector<Expr>& factors) {
        return std::accumulate(factors.begin() + 1, factors.end(), factors.front(),
                               [](const Expr& p, const Expr& factor) { return p * factor; });
    };
    return under.empty() ? product(over) : product(over) / product(under);
}

ex symbol(std::string_view name) {
    auto& symbols = tables().symbols;
    auto it = symbols.find(name);
    if (it == symbols.end()) {
        const std::string text(name);
        const bool signed_name = has_either_sign(name) || text.front() == '[';
        it = symbols
                 .emplace(text,
                          signed_name ? ex(GiNaC::realsymbol(text)) : ex(GiNaC::possymbol(text)))
                 .first;
    }
    return it->second;
}

ex from_expr(const Expr& e) {
    using Kind = Expr::Kind;
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
        const ex under = x(1);
        if (under.is_zero()) {
            throw DomainError("division by zero in " + to_text(e));
        }
        return x(0) / under;
    }
    case Kind::pow:
        return power(x(0), x(1));
    default: {
        const Known* const function = find_known(e);
        return function != nullptr ? function->of(x(0)) : opaque(e);
    }
    }
}

bool hides(const Expr& e, std::string_view name) {
    if (e.is_binder() || (e.kind() == Expr::Kind::call && find_known(e) == nullptr)) {
        return holds_symbol(e, name); // becomes a symbol
    }
    return std::ranges::any_of(e.args(), [&](const Expr& part) { return hides(part, name); });
}

Expr to_expr(const ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
        return Expr::number(rational_of(e));
    }
    if (e.is_equal(GiNaC::Pi)) {
        return Expr::pi();
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
        const std::string name = GiNaC::ex_to<GiNaC::symbol>(e).get_name();
        const auto it = tables().opaque.find(name);
        return it == tables().opaque.end() ? Expr::symbol(name) : it->second;
    }
    if (GiNaC::is_a<GiNaC::add>(e)) {
        std::vector<std::pair<std::string, Signed>> terms;
        for (const ex& term : e) {
            Signed s = product_to_expr(term);
            std::string key = to_text(s.e);
            terms.emplace_back(std::move(key), std::move(s));
        }
        // Positive terms come first, so that a sum begins with a minus only if necessary.
        std::ranges::sort(terms, [](const auto& p, const auto& q) {
            return p.second.minus != q.second.minus ? q.second.minus : p.first < q.first;
        });
        Expr sum = terms[0].second.minus ? -terms[0].second.e : terms[0].second.e;
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
        const ex& exponent = e.op(1);
        if (GiNaC::is_a<GiNaC::numeric>(exponent)) {
            const Rational q = rational_of(exponent);
            const Expr base = to_expr(e.op(0));
            if (q < 0) {
                return Expr::number(1) / to_expr(GiNaC::power(e.op(0), -exponent));
            }
            return q == Rational(1, 2) ? Expr::call("sqrt", {base})
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

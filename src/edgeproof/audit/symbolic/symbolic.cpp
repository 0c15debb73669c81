// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/audit/symbolic/expansion_environment.hpp"
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <exception>
#include <map>
#include <vector>

namespace edgeproof::series {

bool vanishes(const GiNaC::ex& c) { return audit::ginac::is_zero(c); }

template <> GiNaC::ex field_number<GiNaC::ex>(const Rational& q) {
    return audit::ginac::from_expr(formula::Expr::number(q));
}

} // namespace edgeproof::series

namespace edgeproof::audit {
namespace {

using GiNaC::ex;

/// The field of symbols: returns the meaning of a name in a SymbolicCase.
class SymbolField {
public:
    explicit SymbolField(const SymbolicCase& under) : under_(under) {}

    [[nodiscard]] ex pi() const { return GiNaC::Pi; }
    [[nodiscard]] ex symbol(std::string_view name) const {
        const auto it = known_.find(name);
        if (it != known_.end()) {
            return it->second;
        }
        return known_.emplace(std::string(name), meaning(name)).first->second;
    }
    /// Integrates c over 0 < variable < hi; c must be a polynomial over sqrt(hi - variable).
    [[nodiscard]] ex integral(const ex& c, std::string_view variable, const ex& hi) const {
        const ex s = ginac::symbol(variable);
        const std::vector<ex> q = ginac::polynomial_over_root(c, s, hi);
        ex sum = 0;
        ex beta = 2; // B(j + 1, 1/2)
        for (std::size_t j = 0; j < q.size(); ++j) {
            const auto n = static_cast<long>(j);
            if (n > 0) {
                beta = beta * GiNaC::numeric(2 * n, 2 * n + 1);
            }
            sum += q[j] * beta * GiNaC::pow(hi, n) * GiNaC::sqrt(hi);
        }
        return sum;
    }

private:
    [[nodiscard]] ex meaning(std::string_view name) const {
        const bool numbered = name.size() == 2 && name[1] >= '1' && name[1] <= '9';
        const unsigned k = numbered ? static_cast<unsigned>(name[1] - '0') : 0;
        if (name == "L") {
            return symbol("a") + symbol("b");
        }
        if (name.starts_with("right_c") || name.starts_with("left_c")) {
            const contact::Edge edge =
                name.front() == 'r' ? contact::Edge::right : contact::Edge::left;
            const auto count = static_cast<std::size_t>(name.back() - '0') + 1;
            return ExpansionEnvironment<ex, SymbolField>::coefficients(*this, edge, count).back();
        }
        if (const auto given = under_.names.find(name); given != under_.names.end()) {
            return from(given->second);
        }
        if ((name == "P" || (numbered && name[0] == 'P')) && under_.P) {
            return from(*under_.P).diff(a(), k);
        }
        if (name == "b" || (numbered && name[0] == 'b')) {
            if (under_.b) {
                return from(*under_.b).diff(a(), k);
            }
            if (under_.symmetric) {
                return k == 0 ? ginac::symbol("a") : ex(k == 1 ? 1 : 0);
            }
        }
        return ginac::symbol(name);
    }
    [[nodiscard]] static GiNaC::symbol a() {
        return GiNaC::ex_to<GiNaC::symbol>(ginac::symbol("a"));
    }
    [[nodiscard]] static ex from(const formula::Expr& e) { return ginac::from_expr(e); }

    const SymbolicCase& under_;
    mutable std::map<std::string, ex, std::less<>> known_;
};

/// Returns e with every name replaced by its meaning in the case.
ex meaning_of(const formula::Expr& e, const SymbolField& field) {
    ex value = ginac::from_expr(e);
    GiNaC::exmap meanings;
    for (const std::string& name : free_symbols(e)) {
        const ex symbol = ginac::symbol(name);
        const ex meaning = field.symbol(name);
        if (!meaning.is_equal(symbol)) {
            meanings[symbol] = meaning;
        }
    }
    return meanings.empty() ? value : value.subs(meanings, GiNaC::subs_options::no_pattern);
}

using SymbolLaurent = series::Laurent<ex>;

SymbolLaurent expansion(const formula::Expr& e, const ExpansionIn& in, const SymbolField& field,
                        std::size_t order) {
    const ExpansionEnvironment<ex, SymbolField> environment(field, in.variable, in.edge, order);
    return evaluate<SymbolLaurent>(e, environment);
}

/// Expands to enough powers of w to reach `through`; uses more powers if too many are lost.
SymbolLaurent expansion_through(const formula::Expr& e, const ExpansionIn& in,
                                const SymbolField& field) {
    const auto top = static_cast<long>(numerator(Rational(in.through * 2)));
    for (std::size_t order = static_cast<std::size_t>(std::max(top, 0L)) + 4;; order += 4) {
        SymbolLaurent result = expansion(e, in, field, order);
        if (result.end() > top || order > 40) {
            return result;
        }
    }
}

/// Calls f, which uses GiNaC; its exceptions (a pole, a division by zero) become Error.
template <class F> auto by_symbols(const F& f) {
    const auto lock = ginac::hold();
    try {
        return f();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error(std::string("by symbols: ") + problem.what());
    }
}

} // namespace

bool ExpansionComparison::equal() const { return first_wrong() == nullptr; }

const ExpansionComparison::Term* ExpansionComparison::first_wrong() const {
    const auto it =
        std::find_if(terms.begin(), terms.end(), [](const Term& t) { return !t.equal; });
    return it == terms.end() ? nullptr : &*it;
}

formula::Expr derive(const formula::Expr& e, const SymbolicCase& under) {
    return by_symbols([&] { return ginac::tidy(meaning_of(e, SymbolField(under))); });
}

formula::Expr derivative(const formula::Expr& e, const std::string& name) {
    return by_symbols([&] {
        if (ginac::hides(e, name)) {
            throw Error("no derivative by " + name + " in symbols: " + to_text(e));
        }
        const ex by = ginac::symbol(name);
        return ginac::tidy(ginac::from_expr(e).diff(GiNaC::ex_to<GiNaC::symbol>(by)));
    });
}

bool proved_equal(const formula::Expr& x, const formula::Expr& y, const SymbolicCase& under) {
    return by_symbols([&] {
        const SymbolField field(under);
        return ginac::is_zero(meaning_of(x, field) - meaning_of(y, field));
    });
}

std::vector<ExpansionTerm> expand(const formula::Expr& e, const ExpansionIn& in,
                                  const SymbolicCase& under) {
    return by_symbols([&] {
        const SymbolField field(under);
        const SymbolLaurent series = expansion_through(e, in, field);
        std::vector<ExpansionTerm> terms;
        for (long k = series.lowest(); Rational(k, 2) <= in.through; ++k) {
            const ex c = series[k];
            if (!ginac::is_zero(c)) {
                terms.push_back({Rational(k, 2), ginac::tidy(c)});
            }
        }
        return terms;
    });
}

ExpansionComparison compare_expansions(const formula::Expr& printed, const formula::Expr& derived,
                                       const ExpansionIn& in, const SymbolicCase& under) {
    return by_symbols([&] {
        const SymbolField field(under);
        const SymbolLaurent x = expansion_through(printed, in, field);
        const SymbolLaurent y = expansion_through(derived, in, field);
        ExpansionComparison comparison;
        for (long k = std::min(x.lowest(), y.lowest()); Rational(k, 2) <= in.through; ++k) {
            const ex cx = x[k];
            const ex cy = y[k];
            const bool equal = ginac::is_zero(cx - cy);
            const formula::Expr derived_text = ginac::tidy(cy);
            if (equal && derived_text == formula::Expr::number(0)) {
                continue;
            }
            comparison.terms.push_back(
                {Rational(k, 2), equal ? derived_text : ginac::tidy(cx), derived_text, equal});
        }
        return comparison;
    });
}

formula::Expr sum_of(const std::vector<ExpansionTerm>& terms, const std::string& variable) {
    const formula::Expr eps = formula::Expr::symbol(variable);
    formula::Expr sum;
    bool first = true;
    for (const ExpansionTerm& term : terms) {
        const bool minus = term.coefficient.kind() == formula::Expr::Kind::neg;
        const formula::Expr c = minus ? term.coefficient.arg(0) : term.coefficient;
        formula::Expr product = c;
        if (term.exponent != 0) {
            const formula::Expr power = term.exponent == 1 ? eps
                                        : term.exponent == Rational(1, 2)
                                            ? formula::Expr::call("sqrt", {eps})
                                            : pow(eps, formula::Expr::number(term.exponent));
            product = c == formula::Expr::number(1) ? power : c * power;
        }
        if (first) {
            sum = minus ? -product : product;
        } else {
            sum = minus ? sum - product : sum + product;
        }
        first = false;
    }
    return sum;
}

namespace {

using Kind = formula::Expr::Kind;

struct Product {
    Rational number = 1;
    std::vector<std::string> over;
    std::vector<std::string> under;
};

std::string joined(std::vector<std::string> parts, const char* between) {
    std::sort(parts.begin(), parts.end());
    std::string text;
    for (const std::string& part : parts) {
        text += (text.empty() ? "" : between) + part;
    }
    return text;
}

std::string in_sequence(const formula::Expr& e) {
    std::string text = e.name() + "[" + std::to_string(static_cast<int>(e.kind()));
    for (const formula::Expr& part : e.args()) {
        text += "; " + ordered_text(part);
    }
    return text + "]";
}

void collect(const formula::Expr& e, bool over, Product& product) {
    if (const Rational* q = e.rational(); q != nullptr && (over || *q != 0)) {
        product.number = over ? Rational(product.number * *q) : Rational(product.number / *q);
        return;
    }
    switch (e.kind()) {
    case Kind::neg:
        product.number = -product.number;
        collect(e.arg(0), over, product);
        break;
    case Kind::mul:
        collect(e.arg(0), over, product);
        collect(e.arg(1), over, product);
        break;
    case Kind::div:
        collect(e.arg(0), over, product);
        collect(e.arg(1), !over, product);
        break;
    case Kind::symbol:
        (over ? product.over : product.under).push_back(e.name());
        break;
    case Kind::add:
    case Kind::sub:
        (over ? product.over : product.under).push_back("(" + ordered_text(e) + ")");
        break;
    default:
        (over ? product.over : product.under).push_back(in_sequence(e));
    }
}

void collect_terms(const formula::Expr& e, bool plus, std::vector<std::string>& terms) {
    switch (e.kind()) {
    case Kind::add:
    case Kind::sub:
        collect_terms(e.arg(0), plus, terms);
        collect_terms(e.arg(1), (e.kind() == Kind::add) == plus, terms);
        return;
    case Kind::neg:
        collect_terms(e.arg(0), !plus, terms);
        return;
    default:
        break;
    }
    Product product;
    collect(e, true, product);
    if (product.number == 0) {
        return;
    }
    const Rational number = plus ? product.number : Rational(-product.number);
    terms.push_back(number.str() + "*" + joined(std::move(product.over), "*") + "/" +
                    joined(std::move(product.under), "/"));
}

/// True for binders of one kind that differ only in the integrand.
bool differ_inside(const formula::Expr& x, const formula::Expr& y, Kind kind) {
    if (x.kind() != kind || y.kind() != kind) {
        return false;
    }
    for (std::size_t i = 1; i < x.args().size(); ++i) {
        if (!(x.arg(i) == y.arg(i))) {
            return false;
        }
    }
    return true;
}

/// True for principal values whose integrands differ by a constant over w(s)(s - x).
bool differ_by_a_zero_integral(const formula::Expr& x, const formula::Expr& y,
                               const SymbolicCase& under) {
    if (!differ_inside(x, y, Kind::pv)) {
        return false;
    }
    const formula::Expr a = formula::Expr::symbol("a");
    const formula::Expr b = under.symmetric ? a : formula::Expr::symbol("b");
    if (!(x.arg(2) == -b) || !(x.arg(3) == a)) {
        return false;
    }
    const formula::Expr& s = x.arg(1);
    const formula::Expr w = formula::Expr::call("sqrt", {(a - s) * (s + b)});
    const formula::Expr difference = (x.arg(0) - y.arg(0)) * w * (s - x.arg(4));
    return proved_equal(
        difference, substitute(difference, s.name(), formula::Expr::symbol("s_elsewhere")), under);
}

/// True for integrals whose integrands differ by a function odd about the middle.
bool differ_by_an_odd_part(const formula::Expr& x, const formula::Expr& y,
                           const SymbolicCase& under) {
    if (!differ_inside(x, y, Kind::integral)) {
        return false;
    }
    const formula::Expr difference = x.arg(0) - y.arg(0);
    const formula::Expr mirrored =
        substitute(difference, x.arg(1).name(), x.arg(2) + x.arg(3) - x.arg(1));
    return proved_equal(difference, -mirrored, under);
}

} // namespace

std::string ordered_text(const formula::Expr& e) {
    std::vector<std::string> terms;
    collect_terms(e, true, terms);
    return joined(std::move(terms), " + ");
}

bool surely_equal(const formula::Expr& x, const formula::Expr& y, const SymbolicCase& under) {
    const auto in_case = [&](const formula::Expr& e) {
        return under.symmetric ? substitute(e, "b", formula::Expr::symbol("a")) : e;
    };
    const formula::Expr one = in_case(x);
    const formula::Expr other = in_case(y);
    if (ordered_text(one) == ordered_text(other)) {
        return true;
    }
    try {
        return differ_by_a_zero_integral(one, other, under) ||
               differ_by_an_odd_part(one, other, under) || proved_equal(one, other, under);
    } catch (const Error&) {
        return false; // not proved by symbols
    }
}

} // namespace edgeproof::audit

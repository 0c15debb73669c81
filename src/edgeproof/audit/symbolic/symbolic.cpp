// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/symbolic/symbolic.hpp"

#include "edgeproof/algebra/form.hpp"
#include "edgeproof/algebra/laurent.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace edgeproof::audit {
namespace {

using algebra::Form;

/// True for names that may be negative or zero.
bool has_either_sign(std::string_view name) {
    static constexpr std::string_view names[] = {"x", "s", "M", "alpha", "Q", "sig0", "y"};
    return std::ranges::find(names, name) != std::end(names) || name.starts_with("right_s") ||
           name.starts_with("left_s") || name.starts_with("stick_") || order_behind(name, "P") ||
           order_behind(name, "b");
}

/// A name without a meaning. Lengths, moduli and similar quantities are positive.
Form symbol_alone(std::string_view name) { return Form::name(name, !has_either_sign(name)); }

/// Returns a formula in symbols that have no further meaning.
Form from(const Expr& e) { return algebra::form_of(e, symbol_alone); }

/// The field of symbols: returns the meaning of a name in a SymbolicCase.
class SymbolField {
public:
    explicit SymbolField(const SymbolicCase& under) : under_(under) {}

    [[nodiscard]] Form pi() const { return Form::pi(); }
    [[nodiscard]] Form symbol(std::string_view name) const {
        const auto it = known_.find(name);
        if (it != known_.end()) {
            return it->second;
        }
        return known_.emplace(std::string(name), meaning(name)).first->second;
    }
    /// Integrates c over 0 < variable < hi; c must be a polynomial over sqrt(hi - variable).
    [[nodiscard]] static Form integral(const Form& c, std::string_view variable, const Form& hi) {
        const auto q = Form(c * sqrt(hi - symbol_alone(variable))).coefficients(variable);
        if (!q) {
            throw DomainError("an integrand is not a polynomial over the square root of the "
                              "distance from its upper end");
        }
        Form sum;
        Form beta = 2 * sqrt(hi); // B(j + 1, 1/2) hi^(j + 1/2)
        for (std::size_t j = 0; j < q->size(); ++j) {
            const auto n = static_cast<int>(j);
            beta = n > 0 ? beta * hi * (2 * n) / (2 * n + 1) : beta;
            sum += (*q)[j] * beta;
        }
        return sum;
    }

    /// Returns c_k of p = sum c_k u^(k+1/2) at an edge.
    [[nodiscard]] std::vector<Form> coefficients(Edge edge, std::size_t count) const {
        const std::size_t n = edge == Edge::right ? count : count + 1;
        std::vector<Form> rate;
        std::vector<Form> b;
        for (unsigned k = 0; k < n; ++k) {
            rate.push_back(derivative("P", k + 1, k));
            b.push_back(derivative("b", k, k));
        }
        using Series = series::Series<Form>;
        const contact::LawSeries<Series> law{Series(std::move(rate)), Series(std::move(b))};
        const Form a = symbol("a");
        std::vector<Form> c = edge == Edge::right
                                  ? right_edge_brackets(law, a)
                                  : right_edge_brackets(mirrored(law, a), symbol("b"));
        c.resize(count, Form(0));
        return contact::coefficients_of(std::move(c), Form(a + symbol("b")), pi());
    }
    /// Returns the derivative of P or b of order k (0: itself), divided by factorial!.
    [[nodiscard]] Form derivative(const char* letter, unsigned k, unsigned factorial) const {
        Form c = symbol(k == 0 ? letter : letter + std::to_string(k));
        for (unsigned j = 2; j <= factorial; ++j) {
            c /= static_cast<int>(j);
        }
        return c;
    }

private:
    [[nodiscard]] Form meaning(std::string_view name) const {
        const auto k_of_P = name == "P" ? std::optional(std::size_t{0}) : order_behind(name, "P");
        const auto k_of_b = name == "b" ? std::optional(std::size_t{0}) : order_behind(name, "b");
        if (name == "L") {
            return symbol("a") + symbol("b");
        }
        const bool of_pressure = name.starts_with("right_c") || name.starts_with("left_c");
        if (of_pressure ||
            (under_.full_stick && (name.starts_with("right_s") || name.starts_with("left_s")))) {
            const Edge edge = name.front() == 'r' ? Edge::right : Edge::left;
            const auto count = static_cast<std::size_t>(name.back() - '0') + 1;
            const std::vector<Form> c =
                of_pressure ? coefficients(edge, count)
                            : contact::full_stick_expansion<Form>(
                                  symbol("L"), {symbol("Q"), symbol("sig0")}, edge, count);
            return c.back();
        }
        if (const auto given = under_.names.find(name); given != under_.names.end()) {
            return from(given->second);
        }
        if (k_of_P && under_.P) {
            return derivative(from(*under_.P), *k_of_P);
        }
        if (k_of_b && under_.b) {
            return derivative(from(*under_.b), *k_of_b);
        }
        if (k_of_b && under_.symmetric) {
            return *k_of_b == 0 ? symbol_alone("a") : Form(*k_of_b == 1 ? 1 : 0);
        }
        return under_.either_sign.contains(name) ? Form::name(name, false) : symbol_alone(name);
    }
    [[nodiscard]] static Form derivative(Form f, std::size_t k) {
        for (; k > 0; --k) {
            f = f.derivative("a");
        }
        return f;
    }

    const SymbolicCase& under_;
    mutable std::map<std::string, Form, std::less<>> known_;
};

/// Returns e with every name replaced by its meaning in the case.
Form meaning_of(const Expr& e, const SymbolField& field) {
    return algebra::form_of(e, [&](std::string_view name) { return field.symbol(name); });
}

using L = algebra::Laurent;

/// Evaluates a formula as a truncated expansion in one of its variables. The functions along the
/// family of contacts are given by their Taylor series, with the coefficients P1, P2, ..., b, b1,
/// ... of the field Form. No other data of the contact is used.
class ExpansionEnvironment {
public:
    /// Keeps `order` powers of w = variable^(1/2).
    ExpansionEnvironment(const SymbolField& field, std::string variable, Edge edge,
                         std::size_t order)
        : field_(field), variable_(std::move(variable)), edge_(edge), order_(order) {}

    [[nodiscard]] L number(const Rational& q) const { return L(Form(q), order_); }
    [[nodiscard]] L pi() const { return L(field_.pi(), order_); }
    [[nodiscard]] L symbol(std::string_view name) const {
        if (name == variable_) {
            return L::power(2, order_);
        }
        if (name == "x" && variable_ == "u") {
            return edge_ == Edge::right ? constant("a") - L::power(2, order_)
                                        : L::power(2, order_) - constant("b");
        }
        return constant(name);
    }

    [[nodiscard]] L call(const Expr& node, std::span<const L> args) const {
        const std::string& name = node.name();
        const L& s = args[0];
        if (name == "P1of") {
            return taylor(s - constant("a"),
                          [&](unsigned k) { return field_.derivative("P", k + 1, k); });
        }
        if (name == "Pof") {
            return taylor(s - constant("a"),
                          [&](unsigned k) { return field_.derivative("P", k, k); });
        }
        if (name == "bof") {
            return taylor(s - constant("a"),
                          [&](unsigned k) { return field_.derivative("b", k, k); });
        }
        if (name == "binv") {
            const L y = s - constant("b");
            std::vector<Form> b;
            for (unsigned k = 0; k < terms_in(y); ++k) {
                b.push_back(k == 0 ? Form(0) : field_.derivative("b", k, k));
            }
            const series::Series<Form> inverse = revert(series::Series<Form>(std::move(b)));
            return taylor(y, [&](unsigned k) { return k == 0 ? field_.symbol("a") : inverse[k]; });
        }
        if (name == "p") {
            return pressure(s);
        }
        throw Error("the function '" + name + "' has no expansion");
    }

    [[nodiscard]] L binder(const Expr& node) const {
        if (node.kind() == Expr::Kind::sum) {
            return evaluate_sum<L>(node, *this);
        }
        std::string name = node.arg(1).name();
        Expr integrand = node.arg(0);
        if (name == variable_ || name == "x") { // it hides a name that is expanded
            name = "variable of the integral";
            integrand = substitute(integrand, node.arg(1).name(), Expr::symbol(name));
        }
        const L lo = evaluate<L>(node.arg(2), *this);
        const L hi = evaluate<L>(node.arg(3), *this);
        if (node.kind() == Expr::Kind::pv || !lo.series()[0].is_zero() || hi.lowest() != 0) {
            throw Error("an expansion is integrated term by term from 0 to a constant only");
        }
        return evaluate<L>(integrand, *this).mapped([&](const Form& c) {
            return field_.integral(c, name, hi.series()[0]);
        });
    }

private:
    /// The number of Taylor coefficients with names: P1 ... P9.
    static constexpr unsigned terms = 8;

    [[nodiscard]] L constant(std::string_view name) const { return L(field_.symbol(name), order_); }
    /// A term that marks all powers from w^end on as unknown.
    [[nodiscard]] static L unknown_from(long end) {
        return {end - 1, series::Series<Form>(Form(0), 1)};
    }

    template <class Coefficient> [[nodiscard]] L taylor(const L& y, const Coefficient& c) const {
        if (y.series()[0].is_zero()) { // y = 0 to the known order
            return L(c(0), order_) + unknown_from(y.end());
        }
        if (y.lowest() < 1) {
            throw DomainError("a function is expanded about another point than the edge");
        }
        const unsigned count = terms_in(y);
        return L::polynomial(y, count, order_, c) +
               unknown_from(static_cast<long>(count) * y.lowest());
    }
    /// Returns the number of powers of y that contribute to the kept powers of w.
    [[nodiscard]] unsigned terms_in(const L& y) const {
        const auto lowest = static_cast<std::size_t>(std::max(y.lowest(), 1L));
        return static_cast<unsigned>(
            std::clamp<std::size_t>((order_ + lowest - 1) / lowest, 2, terms));
    }

    [[nodiscard]] L pressure(const L& x) const {
        for (const Edge edge : {edge_, opposite(edge_)}) {
            const L u = edge == Edge::right ? constant("a") - x : x + constant("b");
            if (u.lowest() < 1) {
                continue;
            }
            const auto count = static_cast<unsigned>(
                std::min<long>(6, static_cast<long>(order_) / 2 / u.lowest() + 2));
            const std::vector<Form> c = field_.coefficients(edge, count);
            return (L::polynomial(u, count, order_, [&](unsigned k) { return c[k]; }) +
                    unknown_from(static_cast<long>(count) * u.lowest())) *
                   sqrt(u);
        }
        throw DomainError("the pressure is expanded about a point that is no edge");
    }

    const SymbolField& field_;
    std::string variable_;
    Edge edge_;
    std::size_t order_;
};

/// Expands to enough powers of w to reach `through`; uses more powers if too many are lost.
L expansion_through(const Expr& e, const ExpansionIn& in, const SymbolField& field) {
    const auto top = static_cast<long>(numerator(Rational(in.through * 2)));
    for (std::size_t order = static_cast<std::size_t>(std::max(top, 0L)) + 4;; order += 4) {
        L result = evaluate<L>(e, ExpansionEnvironment(field, in.variable, in.edge, order));
        if (result.end() > top || order > 40) {
            return result;
        }
    }
}

} // namespace

bool ExpansionComparison::equal() const { return std::ranges::all_of(terms, &Term::equal); }

Form form_in(const Expr& e, const SymbolicCase& under) { return meaning_of(e, SymbolField(under)); }

Expr derive(const Expr& e, const SymbolicCase& under) { return form_in(e, under).expr(); }

Expr derivative(const Expr& e, const std::string& name) { return from(e).derivative(name).expr(); }

namespace {

/// Puts the loads of given(f, Q = ...) and given(f, sig0 = ...) into f. Nothing else depends on
/// them.
Expr with_given_loads(const Expr& e, const SymbolicCase& under) {
    if (!under.full_stick || !holds_call(e, "given")) {
        return e;
    }
    std::vector<Expr> args;
    for (const Expr& part : e.args()) {
        args.push_back(with_given_loads(part, under));
    }
    if (e.name() == "given" && (args[1] == Expr::symbol("Q") || args[1] == Expr::symbol("sig0"))) {
        const Expr f = derive(args[0], under);
        const bool of_contact = any_part(f, [](const Expr& part) {
            return part.kind() == Expr::Kind::call && part.builtin() == formula::Builtin::none;
        });
        if (!of_contact) {
            return substitute(f, args[1].name(), args[2]);
        }
    }
    return Expr::with_args(e, std::move(args));
}

} // namespace

bool proved_equal(const Expr& x, const Expr& y, const SymbolicCase& under) {
    const SymbolField field(under);
    return meaning_of(with_given_loads(x, under), field) ==
           meaning_of(with_given_loads(y, under), field);
}

ExpansionComparison compare_expansions(const Expr& printed, const Expr& derived,
                                       const ExpansionIn& in, const SymbolicCase& under) {
    const SymbolField field(under);
    const L x = expansion_through(printed, in, field);
    const L y = expansion_through(derived, in, field);
    ExpansionComparison comparison;
    for (long k = std::min(x.lowest(), y.lowest()); Rational(k, 2) <= in.through; ++k) {
        const Form cx = x[k];
        const Form cy = y[k];
        const bool equal = cx == cy;
        if (!equal || !cy.is_zero()) {
            const Expr of_y = cy.expr();
            comparison.terms.push_back({Rational(k, 2), equal ? of_y : cx.expr(), of_y, equal});
        }
    }
    return comparison;
}

Expr ExpansionComparison::derived(const std::string& variable) const {
    const Expr eps = Expr::symbol(variable);
    std::optional<Expr> sum;
    for (const Term& term : terms) {
        const bool minus = term.derived.kind() == Expr::Kind::neg;
        const Expr c = minus ? term.derived.arg(0) : term.derived;
        if (c == Expr::number(0)) {
            continue;
        }
        const Expr power = term.exponent == 1 ? eps
                           : term.exponent == Rational(1, 2)
                               ? Expr::call("sqrt", {eps})
                               : pow(eps, Expr::number(term.exponent));
        const Expr product = term.exponent == 0 ? c : c == Expr::number(1) ? power : c * power;
        sum = !sum ? (minus ? -product : product) : minus ? *sum - product : *sum + product;
    }
    return sum.value_or(Expr());
}

} // namespace edgeproof::audit

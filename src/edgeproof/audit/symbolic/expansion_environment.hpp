// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/series/laurent.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgeproof::audit {

/// Evaluates a formula as a truncated expansion in one of its variables. The functions along the
/// family of contacts are given by their Taylor series, with the coefficients P1, P2, ..., b, b1,
/// ... of the field T. No other data of the contact is used.
///
/// Field:  T symbol(std::string_view) const;  T pi() const;
///         T integral(const T& f, std::string_view variable, const T& hi) const;  from 0 to hi
template <class T, class Field> class ExpansionEnvironment {
public:
    using L = series::Laurent<T>;

    /// Keeps `order` powers of w = variable^(1/2).
    ExpansionEnvironment(const Field& field, std::string variable, contact::Edge edge,
                         std::size_t order)
        : field_(field), variable_(std::move(variable)), edge_(edge), order_(order) {}

    [[nodiscard]] L number(const Rational& q) const {
        return L(series::field_number<T>(q), order_);
    }
    [[nodiscard]] L pi() const { return L(field_.pi(), order_); }
    [[nodiscard]] L symbol(std::string_view name) const {
        if (name == variable_) {
            return L::power(2, order_);
        }
        if (name == "x" && variable_ == "u") {
            return edge_ == contact::Edge::right ? constant("a") - L::power(2, order_)
                                                 : L::power(2, order_) - constant("b");
        }
        return constant(name);
    }

    [[nodiscard]] L call(const formula::Expr& node, std::span<const L> args) const {
        const std::string& name = node.name();
        const L& s = args[0];
        if (name == "P1of") {
            return taylor(s - constant("a"), [&](unsigned k) { return derivative("P", k + 1, k); });
        }
        if (name == "Pof") {
            return taylor(s - constant("a"), [&](unsigned k) {
                return k == 0 ? field_.symbol("P") : derivative("P", k, k);
            });
        }
        if (name == "bof") {
            return taylor(s - constant("a"), [&](unsigned k) { return b_coefficient(k); });
        }
        if (name == "binv") {
            const L y = s - constant("b");
            std::vector<T> b;
            for (unsigned k = 0; k < terms_in(y); ++k) {
                b.push_back(k == 0 ? T(0) : b_coefficient(k));
            }
            const series::Series<T> inverse = revert(series::Series<T>(std::move(b)));
            return taylor(y, [&](unsigned k) { return k == 0 ? field_.symbol("a") : inverse[k]; });
        }
        if (name == "p") {
            return pressure(s);
        }
        throw Error("the function '" + name + "' has no expansion");
    }

    template <class Scope>
    [[nodiscard]] L binder(const formula::Expr& node, const Scope& scope) const {
        if (node.kind() == formula::Expr::Kind::sum) {
            return evaluate_sum<L>(node, scope);
        }
        const std::string& name = node.arg(1).name();
        const L lo = evaluate<L>(node.arg(2), scope);
        const L hi = evaluate<L>(node.arg(3), scope);
        if (node.kind() == formula::Expr::Kind::pv || !series::vanishes(lo.series()[0]) ||
            hi.lowest() != 0) {
            throw Error("an expansion is integrated term by term from 0 to a constant only");
        }
        const L variable(field_.symbol(name), order_);
        const L f = evaluate<L>(node.arg(0), formula::with_symbol(scope, name, variable));
        return f.mapped([&](const T& c) { return field_.integral(c, name, hi.series()[0]); });
    }

    /// Returns c_k of p = sum c_k u^(k+1/2) at an edge.
    [[nodiscard]] static std::vector<T> coefficients(const Field& field, contact::Edge edge,
                                                     std::size_t count) {
        const std::size_t n = edge == contact::Edge::right ? count : count + 1;
        std::vector<T> rate;
        std::vector<T> b;
        for (unsigned k = 0; k < n; ++k) {
            rate.push_back(derivative_of(field, "P", k + 1, k));
            b.push_back(k == 0 ? field.symbol("b") : derivative_of(field, "b", k, k));
        }
        const contact::LawSeries<T> law{series::Series<T>(std::move(rate)),
                                        series::Series<T>(std::move(b))};
        const T a = field.symbol("a");
        std::vector<T> c = edge == contact::Edge::right ? right_edge_brackets(law, a)
                                                        : left_edge_derivation(law, a).brackets;
        c.resize(count, T(0));
        return contact::coefficients_of(std::move(c), T(a + field.symbol("b")), field.pi());
    }

private:
    /// The number of Taylor coefficients with names: P1 ... P9.
    static constexpr unsigned terms = 8;

    static T derivative_of(const Field& field, const char* letter, unsigned k, unsigned factorial) {
        T c = field.symbol(letter + std::to_string(k));
        for (unsigned j = 2; j <= factorial; ++j) {
            c = c / T(static_cast<int>(j));
        }
        return c;
    }
    [[nodiscard]] T derivative(const char* letter, unsigned k, unsigned factorial) const {
        return derivative_of(field_, letter, k, factorial);
    }
    [[nodiscard]] T b_coefficient(unsigned k) const {
        return k == 0 ? field_.symbol("b") : derivative("b", k, k);
    }
    [[nodiscard]] L constant(std::string_view name) const { return L(field_.symbol(name), order_); }
    /// A term that marks all powers from w^end on as unknown.
    [[nodiscard]] static L unknown_from(long end) { return {end - 1, series::Series<T>(T(0), 1)}; }

    template <class Coefficient> [[nodiscard]] L taylor(const L& y, const Coefficient& c) const {
        if (series::vanishes(y.series()[0])) { // y = 0 to the known order
            return L(c(0), order_) + unknown_from(y.end());
        }
        if (y.lowest() < 1) {
            throw DomainError("a function is expanded about another point than the edge");
        }
        const unsigned count = terms_in(y);
        L sum(c(count - 1), order_);
        for (unsigned k = count - 1; k-- > 0;) {
            sum = sum * y + L(c(k), order_);
        }
        return sum + unknown_from(static_cast<long>(count) * y.lowest());
    }
    /// Returns the number of powers of y that contribute to the kept powers of w.
    [[nodiscard]] unsigned terms_in(const L& y) const {
        const auto lowest = static_cast<std::size_t>(std::max(y.lowest(), 1L));
        return static_cast<unsigned>(
            std::clamp<std::size_t>((order_ + lowest - 1) / lowest, 2, terms));
    }

    [[nodiscard]] L pressure(const L& x) const {
        for (const contact::Edge edge : {edge_, opposite(edge_)}) {
            const L u = edge == contact::Edge::right ? constant("a") - x : x + constant("b");
            if (u.lowest() < 1) {
                continue;
            }
            const auto count = static_cast<std::size_t>(
                std::min<long>(6, static_cast<long>(order_) / 2 / u.lowest() + 2));
            const std::vector<T> c = coefficients(field_, edge, count);
            L sum(c.back(), order_);
            for (std::size_t k = count - 1; k-- > 0;) {
                sum = sum * u + L(c[k], order_);
            }
            sum = sum + unknown_from(static_cast<long>(count) * u.lowest());
            return sum * sqrt(u);
        }
        throw DomainError("the pressure is expanded about a point that is no edge");
    }

    const Field& field_;
    std::string variable_;
    contact::Edge edge_;
    std::size_t order_;
};

} // namespace edgeproof::audit

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace edgeproof::audit {
namespace {

/// Returns a term as a product in reverse order of the quantities, such as 6*L*b1^2*left.c1. A
/// minus is that of its first factor.
Expr term_of(const Integer& coefficient, const std::vector<unsigned>& exponents,
             const std::vector<RelatedQuantity>& quantities) {
    std::vector<Expr> factors;
    if (abs(coefficient) != 1 || std::ranges::count(exponents, 0U) == std::ssize(exponents)) {
        factors.push_back(Expr::number(Rational(abs(coefficient))));
    }
    for (std::size_t i = exponents.size(); i-- > 0;) {
        const std::string& name = quantities[i].name;
        const bool one_name = name.find_first_of("+-*/^ ") == std::string::npos;
        const Expr symbol = Expr::symbol(one_name ? name : "(" + name + ")");
        if (exponents[i] > 0) {
            factors.push_back(exponents[i] == 1 ? symbol : pow(symbol, Expr::number(exponents[i])));
        }
    }
    const Expr first = coefficient < 0 ? -factors.front() : factors.front();
    return std::accumulate(factors.begin() + 1, factors.end(), first, std::multiplies<>());
}

Expr sum_of(const std::vector<PolynomialRelation::Term>& terms,
            const std::vector<RelatedQuantity>& quantities) {
    std::optional<Expr> sum;
    for (const PolynomialRelation::Term& t : terms) {
        const Expr size = term_of(abs(t.coefficient), t.exponents, quantities);
        sum = !sum                ? term_of(t.coefficient, t.exponents, quantities)
              : t.coefficient < 0 ? *sum - size
                                  : *sum + size;
    }
    return *sum;
}

} // namespace

std::string relation_text(const PolynomialRelation& relation,
                          const std::vector<RelatedQuantity>& quantities) {
    return to_text(sum_of(relation.terms, quantities)) + " = 0";
}

std::optional<std::string> solved_text(const PolynomialRelation& relation,
                                       const std::vector<RelatedQuantity>& quantities,
                                       std::size_t quantity) {
    std::vector<PolynomialRelation::Term> over;
    std::vector<PolynomialRelation::Term> under;
    for (PolynomialRelation::Term t : relation.terms) {
        const unsigned power = std::exchange(t.exponents[quantity], 0);
        if (power > 1) {
            return {};
        }
        t.coefficient = power == 1 ? t.coefficient : Integer(-t.coefficient);
        (power == 1 ? under : over).push_back(std::move(t));
    }
    if (under.empty() || over.empty()) {
        return {};
    }
    const Expr top = sum_of(over, quantities);
    const Expr bottom = sum_of(under, quantities);
    return quantities[quantity].name + " = " +
           to_text(bottom == Expr::number(1) ? top : top / bottom);
}

namespace {

Vocabulary names_of(const RelationQuestion& question) {
    Vocabulary vocabulary;
    for (const std::string& name : scene_names().variables()) {
        if (name != "u" && name != "x" && name != "M" && !is_slip_symbol(name) &&
            !is_stress(name)) {
            vocabulary.symbols.add(name);
        }
    }
    vocabulary.symbols.add("Q");
    vocabulary.symbols.add("sig0");
    for (const std::string& name : question.free) {
        vocabulary.symbols.add(name);
    }
    return vocabulary;
}

/// True for names computed from P1, b1, ...: a + b and the multipliers.
bool is_derived(std::string_view name) {
    return name == "L" || name.starts_with("right_") || name.starts_with("left_");
}

Expr formula_of(const std::string& of, const std::string& text, const Vocabulary& vocabulary) {
    try {
        return parse_formula(text, vocabulary);
    } catch (const InputError& error) {
        throw InputError(of + text + ": " + error.problem(), error.instead());
    }
}

} // namespace

AskedRelations asked_relations(const RelationQuestion& question) {
    if (question.degree < 1 || question.degree > most_relation_degree) {
        throw InputError("degree = " + std::to_string(question.degree) + " is out of range",
                         "give a whole number from 1 to " + std::to_string(most_relation_degree));
    }
    const Vocabulary vocabulary = names_of(question);
    SymbolicCase under;
    under.symmetric = question.symmetric;
    for (const auto& [name, formula] : question.given) {
        const std::string as_given = "given " + name + "=";
        if (!vocabulary.symbols.has(name)) {
            throw InputError(fmt::format("{}{}: there is no '{}'", as_given, formula, name),
                             "give P1, P2, ..., b, b1, ... as formulas in the free quantities");
        }
        Expr e = formula_of(as_given, formula, vocabulary);
        std::set<std::string> names = free_symbols(e);
        names.insert(name);
        if (const auto it = std::ranges::find_if(names, is_derived); it != names.end()) {
            throw InputError(fmt::format("{}{}: '{}' follows from others", as_given, formula, *it),
                             "give P1, P2, ..., b, b1, ... as formulas in the free quantities");
        }
        if (!under.names.emplace(name, std::move(e)).second) {
            throw InputError(fmt::format("{} is given twice", name), "give each name one formula");
        }
    }
    under.names = put_into_each_other(under.names);
    AskedRelations asked;
    for (const std::string& text : question.quantities) {
        asked.quantities.push_back({text, formula_of("", text, vocabulary)});
    }
    try {
        asked.found =
            find_relations(asked.quantities, static_cast<unsigned>(question.degree), under);
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(error.what(), "write quotients of polynomials of low degree");
    }
    return asked;
}

namespace {

/// The scaling of a formula, as a number type for formula::evaluate.
struct Scaling {
    ScalingWeights weights{};

    friend Scaling operator-(const Scaling& x) { return x; }
    friend Scaling operator+(const Scaling& x, const Scaling& y) {
        // It is not necessary to know if a term is zero.
        return x.weights == y.weights ? x : throw Error("terms that scale differently");
    }
    friend Scaling operator-(const Scaling& x, const Scaling& y) { return x + y; }
    friend Scaling operator*(Scaling x, const Scaling& y) {
        for (std::size_t i = 0; i < x.weights.size(); ++i) {
            x.weights[i] += y.weights[i];
        }
        return x;
    }
    friend Scaling operator/(const Scaling& x, const Scaling& y) {
        return x * pow(y, Rational(-1));
    }
    friend Scaling pow(Scaling x, const Rational& q) {
        for (Rational& weight : x.weights) {
            weight *= q;
        }
        return x;
    }
    friend Scaling pow(const Scaling&, const Scaling&) {
        throw Error("a power that is not a number");
    }
    friend Scaling sqrt(const Scaling& x) { return pow(x, Rational(1, 2)); }
};

struct ScalingOfNames {
    [[nodiscard]] static Scaling number(const Rational&) { return {}; }
    [[nodiscard]] static Scaling pi() { return {}; }
    [[nodiscard]] static Scaling symbol(std::string_view name) {
        if (name == "a" || name == "b" || name == "L") {
            return {{0, 1, 0}};
        }
        if (name == "P" || name == "M") {
            return {{1, name == "M" ? 1 : 0, 0}};
        }
        if (name == "Q" || name == "sig0") {
            return {{0, name == "Q" ? 0 : -1, 1}};
        }
        if (const auto k = order_behind(name, "P")) {
            return {{1, -static_cast<long>(*k), 0}};
        }
        const auto k = order_behind(name, "b");
        return k ? Scaling{{0, 1 - static_cast<long>(*k), 0}} : Scaling();
    }
};

} // namespace

std::optional<ScalingWeights> scaling_weights(const Expr& e) {
    try {
        return formula::evaluate<Scaling>(e, ScalingOfNames()).weights;
    } catch (const Interrupted&) {
        throw;
    } catch (const Error&) {
        return {};
    }
}

} // namespace edgeproof::audit

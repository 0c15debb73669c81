// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

bool is_one_name(const std::string& name) {
    return name.find_first_of("+-*/^ ") == std::string::npos;
}

/// Returns the factors of a term without its numerical coefficient.
std::string factors(const std::vector<unsigned>& exponents,
                    const std::vector<RelatedQuantity>& quantities) {
    std::string text;
    // In reverse order of the quantities: 6*L*b1^2*left.c1.
    for (std::size_t i = exponents.size(); i-- > 0;) {
        if (exponents[i] == 0) {
            continue;
        }
        const std::string& name = quantities[i].name;
        text += text.empty() ? "" : "*";
        text += is_one_name(name) ? name : "(" + name + ")";
        text += exponents[i] > 1 ? "^" + std::to_string(exponents[i]) : "";
    }
    return text;
}

struct TermText {
    Integer coefficient;
    std::string factors;
};

std::string sum_text(const std::vector<TermText>& terms) {
    std::string text;
    for (const TermText& term : terms) {
        const bool minus = term.coefficient < 0;
        const Integer size = minus ? Integer(-term.coefficient) : term.coefficient;
        text += text.empty() ? (minus ? "-" : "") : minus ? " - " : " + ";
        if (term.factors.empty()) {
            text += size.str();
        } else {
            text += size == 1 ? term.factors : size.str() + "*" + term.factors;
        }
    }
    return text;
}

} // namespace

std::string relation_text(const PolynomialRelation& relation,
                          const std::vector<RelatedQuantity>& quantities) {
    std::vector<TermText> terms;
    for (const PolynomialRelation::Term& t : relation.terms) {
        terms.push_back({t.coefficient, factors(t.exponents, quantities)});
    }
    return sum_text(terms) + " = 0";
}

std::optional<std::string> solved_text(const PolynomialRelation& relation,
                                       const std::vector<RelatedQuantity>& quantities,
                                       std::size_t quantity) {
    std::vector<TermText> over;
    std::vector<TermText> under;
    for (const PolynomialRelation::Term& t : relation.terms) {
        std::vector<unsigned> e = t.exponents;
        if (e[quantity] > 1) {
            return {};
        }
        if (e[quantity] == 1) {
            e[quantity] = 0;
            under.push_back({t.coefficient, factors(e, quantities)});
        } else {
            over.push_back({-t.coefficient, factors(e, quantities)});
        }
    }
    if (under.empty() || over.empty()) {
        return {};
    }
    std::string top = sum_text(over);
    std::string bottom = sum_text(under);
    if (over.size() > 1) {
        top = "(" + top + ")";
    }
    if (under.size() > 1 || bottom.find('*') != std::string::npos) {
        bottom = "(" + bottom + ")";
    }
    return quantities[quantity].name + " = " + top + (bottom == "1" ? "" : "/" + bottom);
}

namespace {

Vocabulary names_of(const RelationQuestion& question) {
    Vocabulary vocabulary;
    for (const std::string& name : scene_symbols()) {
        if (name != "u" && name != "x" && name != "M") {
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

ScalingWeights weights_of_name(const std::string& name) {
    if (name == "a" || name == "b" || name == "L") {
        return {0, 1, 0};
    }
    if (name == "P" || name == "M") {
        return {1, name == "M" ? 1 : 0, 0};
    }
    if (name == "Q" || name == "sig0") {
        return {0, name == "Q" ? 0 : -1, 1};
    }
    if (name.size() == 2 && name[1] >= '1' && name[1] <= '9') {
        const int k = name[1] - '0';
        if (name[0] == 'P') {
            return {1, -k, 0};
        }
        if (name[0] == 'b') {
            return {0, 1 - k, 0};
        }
    }
    return {0, 0, 0};
}

ScalingWeights times(ScalingWeights w, const Rational& q) {
    for (Rational& x : w) {
        x *= q;
    }
    return w;
}

ScalingWeights plus(ScalingWeights w, const ScalingWeights& o, int sign) {
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] += sign * o[i];
    }
    return w;
}

} // namespace

std::optional<ScalingWeights> scaling_weights(const Expr& e) {
    using Kind = Expr::Kind;
    if (e.rational() != nullptr || e.kind() == Kind::pi) {
        return ScalingWeights{0, 0, 0};
    }
    if (e.kind() == Kind::symbol) {
        return weights_of_name(e.name());
    }
    const auto first = e.args().empty() ? std::nullopt : scaling_weights(e.arg(0));
    if (!first) {
        return {};
    }
    if (e.kind() == Kind::neg) {
        return first;
    }
    if (e.kind() == Kind::call) {
        return e.builtin() == formula::Builtin::sqrt ? std::optional(times(*first, Rational(1, 2)))
                                                     : std::nullopt;
    }
    if (e.kind() == Kind::pow) {
        const Rational* q = e.arg(1).rational();
        return q != nullptr ? std::optional(times(*first, *q)) : std::nullopt;
    }
    if (e.is_binder()) {
        return {};
    }
    const auto second = scaling_weights(e.arg(1));
    if (!second) {
        return {};
    }
    switch (e.kind()) {
    case Kind::mul:
        return plus(*first, *second, 1);
    case Kind::div:
        return plus(*first, *second, -1);
    default: // a sum; it is not necessary to know if a part is zero
        return *first == *second ? first : std::nullopt;
    }
}

} // namespace edgeproof::audit

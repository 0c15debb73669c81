// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/audit/sample/gradient_rank.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

/// The result of a search for polynomial relations; the quantity is the first variable.
struct AlgebraicDependence {
    std::optional<std::string> relation; ///< contains the quantity; proved by symbols
    std::optional<std::string> solved;   ///< the quantity, if the relation is linear in it
    bool none = false;                   ///< it is proved that there is none up to the degree
};

AlgebraicDependence by_relations(const std::vector<RelatedQuantity>& quantities, unsigned degree,
                                 const SymbolicCase& under, Evidence& evidence) {
    const FoundRelations found = find_relations(quantities, degree, under);
    AlgebraicDependence result;
    std::vector<std::string> texts;
    const PolynomialRelation* shortest = nullptr;
    for (const PolynomialRelation& r : found.relations) {
        texts.push_back(relation_text(r, quantities));
        // Prefer the relation that is easiest to solve for the quantity.
        const auto size = [](const PolynomialRelation& of) {
            return std::pair(of.terms_with(0), of.terms.size());
        };
        if (r.involves(0) && (shortest == nullptr || size(r) < size(*shortest))) {
            shortest = &r;
        }
    }
    if (shortest != nullptr) {
        result.relation = relation_text(*shortest, quantities);
        result.solved = solved_text(*shortest, quantities, 0);
    }
    result.none = found.complete && !result.relation;
    evidence.add("relations_up_to_degree", std::to_string(degree))
        .add("relations_proved_by_symbols", texts)
        .add("every_other_is_a_sum_of_their_multiples", found.complete)
        .add("monomials", found.monomials)
        .add("samples", found.samples);
    return result;
}

/// The quantity, and those of which it may be a function, as formulas in free names.
struct FreeFormulas {
    formula::Expr of;
    std::vector<formula::Expr> from;
    std::vector<RelatedQuantity> quantities; ///< as written, with the quantity first
};

FreeFormulas free_formulas(const Claim& claim, const SymbolicCase& under) {
    FreeFormulas all{
        derive(claim.formula("of"), under), {}, {{claim.text("of"), claim.formula("of")}}};
    const std::vector<std::string>& texts = claim.list("from");
    const auto& formulas = claim.formulas("from");
    for (std::size_t i = 0; i < formulas.size(); ++i) {
        all.quantities.push_back({texts[i], formulas[i]});
        all.from.push_back(derive(formulas[i], under));
    }
    return all;
}

/// Returns the names on which the quantity depends and the others do not.
std::string names_alone(const FreeFormulas& formulas) {
    std::set<std::string> known;
    for (const formula::Expr& e : formulas.from) {
        known.merge(free_symbols(e));
    }
    std::string alone;
    for (const std::string& name : free_symbols(formulas.of)) {
        if (!known.contains(name)) {
            alone += (alone.empty() ? "" : ", ") + name;
        }
    }
    return alone;
}

AlgebraicDependence look_for_relations(const Claim& claim, const FreeFormulas& formulas,
                                       const SymbolicCase& under, Evidence& evidence) {
    if (!claim.has("degree")) {
        return {};
    }
    const long degree = claim.integer("degree");
    if (degree < 1 || degree > 12) {
        claim.reject("degree", "relations of degree " + std::to_string(degree),
                     "give a degree from 1 to 12");
    }
    return by_relations(formulas.quantities, static_cast<unsigned>(degree), under, evidence);
}

void add_finding(const Claim& claim, const std::string& is, const ComparedNumbers& numbers,
                 unsigned digits, Outcome& outcome) {
    outcome.note = claim.text("of") + " is " + is + " of the others near the point drawn";
    add_pair(numbers, digits, outcome.evidence);
}

/// Judges from a proof, at a drawn point, that the quantity is not a function of the others.
void judge_independent(const Claim& claim, const GradientRank& rank, bool says_independent,
                       unsigned digits, Outcome& outcome) {
    const Ball& left = *rank.outside();
    const Ball none(0, left.bits());
    if (const auto fails = Refutation::less(none, left); fails && !says_independent) {
        outcome.verdict = Judgement(*fails);
    } else if (const auto holds = Confirmation::less(none, left); holds && says_independent) {
        outcome.verdict = Judgement(*holds);
    }
    add_finding(claim, "not a function",
                {"gradient outside of the span of the others",
                 {left, ""},
                 "of a function of them",
                 {none, ""},
                 rank.at()},
                digits, outcome);
}

/// Judges from a proof that near a drawn point the quantity's gradient lies in the span of the
/// others, so that the rank is the same with it and without it.
void judge_function(const Claim& claim, const GradientRank& rank, bool says_independent,
                    unsigned digits, Outcome& outcome) {
    constexpr long bits = 64;
    const Ball found(static_cast<long>(*rank.rank()), bits);
    const Ball of_independent = found + 1;
    if (const auto fails = Refutation::disjoint(of_independent, found); fails && says_independent) {
        outcome.verdict = Judgement(*fails);
    } else if (const auto holds = Confirmation::agreement(found, found, Ball(1, bits), 1);
               holds && !says_independent) {
        outcome.verdict = Judgement(*holds);
    }
    add_finding(claim, "a function",
                {"rank of all gradients if it were none",
                 {of_independent, ""},
                 "rank proved",
                 {found, ""},
                 rank.at()},
                digits, outcome);
}

/// Checks if a quantity is a function of others, where P', P'', b', b'', ... are free: it is one
/// near a point if its gradient is a linear combination of theirs.
Outcome check_dependence(const Claim& claim, const AuditContext& context) {
    const SymbolicCase under = symbolic_case(claim, context);
    const FreeFormulas formulas = free_formulas(claim, under);
    const GradientRank rank(formulas.of, formulas.from, under);
    const bool says_independent = claim.text("says") == "independent";
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("from", claim.list("from"))
        .add("derived", to_text(formulas.of))
        .add("derived_tex", to_tex(formulas.of))
        .add("free", rank.names());
    const AlgebraicDependence algebraic =
        look_for_relations(claim, formulas, under, outcome.evidence);
    if (rank.outside()) {
        judge_independent(claim, rank, says_independent, context.digits(), outcome);
        const std::string alone = names_alone(formulas);
        outcome.note += alone.empty() ? "" : ": it depends on " + alone + ", but they do not";
        if (algebraic.none) {
            outcome.note += "; no polynomial relation of degree up to " +
                            std::to_string(claim.integer("degree")) +
                            " contains it, proved by rank";
        }
    } else if (rank.rank()) {
        judge_function(claim, rank, says_independent, context.digits(), outcome);
        if (algebraic.relation) {
            outcome.note += ", proved by symbols: " + *algebraic.relation;
            outcome.computed = algebraic.solved ? algebraic.solved : algebraic.relation;
        }
    } else {
        outcome.note = rank.problem();
    }
    return outcome;
}

} // namespace

CheckKind dependence_kind() {
    using Type = KeySpec::Type;
    return {"dependence",
            {{.name = "says",
              .type = Type::choice,
              .required = true,
              .choices = {"independent", "function"}},
             required_formula("of"),
             {.name = "from", .type = Type::formulas, .required = true},
             {.name = "degree", .type = Type::integer},
             {.name = "given", .type = Type::formula_table}},
            check_dependence};
}

} // namespace edgeproof::audit

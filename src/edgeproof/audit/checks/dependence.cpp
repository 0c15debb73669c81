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
    for (const auto& [text, formula] : named_formulas(claim, "from")) {
        all.quantities.push_back({text, formula});
        all.from.push_back(derive(formula, under));
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

/// Judges from a proof, at a drawn point, that the quantity is not a function of the others.
void judge_independent(const GradientRank& rank, bool says_independent, unsigned digits,
                       Outcome& outcome) {
    const Ball& left = *rank.outside();
    const Ball none(0, left.bits());
    outcome.verdict =
        Judgement(says_independent ? decision(std::nullopt, Confirmation::less(none, left))
                                   : decision(Refutation::less(none, left), std::nullopt));
    outcome.evidence.add("enclosures",
                         pair_evidence(rank.at(), "gradient outside of the span of the others",
                                       left, "of a function of them", none, digits));
}

/// Judges from a proof that near a drawn point the quantity's gradient lies in the span of the
/// others, so that the rank is the same with it and without it.
void judge_function(const GradientRank& rank, bool says_independent, unsigned digits,
                    Outcome& outcome) {
    constexpr long bits = 64;
    const Ball found(static_cast<long>(*rank.rank()), bits);
    const Ball of_independent = found + 1;
    outcome.verdict = Judgement(
        says_independent
            ? decision(Refutation::disjoint(of_independent, found), std::nullopt)
            : decision(std::nullopt, Confirmation::agreement(found, found, Ball(1, bits), 1)));
    outcome.evidence.add("enclosures",
                         pair_evidence(rank.at(), "rank of all gradients if it were none",
                                       of_independent, "rank proved", found, digits));
}

} // namespace

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
        judge_independent(rank, says_independent, context.digits(), outcome);
        outcome.note = claim.text("of") + " is not a function of the others near the point drawn";
        const std::string alone = names_alone(formulas);
        outcome.note += alone.empty() ? "" : ": it depends on " + alone + ", but they do not";
        if (algebraic.none) {
            outcome.note += "; no polynomial relation of degree up to " +
                            std::to_string(claim.integer("degree")) +
                            " contains it, proved by rank";
        }
    } else if (rank.rank()) {
        judge_function(rank, says_independent, context.digits(), outcome);
        outcome.note = claim.text("of") + " is a function of the others near the point drawn";
        if (algebraic.relation) {
            outcome.note += ", proved by symbols: " + *algebraic.relation;
            outcome.computed = algebraic.solved ? algebraic.solved : algebraic.relation;
        }
    } else {
        outcome.note = rank.problem();
    }
    return outcome;
}

} // namespace edgeproof::audit

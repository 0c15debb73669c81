// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/audit/checks/kinds.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr long rank_bits = 64;
constexpr long usual_degree = 3;

/// Searches for relations of up to the degree of the claim. Returns the one that is easiest to
/// solve for the first quantity and determines it. Leaves out quantities that others determine.
std::optional<PolynomialRelation> search(const Claim& claim,
                                         std::vector<RelatedQuantity>& quantities,
                                         const SymbolicCase& under, Outcome& outcome) {
    const long degree = claim.integer_or("degree", usual_degree);
    if (degree < 1 || degree > most_relation_degree) {
        claim.reject("degree", "relations of degree " + std::to_string(degree),
                     "give a degree from 1 to 12");
    }
    const std::vector<RelatedQuantity> all = quantities;
    const FoundRelations found = find_relations(all, static_cast<unsigned>(degree), under);
    std::vector<std::string> texts;
    std::vector<bool> left_out(all.size());
    std::optional<PolynomialRelation> best;
    for (const PolynomialRelation& r : found.relations) {
        texts.push_back(relation_text(r, all));
        const auto size = [](const PolynomialRelation& of) {
            return std::pair(of.terms_with(0), of.terms.size());
        };
        if (r.involves(0)) {
            if ((!best || size(r) < size(*best)) && determines(r, 0, all, under)) {
                best = r;
            }
            continue;
        }
        std::size_t last = 0;
        bool of_kept = true;
        for (std::size_t i = 1; i < all.size(); ++i) {
            of_kept = of_kept && !(left_out[i] && r.involves(i));
            last = r.involves(i) ? i : last;
        }
        left_out[last] = left_out[last] || (of_kept && determines(r, last, all, under));
    }
    std::size_t i = 0;
    std::erase_if(quantities, [&](const RelatedQuantity&) { return bool{left_out[i++]}; });
    outcome.evidence.update({{"relations_up_to_degree", std::to_string(degree)},
                             {"relations_proved_by_symbols", texts},
                             {"every_other_is_a_sum_of_their_multiples", found.complete},
                             {"monomials", found.monomials},
                             {"samples", found.samples}});
    if (best) {
        outcome.note = ", proved by symbols: " + relation_text(*best, all);
        outcome.computed = solved_text(*best, all, 0);
    } else if (found.complete) {
        outcome.note = "; no polynomial relation of degree up to " + std::to_string(degree) +
                       " contains it, proved by rank";
    }
    return best;
}

} // namespace

Outcome check_relations(const Claim& claim, const AuditContext& context) {
    if (claim.has("where")) {
        claim.reject("where", "relations hold for all contacts of a family, without conditions",
                     "leave out `where`, and list the family's values");
    }
    const SymbolicCase under = symbolic_case(claim, context);
    std::vector<RelatedQuantity> quantities{{claim.text("of"), claim.formula("of")}};
    for (const auto& [text, formula] : named_formulas(claim, "from")) {
        quantities.push_back({text, formula});
    }
    Outcome outcome;
    outcome.evidence.update({{"of", claim.text("of")}, {"from", claim.list("from")}});
    const auto relation = search(claim, quantities, under, outcome);
    GradientRanks ranks = gradient_ranks(quantities, under);
    if (relation) {
        ranks.function = true;
    }
    if (!ranks.function) {
        outcome.note = "the ranks of the gradients do not decide" + outcome.note;
        return outcome;
    }
    const Ball others(static_cast<long>(ranks.others), rank_bits);
    const Ball more = others + 1;
    const bool independent = claim.text("says") == "independent";
    outcome.evidence.update({{"rank_of_the_others", ranks.others},
                             {"rank_of_all", ranks.others + (*ranks.function ? 0 : 1)}});
    outcome.verdict = Judgement(independent == *ranks.function
                                    ? decision(Refutation::less(others, more), std::nullopt)
                                    : decision(std::nullopt, Confirmation::less(others, more)));
    outcome.note = claim.text("of") + (*ranks.function ? " is" : " is not") +
                   " a function of the others near some point" + outcome.note;
    return outcome;
}

} // namespace edgeproof::audit

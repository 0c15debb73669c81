// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/margin.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace edgeproof::audit {
namespace {

struct RelationInScene {
    std::string scene;
    Decision decision;
    std::size_t places = 0;
    std::optional<Margin> decisive; ///< the narrowest margin, or the place that decides
};

bool names_a_place(const Condition& condition) {
    return std::ranges::any_of(condition, [](const Relation& r) {
        std::set<std::string> names = free_symbols(r.lhs);
        names.merge(free_symbols(r.rhs));
        return names.contains("x") || names.contains("u");
    });
}

std::string fraction_text(const Real& fraction) { return to_decimal(fraction, 10); }

RelationInScene without_place(const ConditionInScene& condition) {
    RelationInScene result;
    result.decisive = condition.margin(nullptr);
    if (result.decisive) {
        result.places = 1;
        result.decision = condition.decide_at(nullptr).value_or(Decision());
    }
    return result;
}

/// Combines the decisions at all places: one place that fails decides. The places with the
/// narrowest margins are checked first. Counts the places at which enclosures decided.
Decision all_of(const ConditionInScene& condition, std::vector<Margin> places, std::size_t& count) {
    std::ranges::stable_sort(places, {}, &Margin::value);
    Decision all;
    bool open = false;
    for (const Margin& place : places) {
        if (open && place.value > 0) {
            break; // according to the values in Real, no later place fails
        }
        const auto one = condition.decide_at(&place.fraction);
        if (!one) {
            continue;
        }
        ++count;
        if (refutes(*one)) {
            return *one;
        }
        open = open || !confirms(*one);
        all = *one;
    }
    return open ? Decision() : all;
}

/// The decision at all places, if it is the same at each.
Decision same_at_all(const std::vector<Decision>& decisions) {
    const bool same = !decisions.empty() && (std::ranges::all_of(decisions, confirms) ||
                                             std::ranges::all_of(decisions, refutes));
    return same ? decisions.back() : Decision();
}

/// The condition everywhere in a contact, or somewhere.
RelationInScene in_contact(const ConditionInScene& condition, const Real& nearest, bool somewhere) {
    RelationInScene result;
    const MarginScan scan(condition, nearest);
    const std::vector<Margin>& places = scan.places();
    result.places = places.size();
    if (places.empty()) {
        return result;
    }
    result.decisive = somewhere ? *std::ranges::max_element(places, {}, &Margin::value)
                                : *std::ranges::min_element(places, {}, &Margin::value);
    if (!somewhere) {
        std::size_t enclosed = 0;
        result.decision = all_of(condition, places, enclosed);
        if (confirms(result.decision)) {
            result.places = enclosed;
            result.decision = scan.nearly_changes(true) ? Decision() : result.decision;
        }
    } else if (result.decisive->clear && result.decisive->value > 0) {
        const auto there = condition.decide_at(&result.decisive->fraction);
        result.decision = there && confirms(*there) ? *there : Decision();
    } else if (!scan.nearly_changes(false)) {
        // The scan has also tried places between these where the sides come close to each other;
        // its completeness is sampled, not proved.
        std::vector<Decision> decisions;
        for (const Margin& place : places) {
            decisions.push_back(condition.decide_at(&place.fraction).value_or(Decision()));
        }
        const Decision same = same_at_all(decisions);
        result.decision = refutes(same) ? same : Decision();
    }
    return result;
}

/// The same for these distances, of which it keeps the narrowest margin.
Decision same_near(const ConditionInScene& condition, const std::vector<Real>& fractions,
                   RelationInScene& result) {
    std::vector<Decision> decisions;
    for (const Real& fraction : fractions) {
        if (const auto margin = condition.margin(&fraction)) {
            ++result.places;
            decisions.push_back(condition.decide_at(&fraction).value_or(Decision()));
            if (margin->clear && (!result.decisive || margin->value < result.decisive->value)) {
                result.decisive = margin;
            }
        }
    }
    return same_at_all(decisions);
}

/// Near the edge the condition holds, or fails, if it does at 11 distances: from 10^10 times
/// `nearest` to `nearest`. An approximation agrees there with the exact value to all digits
/// computed. Therefore an equality must also hold between the edge and the nearest knot, where both
/// sides are analytic functions.
RelationInScene near_edge(const ConditionInScene& condition, const Real& nearest,
                          bool has_equality) {
    RelationInScene result;
    std::vector<Real> near;
    for (int k = 0; k <= 10; ++k) {
        near.push_back(nearest * pow(Real(10), k));
    }
    result.decision = same_near(condition, near, result);
    if (has_equality && confirms(result.decision)) {
        const auto knots = condition.knots();
        const Real stretch = knots.empty() ? Real(1) : knots.front();
        const Decision farther = same_near(
            condition, {stretch / 1000, stretch / 30, stretch / 7, stretch * 2 / 5}, result);
        if (!confirms(farther)) {
            result.decision = {};
        }
    }
    return result;
}

/// The condition, with the same formula on both sides of a relation whose sides are equal in
/// symbols.
PrintedCondition condition_of(const Claim& claim, const AuditContext& context) {
    PrintedCondition read = printed_condition(claim);
    const Family& family = context.ledger().family(claim.text("over"));
    if (family.axisymmetric()) {
        return read; // the derivations are those of plane contacts
    }
    SymbolicCase under = case_of_powers(claim, context);
    under.full_stick = !family.has("friction") && family.union_of.empty();
    for (Condition* condition : {&read.as_printed, &read.named}) {
        for (Relation& r : *condition) {
            try {
                if (proved_equal(r.lhs, r.rhs, under)) {
                    r.rhs = r.lhs;
                }
            } catch (const Error&) {
                continue; // without algebra
            }
        }
    }
    return read;
}

/// Returns the negated condition; it must be a single inequality.
Condition opposite(const Claim& claim, const Condition& condition) {
    using Op = Relation::Op;
    if (condition.size() != 1 || condition.front().op == Op::equal) {
        claim.reject("says", "`holds = \"nowhere\"` needs a single inequality",
                     "write a separate claim for each inequality");
    }
    constexpr std::array negated{Op::greater_equal, Op::greater, Op::less_equal, Op::less};
    Relation r = condition.front();
    r.op = negated.at(static_cast<std::size_t>(r.op));
    return {r};
}

/// `equal`: " to 45 digits" for a condition with `=`.
Outcome summed_up(const std::vector<RelationInScene>& found, const std::string& holds,
                  const std::string& equal) {
    std::size_t places = 0;
    std::vector<const RelationInScene*> failing;
    std::vector<Decision> decisions;
    const RelationInScene* narrowest = nullptr;
    for (const RelationInScene& f : found) {
        places += f.places;
        decisions.push_back(f.decision);
        if (f.decisive &&
            (narrowest == nullptr || f.decisive->value < narrowest->decisive->value)) {
            narrowest = &f;
        }
        if (refutes(f.decision)) {
            failing.push_back(&f);
        }
    }
    const auto unclear = std::ranges::count_if(decisions, is_open);
    Outcome outcome;
    outcome.evidence.update({{"holds", holds},
                             {"scenes", found.size()},
                             {"places", places},
                             {"scenes_failing", failing.size()}});
    if (unclear > 0) {
        outcome.evidence["scenes_unclear"] = unclear;
    }
    if (narrowest != nullptr) {
        const Margin& margin = *narrowest->decisive;
        outcome.evidence.update({{"narrowest_margin", value_text(margin.value, 12)},
                                 {"narrowest_at", narrowest->scene}});
        if (margin.fraction > 0) {
            outcome.evidence["narrowest_at_u_over_L"] = fraction_text(margin.fraction);
        }
    }
    const std::string of_scenes = std::to_string(found.size()) + " scenes";
    outcome.verdict = Judgement::of_all(decisions);
    if (!failing.empty()) {
        outcome.note = "fails in " + std::to_string(failing.size()) + " of " + of_scenes +
                       ", as in " + failing.front()->scene;
        if (const auto& place = failing.front()->decisive;
            holds != "somewhere" && place && place->fraction > 0) {
            outcome.note += " at u/L = " + fraction_text(place->fraction);
        }
    } else if (found.empty()) {
        outcome.note = "no sample fulfils the condition";
    } else if (unclear > 0 || places == 0) {
        outcome.note =
            "the enclosures do not decide in " + std::to_string(unclear) + " of " + of_scenes;
    } else {
        outcome.note = holds == "somewhere" ? "each of " + of_scenes + " has such places"
                                            : "holds" + equal + " at " + std::to_string(places) +
                                                  " places of " + of_scenes;
    }
    return outcome;
}

/// Shows both sides of the first relation that fails at a sample.
void add_failure(const Claim& claim, const Sample& sample, unsigned digits, Outcome& outcome) {
    constexpr unsigned digits_shown = 6;
    for (const Relation& r : claim.condition("says")) {
        const std::optional<Ball> left = enclosed(r.lhs, sample, digits);
        const std::optional<Ball> right = enclosed(r.rhs, sample, digits);
        SampleInBalls in_balls(sample, digits);
        if (!left || !right ||
            !refutes(decide({r}, in_balls, AuditContext::digits_needed(digits)))) {
            continue;
        }
        outcome.evidence["enclosures"] =
            pair_evidence(full_text(sample), "left_side", *left, "right_side", *right, digits);
        outcome.note += ", where the left side is " + to_decimal(left->midpoint(), digits_shown) +
                        " and the right side is " + to_decimal(right->midpoint(), digits_shown);
        return;
    }
}

/// True if a formula has the same value at the next value of a sweep, because the numbers in it do
/// not change.
bool is_constant(const Expr& f, const Sample& sample, const SymbolicCase& under) {
    try {
        const Expr derived = derive(f, under);
        const auto here = exact_value(derived, sample);
        return here && here == exact_value(derived, *sample.next);
    } catch (const Error&) {
        return false; // without algebra
    }
}

/// The condition at a sample of a sweep, with f instead of next(f) if f is constant.
PrintedCondition at_step(PrintedCondition condition, const Sample& sample,
                         const SymbolicCase& under) {
    for (Condition* relations : {&condition.as_printed, &condition.named}) {
        for (Relation& r : *relations) {
            const bool of_next = r.lhs.kind() == Expr::Kind::call && r.lhs.name() == "next";
            if (of_next && r.lhs.arg(0) == r.rhs && is_constant(r.rhs, sample, under)) {
                r.lhs = r.rhs;
            }
        }
    }
    return condition;
}

/// The condition at each value of a sweep and the next one.
Outcome along_sweep(const Claim& claim, const AuditContext& context) {
    const Sweep sweep = sweep_of(claim, context);
    const std::string& along = claim.text("along");
    const PrintedCondition condition = condition_of(claim, context);
    const SymbolicCase under = case_of_powers(claim, context);
    std::vector<Decision> decisions;
    std::vector<std::string> against;
    const Sample* first = nullptr;
    for (std::size_t k = 0; k < sweep.samples.front().size(); ++k) {
        for (std::size_t j = 0; j + 1 < sweep.values.size(); ++j) {
            const Sample& sample = sweep.samples[j][k];
            const ConditionInScene here(sample, at_step(condition, sample, under), std::nullopt,
                                        context.digits());
            decisions.push_back(here.decide_at(nullptr).value_or(Decision()));
            if (refutes(decisions.back()) &&
                (first == nullptr || first->scene.text() == sample.scene.text())) {
                against.push_back(along + " = " + sweep.values[j] + " to " + sweep.values[j + 1]);
                first = first == nullptr ? &sample : first;
            }
        }
    }
    const auto good = std::ranges::count_if(decisions, confirms);
    const auto bad = std::ranges::count_if(decisions, refutes);
    Outcome outcome;
    outcome.verdict = Judgement::of_all(decisions);
    outcome.evidence.update({{"along", along},
                             {"values_taken", sweep.values},
                             {"samples", sweep.samples.front().size()},
                             {"steps_as_claimed", good},
                             {"steps_against", bad}});
    const std::string steps = std::to_string(decisions.size()) + " steps";
    if (first != nullptr) {
        outcome.evidence.update({{"against_at", full_text(*first)}, {"against", against}});
        outcome.note =
            "fails at " + std::to_string(bad) + " of " + steps + ", as from " + against.front();
        add_failure(claim, *first, context.digits(), outcome);
    } else {
        outcome.note = outcome.verdict == Verdict::undecided
                           ? "some steps are too small for the enclosures"
                           : "holds at each of " + steps + " (sampled)";
    }
    return outcome;
}

} // namespace

Outcome check_condition(const Claim& claim, const AuditContext& context) {
    if (claim.has("along")) {
        return along_sweep(claim, context);
    }
    const std::string holds = claim.text_or("holds", "everywhere");
    PrintedCondition condition = condition_of(claim, context);
    if (holds == "nowhere") {
        condition.as_printed = opposite(claim, condition.as_printed);
        condition.named = opposite(claim, condition.named);
    }
    std::optional<Condition> where;
    if (claim.has("where")) {
        where = claim.condition("where");
    }
    const bool placed = names_a_place(condition.as_printed) || (where && names_a_place(*where));
    const bool has_equality =
        std::ranges::count(condition.as_printed, Relation::Op::equal, &Relation::op) > 0;
    // Near the edge, sides that differ by the next term of a series agree to many digits.
    const unsigned digits = context.digits() + (holds == "near-edge" && has_equality ? 50 : 0);
    const PrecisionScope scope(digits + 20);
    const Real nearest = pow(Real(10), holds == "near-edge" ? -40 : -10);
    std::vector<RelationInScene> found;
    std::size_t left_out = 0;
    std::optional<Sample> failing; // the first, of a condition without a place
    for (const Sample& sample : context.different_samples(claim)) {
        const ConditionInScene in_scene(sample, condition, where, digits);
        RelationInScene result = !placed ? without_place(in_scene)
                                 : holds == "near-edge"
                                     ? near_edge(in_scene, nearest, has_equality)
                                     : in_contact(in_scene, nearest, holds == "somewhere");
        if (result.places == 0) { // `where` admits no place in this scene
            ++left_out;
        } else {
            if (!placed && !failing && refutes(result.decision)) {
                failing = sample;
            }
            result.scene = full_text(sample);
            found.push_back(std::move(result));
        }
    }
    const std::string to_digits =
        " to " + std::to_string(AuditContext::digits_needed(digits)) + " digits";
    Outcome outcome = summed_up(found, holds, has_equality ? to_digits : "");
    if (failing) {
        add_failure(claim, *failing, context.digits(), outcome);
    }
    if (left_out > 0) {
        outcome.evidence["scenes_left_out"] = left_out;
    }
    return outcome;
}

} // namespace edgeproof::audit

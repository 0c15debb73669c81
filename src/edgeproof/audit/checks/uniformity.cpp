// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/checks/tail/followed.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Course = FollowedRest::Course;

constexpr unsigned decades_to_the_breakdown = 20; // decades towards the place of the breakdown
constexpr unsigned rest_digits_shown = 12;

std::size_t count(const std::vector<FollowedRest>& all, Course course) {
    return static_cast<std::size_t>(std::ranges::count(all, course, &FollowedRest::course));
}

const FollowedRest* first_of(const std::vector<FollowedRest>& all, Course course) {
    const auto it = std::ranges::find(all, course, &FollowedRest::course);
    return it == all.end() ? nullptr : &*it;
}

std::string name_of(Course course) {
    switch (course) {
    case Course::nothing:
        return "nothing is left";
    case Course::bounded:
        return "bounded";
    case Course::grows:
        return "grows without bound";
    case Course::wrong_order:
        return "grows as the small variable falls, everywhere";
    case Course::unknown:
        break;
    }
    return "not known";
}

/// Returns the remainder's last step, much smaller than the largest remainder if it is bounded.
Ball last_step(const FollowedRest& rest) { return abs(rest.last - rest.before_last); }

/// Returns the enclosures that show that the remainder is bounded, or that it grows.
Evidence ends_of(const FollowedRest& rest, unsigned digits) {
    const std::string at = rest.sample.text() + ", down to the distance " + rest.last_distance;
    return rest.course == Course::bounded
               ? pair_evidence(at, "last step", last_step(rest), "largest that is left",
                               rest.largest, digits)
               : pair_evidence(at, "left before", rest.before_last, "left there", rest.last,
                               digits);
}

Evidence scene_evidence(const FollowedRest& rest) {
    const bool unknown = rest.course == Course::unknown;
    return Evidence()
        .add("left", name_of(rest.course))
        .add(unknown ? "because" : "at_" + rest.last_distance,
             unknown ? rest.problem : ball_text(rest.last, rest_digits_shown));
}

/// For a remainder that is zero at every sample: symbols decide if the expansion is exact.
void judge_nothing_left(const Claim& claim, const AuditContext& context, bool says_breaks,
                        const FollowedRest& rest, Outcome& outcome) {
    outcome.note = "the enclosures do not distinguish the remainder from zero";
    try {
        if (!proved_equal(claim.formula("of"), claim.formula("approximation"),
                          symbolic_case(claim, context))) {
            return;
        }
    } catch (const InputError&) {
        throw;
    } catch (const Error&) {
        return; // functions without a symbolic form: not proved
    }
    outcome.note =
        "the remainder is zero, proved by symbols: the expansion is exact and does not break down";
    if (!says_breaks) {
        outcome.verdict = Judgement::proved_by_symbols();
        return;
    }
    const Ball bound(1, rest.last.bits());
    if (const auto fails = Refutation::less(rest.last, bound)) {
        outcome.verdict = Judgement(*fails);
        outcome.evidence.add("enclosures",
                             pair_evidence(rest.sample.text(), "left there", rest.last, "bound",
                                           bound, context.digits()));
    }
}

/// Sets the verdict and its note from the samples that decide.
void judge_rests(const std::vector<FollowedRest>& all, const ExpansionToFollow& expansion,
                 bool says_breaks, unsigned digits, Outcome& outcome) {
    const std::string over =
        "the remainder divided by " + expansion.small + "^" + std::to_string(expansion.order);
    const std::string as = " as " + expansion.variable + " -> " + expansion.towards.text();
    const std::size_t bounded = count(all, Course::bounded);
    const FollowedRest* grows = first_of(all, Course::grows);
    const FollowedRest* wrong = first_of(all, Course::wrong_order);
    const FollowedRest* unknown = first_of(all, Course::unknown);
    const FollowedRest* one = nullptr;
    std::optional<std::pair<Ball, Ball>> less; // the first is less than the second
    if (!says_breaks && (grows != nullptr || wrong != nullptr)) {
        one = grows != nullptr ? grows : wrong;
        outcome.note = grows != nullptr ? over + " grows without bound" + as
                                        : over + " grows as " + expansion.small + " falls";
        less.emplace(one->before_last, one->last);
    } else if (unknown != nullptr) {
        outcome.note = unknown->problem;
        return;
    } else if (bounded > 0 && grows == nullptr && wrong == nullptr) {
        one = first_of(all, Course::bounded);
        outcome.note =
            over + " stays bounded" + as + ", in all of " + std::to_string(bounded) + " samples";
        less.emplace(last_step(*one) * 2, one->largest);
    } else if (says_breaks && grows != nullptr && bounded == 0 && wrong == nullptr) {
        one = grows;
        outcome.note = over + " grows without bound" + as;
        less.emplace(one->before_last, one->last);
    } else {
        outcome.note = wrong != nullptr
                           ? over + " grows as " + expansion.small + " falls, not only" + as
                           : "it breaks down at " + std::to_string(count(all, Course::grows)) +
                                 " samples, not at " + std::to_string(bounded);
        return;
    }
    const bool as_claimed = says_breaks == (one->course != Course::bounded);
    outcome.verdict =
        Judgement(as_claimed ? decision(std::nullopt, Confirmation::less(less->first, less->second))
                             : decision(Refutation::less(less->first, less->second), std::nullopt));
    outcome.evidence.add("enclosures", ends_of(*one, digits));
}

} // namespace

Outcome check_uniformity(const Claim& claim, const AuditContext& context) {
    const unsigned digits = context.digits();
    const ExpansionToFollow expansion{
        claim.formula("of"),    claim.formula("approximation"),
        claim.text("small"),    static_cast<unsigned>(claim.integer("order")),
        claim.text("variable"), Exact::parse(claim.text("towards"))};
    const bool says_breaks = claim.text("says") == "breaks down";
    Outcome outcome;
    Evidence in_scenes;
    std::vector<FollowedRest> all;
    for (const Sample& sample : context.samples(claim)) {
        check_interruption();
        if (!sample.variables.contains(expansion.small)) {
            claim.reject("vary", "vary does not state how small " + expansion.small + " is",
                         "write vary = { " + expansion.small + " = [\"b*1e-6\"] }");
        }
        all.push_back(follow_rest(sample, expansion, digits));
        in_scenes.add(sample.text(), scene_evidence(all.back()));
    }
    outcome.evidence.add("of", claim.text("of"))
        .add("approximation", claim.text("approximation"))
        .add("samples", all.size())
        .add("break_down", count(all, Course::grows))
        .add("uniform", count(all, Course::bounded))
        .add("in_scenes", in_scenes);
    if (count(all, Course::nothing) == all.size()) {
        judge_nothing_left(claim, context, says_breaks, all.front(), outcome);
        return outcome;
    }
    judge_rests(all, expansion, says_breaks, digits, outcome);
    // The first sample at which the printed term breaks down and the remainder does not.
    const FollowedRest* one = first_of(all, Course::bounded);
    if (one != nullptr && claim.has("term") && outcome.verdict != Verdict::undecided &&
        certainly_grows(claim.formula("term"), one->sample, expansion, digits)) {
        const Sample at = at_distance(one->sample, expansion, decades_to_the_breakdown, true);
        outcome.evidence.add("enclosures",
                             pair_evidence(at.text(), "printed",
                                           enclosed(claim.formula("term"), at, digits), "exact",
                                           enclosed(expansion.rest(), at, digits), digits));
    }
    return outcome;
}

} // namespace edgeproof::audit

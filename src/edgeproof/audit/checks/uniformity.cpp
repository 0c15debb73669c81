// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/checks/tail/followed_rest.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Course = FollowedRest::Course;

constexpr unsigned decades_to_the_breakdown = 20; // decades towards the place of the breakdown
constexpr unsigned rest_digits_shown = 12;

/// One sample and its remainder.
struct FollowedSample {
    Sample sample;
    FollowedRest rest;
};

std::size_t count(const std::vector<FollowedSample>& all, Course course) {
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(),
                      [&](const FollowedSample& one) { return one.rest.course() == course; }));
}

const FollowedSample* first_of(const std::vector<FollowedSample>& all, Course course) {
    const auto it = std::find_if(all.begin(), all.end(), [&](const FollowedSample& one) {
        return one.rest.course() == course;
    });
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

/// Returns the printed term and the exact remainder at the distance 1e-20.
ComparedNumbers at_the_last_place(const ExpansionToFollow& expansion, const Sample& sample,
                                  const formula::Expr& term, unsigned digits) {
    const Sample at = at_distance(sample, expansion, decades_to_the_breakdown, true);
    return {"printed", enclosed(term, at, digits), "exact", enclosed(expansion.rest(), at, digits),
            at.text()};
}

/// Returns the remainder's last step, much smaller than the largest remainder if it is bounded.
Ball last_step(const FollowedSample& one) { return abs(one.rest.last() - one.rest.before_last()); }

/// Returns the enclosures that show that the remainder is bounded, or that it grows.
ComparedNumbers ends_of(const FollowedSample& one) {
    const std::string at = one.sample.text() + ", down to the distance " + one.rest.last_distance();
    if (one.rest.course() == Course::bounded) {
        return {"last step",
                {last_step(one), ""},
                "largest that is left",
                {one.rest.largest(), ""},
                at};
    }
    return {"left before", {one.rest.before_last(), ""}, "left there", {one.rest.last(), ""}, at};
}

Evidence scene_evidence(const FollowedSample& one) {
    Evidence found;
    found.add("left", name_of(one.rest.course()));
    if (one.rest.course() == Course::unknown) {
        found.add("because", one.rest.problem());
    } else {
        found.add("at_" + one.rest.last_distance(), ball_text(one.rest.last(), rest_digits_shown));
    }
    return found;
}

ExpansionToFollow expansion_of(const Claim& claim) {
    return {claim.formula("of"),    claim.formula("approximation"),
            claim.text("small"),    static_cast<unsigned>(claim.integer("order")),
            claim.text("variable"), formula::Exact::parse(claim.text("towards"))};
}

/// For a remainder that is zero at every sample: symbols decide if the expansion is exact.
void judge_nothing_left(const Claim& claim, const AuditContext& context, bool says_breaks,
                        const FollowedSample& one, Outcome& outcome) {
    outcome.note = "the enclosures do not distinguish the remainder from zero";
    bool exact = false;
    try {
        exact = proved_equal(claim.formula("of"), claim.formula("approximation"),
                             symbolic_case(claim, context));
    } catch (const InputError&) {
        throw;
    } catch (const Error&) {
        // functions without a symbolic form: not proved
    }
    if (!exact) {
        return;
    }
    outcome.note =
        "the remainder is zero, proved by symbols: the expansion is exact and does not break down";
    if (!says_breaks) {
        outcome.verdict = Judgement::proved_by_symbols();
        return;
    }
    const Ball bound(1, one.rest.last().bits());
    if (const auto fails = Refutation::less(one.rest.last(), bound)) {
        outcome.verdict = Judgement(*fails);
        add_pair({"left there", {one.rest.last(), ""}, "bound", {bound, ""}, one.sample.text()},
                 context.digits(), outcome.evidence);
    }
}

/// Sets the verdict and its note from the samples that decide.
void judge_rests(const std::vector<FollowedSample>& all, const ExpansionToFollow& expansion,
                 bool says_breaks, unsigned digits, Outcome& outcome) {
    const std::string over =
        "the remainder divided by " + expansion.small + "^" + std::to_string(expansion.order);
    const std::string as = " as " + expansion.variable + " -> " + expansion.towards.text();
    const std::size_t bounded = count(all, Course::bounded);
    const FollowedSample* grows = first_of(all, Course::grows);
    const FollowedSample* wrong = first_of(all, Course::wrong_order);
    const FollowedSample* unknown = first_of(all, Course::unknown);
    const FollowedSample* one = nullptr;
    if (!says_breaks && (grows != nullptr || wrong != nullptr)) {
        one = grows != nullptr ? grows : wrong;
        outcome.note = grows != nullptr ? over + " grows without bound" + as
                                        : over + " grows as " + expansion.small + " falls";
        if (const auto fails = Refutation::less(one->rest.before_last(), one->rest.last())) {
            outcome.verdict = Judgement(*fails);
        }
    } else if (unknown != nullptr) {
        outcome.note = unknown->rest.problem();
        return;
    } else if (bounded > 0 && grows == nullptr && wrong == nullptr) {
        one = first_of(all, Course::bounded);
        outcome.note =
            over + " stays bounded" + as + ", in all of " + std::to_string(bounded) + " samples";
        if (const auto fails = Refutation::less(last_step(*one) * 2, one->rest.largest());
            says_breaks && fails) {
            outcome.verdict = Judgement(*fails);
        }
        if (const auto holds = Confirmation::less(last_step(*one) * 2, one->rest.largest());
            !says_breaks && holds) {
            outcome.verdict = Judgement(*holds);
        }
    } else if (says_breaks && grows != nullptr && bounded == 0 && wrong == nullptr) {
        one = grows;
        outcome.note = over + " grows without bound" + as;
        if (const auto holds = Confirmation::less(one->rest.before_last(), one->rest.last())) {
            outcome.verdict = Judgement(*holds);
        }
    } else {
        outcome.note = wrong != nullptr
                           ? over + " grows as " + expansion.small + " falls, not only" + as
                           : "it breaks down at " + std::to_string(count(all, Course::grows)) +
                                 " samples, not at " + std::to_string(bounded);
        return;
    }
    add_pair(ends_of(*one), digits, outcome.evidence);
}

/// Checks if an expansion breaks down as another variable tends to a limit: then the remainder
/// divided by the next power must grow.
Outcome check_uniformity(const Claim& claim, const AuditContext& context) {
    const ExpansionToFollow expansion = expansion_of(claim);
    const bool says_breaks = claim.text("says") == "breaks down";
    Outcome outcome;
    Evidence in_scenes;
    std::vector<FollowedSample> all;
    for (const Sample& sample : context.samples(claim)) {
        check_interruption();
        if (!sample.variables.contains(expansion.small)) {
            claim.reject("vary", "vary does not state how small " + expansion.small + " is",
                         "write vary = { " + expansion.small + " = [\"b*1e-6\"] }");
        }
        all.push_back({sample, FollowedRest(sample, expansion, context.digits())});
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
    judge_rests(all, expansion, says_breaks, context.digits(), outcome);
    // The first sample at which the printed term breaks down and the remainder does not.
    const FollowedSample* one = first_of(all, Course::bounded);
    if (one != nullptr && claim.has("term") && outcome.verdict != Verdict::undecided &&
        certainly_grows(claim.formula("term"), one->sample, expansion, context.digits())) {
        add_pair(at_the_last_place(expansion, one->sample, claim.formula("term"), context.digits()),
                 context.digits(), outcome.evidence);
    }
    return outcome;
}

} // namespace

CheckKind uniformity_kind() {
    using Type = KeySpec::Type;
    return {"uniformity",
            {{.name = "says",
              .type = Type::choice,
              .required = true,
              .choices = {"breaks down", "uniform"}},
             required_formula("of"),
             required_formula("approximation"),
             optional_formula("term"),
             {.name = "small", .required = true},
             {.name = "order", .type = Type::integer, .required = true},
             {.name = "variable", .required = true},
             {.name = "towards", .type = Type::number, .required = true}},
            check_uniformity};
}

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/tail/followed.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// The values at both ends of a step, with as many digits as needed to show which one is larger.
struct Step {
    Enclosed from;
    Enclosed to;
    Decision as_claimed;
};

Step take_step(const Sample& from, const Sample& to, const Expr& of, bool rising, unsigned digits) {
    Step step;
    const std::string problem = look_closer(
        [&](long bits) {
            step.from.ball = EnclosedSample(from, bits).finite(of);
            step.to.ball = EnclosedSample(to, bits).finite(of);
            const Ball& lesser = rising ? *step.from.ball : *step.to.ball;
            const Ball& greater = rising ? *step.to.ball : *step.from.ball;
            step.as_claimed =
                decision(Refutation::less(greater, lesser), Confirmation::less(lesser, greater));
            return !is_open(step.as_claimed);
        },
        bits_to_decide(digits));
    step.from.problem = step.to.problem = problem;
    return step;
}

std::string enclosed_text(const Enclosed& x) {
    return x.ball ? ball_text(*x.ball, 12) : "none: " + x.problem;
}

} // namespace

Outcome check_monotone(const Claim& claim, const AuditContext& context) {
    const bool rising = claim.text("sense") == "increasing";
    const ParameterSweep sweep(claim, context);
    const std::size_t steps_of_one = sweep.values().size() - 1;
    std::vector<Step> steps; // of the first sample, then of the second, ...
    std::vector<Decision> decisions;
    for (std::size_t k = 0; k < sweep.samples(); ++k) {
        for (std::size_t j = 0; j < steps_of_one; ++j) {
            check_interruption();
            steps.push_back(take_step(sweep.sample_at(j, k), sweep.sample_at(j + 1, k),
                                      claim.formula("of"), rising, context.digits()));
            decisions.push_back(steps.back().as_claimed);
        }
    }
    const auto good = static_cast<std::size_t>(std::ranges::count_if(decisions, confirms));
    const auto bad = static_cast<std::size_t>(std::ranges::count_if(decisions, refutes));
    const std::size_t unclear = decisions.size() - good - bad;
    // The first sample with a step against the claim is shown, or else the first one.
    const auto first_bad =
        static_cast<std::size_t>(std::ranges::find_if(decisions, refutes) - decisions.begin());
    const std::size_t shown = bad > 0 ? first_bad / steps_of_one : 0;
    std::vector<std::string> values;
    std::vector<std::string> bad_steps;
    const Step* against = nullptr; // the largest
    std::string against_step;
    for (std::size_t j = 0; j < steps_of_one; ++j) {
        const Step& step = steps[shown * steps_of_one + j];
        values.push_back(enclosed_text(step.from));
        if (!refutes(step.as_claimed)) {
            continue;
        }
        bad_steps.push_back(sweep.name() + " = " + sweep.values()[j] + " to " +
                            sweep.values()[j + 1]);
        const auto change = [](const Step& s) { return abs(*s.to.ball - *s.from.ball).midpoint(); };
        if (against == nullptr || change(*against) < change(step)) {
            against = &step;
            against_step = bad_steps.back();
        }
    }
    values.push_back(enclosed_text(steps[(shown + 1) * steps_of_one - 1].to));
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("along", sweep.name())
        .add("values_taken", sweep.values())
        .add("samples", sweep.samples())
        .add("steps_as_claimed", good)
        .add("steps_against", bad);
    if (unclear > 0) {
        outcome.evidence.add("steps_unclear", unclear);
    }
    outcome.evidence.add("values", values);
    outcome.verdict = Judgement::of_all(decisions);
    if (against != nullptr) {
        const Sample& sample = sweep.sample_at(0, shown);
        const std::string at = full_text(sample);
        outcome.evidence.add("against_at", at)
            .add("against", bad_steps)
            .add("enclosures", pair_evidence(at + "; " + against_step, "before", against->from,
                                             "after", against->to, context.digits()));
        outcome.note = (rising ? "falls from " : "grows from ") + bad_steps.front() + " (" +
                       std::to_string(bad) + " of " + std::to_string(decisions.size()) + " steps)";
    } else if (outcome.verdict == Verdict::undecided) {
        outcome.note = "some steps are too small for the enclosures";
    } else {
        outcome.note = (rising ? "grows" : "falls") + std::string(" at each of ") +
                       std::to_string(good) + " steps (sampled)";
    }
    return outcome;
}

namespace {

std::string listed_text(const Expr& of, const Sample& sample) {
    constexpr unsigned digits_shown = 12;
    const Enclosed value = enclosed(of, sample, digits_shown);
    try {
        return value.ball ? ball_text(*value.ball, digits_shown) : "none: " + value.problem;
    } catch (const Error&) {
        return "beyond the range of decimals";
    }
}

} // namespace

Outcome check_limit(const Claim& claim, const AuditContext& context) {
    const bool infinite = claim.text("limit") == "infinity";
    const LimitClaimed claimed{claim.formula("of"),
                               infinite ? std::nullopt : std::optional(claim.formula("limit"))};
    const ParameterSweep sweep(claim, context);
    std::vector<FollowedTail> tails;
    std::vector<Decision> decisions;
    for (std::size_t k = 0; k < sweep.samples(); ++k) {
        tails.push_back(follow_tail(sweep, k, claimed, context.digits()));
        decisions.push_back(tails.back().decision);
        if (refutes(decisions.back())) {
            break;
        }
    }
    // The sample that is shown refutes the claim, or is not decided, or is the first.
    const bool refuted = refutes(decisions.back());
    const auto open = std::ranges::find_if(decisions, is_open);
    const auto shown = static_cast<std::size_t>(refuted                   ? decisions.size() - 1
                                                : open != decisions.end() ? open - decisions.begin()
                                                                          : 0);
    const FollowedTail& tail = tails[shown];
    const Sample& last = sweep.last_sample(shown);
    const std::string at = full_text(last);
    std::vector<std::string> values;
    for (std::size_t j = 0; j < sweep.values().size(); ++j) {
        values.push_back(listed_text(claimed.of, sweep.sample_at(j, shown)));
    }
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("limit", claim.text("limit"))
        .add("along", sweep.name())
        .add("values_taken", sweep.values())
        .add("samples", sweep.samples())
        .add("at", at)
        .add("values", values);
    if (tail.target) {
        outcome.evidence.add("goes_to", *tail.target).add("followed", tail.texts);
    }
    if (tail.compared) {
        outcome.evidence.add("enclosures", *tail.compared);
    }
    outcome.verdict = Judgement::of_all(decisions);
    const unsigned decades =
        refuted ? tail.decades : std::ranges::min(tails, {}, &FollowedTail::decades).decades;
    const std::string far = "followed by 10^" + std::to_string(decades);
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = (infinite ? "grows without bound at "
                                 : "the distance from the limit tends to zero at ") +
                       std::to_string(sweep.samples()) + " samples (sampled; " + far + ")";
    } else if (outcome.verdict == Verdict::refuted) {
        outcome.note =
            (infinite ? "does not grow without bound: " : "does not approach the limit: ") + at +
            " (" + far + ")";
    } else {
        outcome.note = tail.problem;
    }
    return outcome;
}

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/tail/followed_tail.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

std::string listed_text(const formula::Expr& of, const Sample& sample) {
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

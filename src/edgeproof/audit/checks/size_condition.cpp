// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/sizes.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace edgeproof::audit {
namespace {

std::string relation_text(const Relation& r) {
    static constexpr std::array signs{" < ", " <= ", " > ", " >= ", " = "};
    return to_text(r.lhs) + signs.at(static_cast<std::size_t>(r.op)) + to_text(r.rhs);
}

} // namespace

/// A finite list of sizes confirms a condition only at these sizes, as the note states; if it fails
/// at all of them, it may still hold between them.
Outcome check_size_condition(const Claim& claim, const AuditContext& context) {
    const auto [scene, scan] = sized_scene(claim, context);
    const auto sample_at = [&, &sized = scene](const Rational& a) {
        return SampleInBalls({with_size(sized, a), std::nullopt, claim.edge(), {}},
                             context.digits());
    };
    std::vector<SampleInBalls> samples;
    std::ranges::transform(scan.sizes(), std::back_inserter(samples), sample_at);
    // The condition holds where all its relations do.
    std::vector<Decision> decisions;
    SizeSet set;
    Evidence each;
    for (const Relation& r : claim.condition("says")) {
        std::vector<Side> sides;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Decision here = decide({r}, samples[i], context.digits_needed());
            sides.push_back(side_of(here));
            if (decisions.size() <= i) {
                decisions.push_back(here);
            } else if (refutes(here) || (is_open(here) && !refutes(decisions[i]))) {
                decisions[i] = here;
            }
        }
        const SizeSet holds = scan.where(sides, [&](const Rational& a) {
            SampleInBalls sample = sample_at(a);
            return side_of(decide({r}, sample, context.digits_needed()));
        });
        set = each.empty() ? holds : intersection(set, holds);
        each.add(relation_text(r), to_text(holds));
    }
    const bool some = std::ranges::any_of(decisions, confirms);
    const bool none = std::ranges::none_of(decisions, confirms);
    Outcome outcome;
    scan.describe(claim.list("sizes"), outcome.evidence);
    outcome.evidence.add("holds_for_a", to_text(set));
    const std::string looked_at = " (at " + std::to_string(scan.sizes().size()) + " sizes)";
    if (std::ranges::all_of(decisions, confirms)) {
        outcome.verdict = Judgement::of_all(decisions);
        outcome.note = "the size is not given, and it holds at every size" + looked_at;
    } else if (some && std::ranges::any_of(decisions, refutes)) {
        outcome.verdict = Undecided::underspecified;
        outcome.note = "the size is not given; it would hold for a = " + to_text(set);
        outcome.evidence.add("each_holds_for_a", each);
    } else {
        outcome.note = none ? "it holds at no size that was examined" + looked_at
                            : "the enclosures do not decide at some sizes";
    }
    return outcome;
}

} // namespace edgeproof::audit

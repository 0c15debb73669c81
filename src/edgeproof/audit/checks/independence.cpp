// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

/// The enclosure of a formula at a sample, and the scale with which its errors are compared.
struct EnclosedHere {
    Enclosed value;
    std::optional<Ball> scale;
};

EnclosedHere enclose_here(const Expr& e, const Sample& sample, unsigned digits) {
    EnclosedHere here{enclosed(e, sample, digits), std::nullopt};
    if (here.value.ball && !contains_zero(*here.value.ball)) {
        here.scale = abs(*here.value.ball);
    } else if (here.value.ball) {
        try {
            here.scale = scale_of_terms(e, EnclosedSample(sample, 2 * formula::bits_for(digits)));
        } catch (const Error&) {
            here.scale.reset(); // no part has an enclosure: only exact zeros count as equal
        }
    }
    return here;
}

} // namespace

Outcome check_independence(const Claim& claim, const AuditContext& context) {
    const Expr e = claim.formula("of");
    std::vector<Exact> fractions;
    for (const std::string& text : claim.list("at")) {
        fractions.push_back(Exact::parse(text));
    }
    Outcome outcome;
    std::vector<EnclosedHere> first; // in the first scene
    std::set<std::string> profiles;
    std::vector<Decision> decisions;
    std::string apart;
    double digits = 1e6;
    Evidence values;
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    for (const SceneSpec& scene : scenes) {
        profiles.insert(scene.profile);
        for (std::size_t k = 0; k < fractions.size(); ++k) {
            const EnclosedHere here =
                enclose_here(e, {scene, fractions[k], claim.edge(), {}}, context.digits());
            if (!here.value.ball) {
                outcome.note = "no enclosure: " + here.value.problem;
                return outcome;
            }
            if (first.size() == k) {
                first.push_back(here);
                values.add("u = " + fractions[k].text() + " L", ball_text(*here.value.ball, 20));
                continue;
            }
            const Ball& x = *here.value.ball;
            const Ball& y = *first[k].value.ball;
            const Ball scale = first[k].scale ? *first[k].scale : abs(y);
            const auto differs = Refutation::disjoint(x, y);
            decisions.push_back(
                decision(differs, Confirmation::agreement(x, y, scale, context.digits_needed())));
            const Real off = abs(x - y).upper();
            if (off > 0) {
                digits =
                    std::min(digits, Real(-log10(Real(off / scale.upper()))).convert_to<double>());
            }
            if (differs && apart.empty()) {
                apart = full_text(scene) + ", u = " + fractions[k].text() + " L";
                outcome.evidence.add(
                    "enclosures",
                    pair_evidence(apart, "there", x, "in_the_first_scene", y, context.digits()));
            }
        }
    }
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("profiles", std::vector<std::string>(profiles.begin(), profiles.end()))
        .add("digits", digits_text(std::min(digits, 1.0 * context.digits())))
        .add("values", values);
    if (scenes.size() < 2) {
        outcome.note = "one scene is not enough to decide";
        return outcome;
    }
    outcome.verdict = Judgement::of_all(decisions);
    outcome.note = outcome.verdict == Verdict::refuted ? "differs: " + apart
                   : outcome.verdict == Verdict::confirmed
                       ? "the same in " + std::to_string(scenes.size()) + " scenes of " +
                             std::to_string(profiles.size()) + " profiles"
                       : "the enclosures do not decide";
    return outcome;
}

} // namespace edgeproof::audit

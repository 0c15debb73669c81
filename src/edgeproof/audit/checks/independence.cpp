// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::audit {
namespace {

/// A formula that is to come out the same in all scenes, at each of some places: what differs
/// between the scenes, it does not depend on.
Outcome check_independence(const Claim& claim, const AuditContext& context) {
    const formula::Expr e = claim.formula("of");
    const contact::Edge edge = claim.edge();
    std::vector<formula::Exact> fractions;
    for (const std::string& text : claim.list("at")) {
        fractions.push_back(formula::Exact::parse(text));
    }
    Outcome outcome;
    std::vector<Real> first; // the values in the first scene
    std::set<std::string> profiles;
    double digits = 1e6;
    unsigned good = 1000000; // digits that the values are good for
    std::optional<Difference> against;
    std::string worst;
    Evidence values;
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    for (const SceneSpec& scene : scenes) {
        const EvaluatedScene scene_values(scene, context.digits());
        profiles.insert(scene.profile);
        for (std::size_t k = 0; k < fractions.size(); ++k) {
            const Place place = scene_values.place(edge, fractions[k]);
            const FormulaValue evaluated = scene_values.evaluate(e, &place);
            const Real& value = evaluated.value;
            if (!evaluated.converged || !isfinite(value)) {
                outcome.note =
                    "not evaluated here: " +
                    std::string(evaluated.converged ? "a number beyond the range of the arithmetic"
                                                    : "an integral did not converge");
                return outcome;
            }
            good = std::min(good, evaluated.digits);
            if (first.size() == k) {
                first.push_back(value);
                values.add("u = " + fractions[k].text() + " L", value_text(value, 20));
                continue;
            }
            const PrecisionScope scope(context.digits() + 20);
            const Real off = abs(Real(value - first[k]));
            const Real scale = abs(first[k]);
            const double agree = off == 0     ? 1e6
                                 : scale == 0 ? -1e6
                                              : (-log10(Real(off / scale))).convert_to<double>();
            if (agree < context.digits_needed() && !against) {
                const int known = static_cast<int>(good);
                against = Difference::of(value, first[k], Real(scale * pow(Real(10), 3 - known)));
            }
            if (agree < digits) {
                digits = agree;
                worst = scene.family + ": " + scene.text() + ", u = " + fractions[k].text() + " L";
            }
        }
    }
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("profiles", std::vector<std::string>(profiles.begin(), profiles.end()))
        .add("digits", digits_text(std::min(digits, 1.0 * context.digits())))
        .add("values", values);
    if (scenes.size() < 2) {
        outcome.note = "one scene shows nothing";
        return outcome;
    }
    const bool same = digits >= context.digits_needed();
    if (same && !against) {
        outcome.verdict = NotRefuted::confirmed;
    } else if (against) {
        outcome.verdict = Judgement(*against);
    } else {
        outcome.note = "the values are not good enough to decide";
        return outcome;
    }
    outcome.note = same ? "the same in " + std::to_string(scenes.size()) + " scenes of " +
                              std::to_string(profiles.size()) + " profiles"
                        : "differs: " + worst;
    return outcome;
}

} // namespace

CheckKind independence_kind() {
    using Type = KeySpec::Type;
    return {"independence",
            {required_formula("of"), {.name = "at", .type = Type::list, .required = true}},
            check_independence};
}

} // namespace edgeproof::audit

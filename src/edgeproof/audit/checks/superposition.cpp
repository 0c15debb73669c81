// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/sample/linear_loads.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {
namespace {

/// What two loads make of a quantity, each alone: of one sign they add, else they subtract. With
/// `when_zero` the second load is the one at which that formula vanishes.
Outcome check_superposition(const Claim& claim, const AuditContext& context) {
    const auto& loads = claim.list("loads");
    if (loads.size() != 2) {
        claim.reject("loads", "loads are not two", "write loads = [\"Q\", \"sig0\"]");
    }
    const formula::Expr of = claim.formula("of");
    const bool says_add = claim.text("says") == "add";
    Outcome outcome;
    std::size_t adding = 0;
    std::size_t subtracting = 0;
    std::optional<Difference> against; // a product of the other sign
    std::size_t same_signs = 0;
    Evidence shares;
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    for (const SceneSpec& scene : scenes) {
        const LinearLoads loaded(scene, context.digits(), loads[0], loads[1]);
        LinearLoads::Parts parts = loaded.parts(of);
        Real second = loaded.second();
        const PrecisionScope scope(context.digits() + 20);
        if (claim.has("when_zero")) {
            second = loaded.second_for_zero(claim.formula("when_zero"));
            parts.second *= second / loaded.second();
        }
        const Real product = parts.first * parts.second;
        if (!against && (says_add ? product < 0 : product > 0)) {
            against = Difference::of(Real(0), product, Real(0));
        }
        adding += product > 0 ? 1 : 0;
        subtracting += product < 0 ? 1 : 0;
        same_signs += (second > 0) == (scene.parameter(loads[0]).sign() > 0) ? 1 : 0;
        if (shares.entries().size() < 3 && parts.first != 0) {
            shares.add(scene.text(), value_text(Real(parts.second / parts.first), 20));
        }
    }
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("add", adding)
        .add("subtract", subtracting)
        .add("loads_of_one_sign", same_signs)
        .add("second_part_over_first", shares);
    const std::size_t as_said = says_add ? adding : subtracting;
    if (!scenes.empty() && as_said == scenes.size()) {
        outcome.verdict = NotRefuted::confirmed;
    } else if (adding + subtracting == scenes.size()) {
        outcome.verdict = Judgement(against);
    }
    outcome.note = "the parts of " + claim.text("of") + " by " + loads[0] + " and " + loads[1] +
                   " add in " + std::to_string(adding) + " of " + std::to_string(scenes.size()) +
                   " scenes, subtract in " + std::to_string(subtracting);
    return outcome;
}

} // namespace

CheckKind superposition_kind() {
    using Type = KeySpec::Type;
    return {
        "superposition",
        {{.name = "says", .type = Type::choice, .required = true, .choices = {"add", "subtract"}},
         required_formula("of"),
         optional_formula("when_zero"),
         {.name = "loads", .type = Type::list, .required = true}},
        check_superposition};
}

} // namespace edgeproof::audit

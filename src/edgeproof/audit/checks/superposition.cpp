// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_loads.hpp"
#include "edgeproof/audit/sample/linear_loads.hpp"

namespace edgeproof::audit {

Outcome check_superposition(const Claim& claim, const AuditContext& context) {
    const std::vector<std::string>& names = two_loads(claim);
    const bool says_add = claim.text("says") == "add";
    const formula::Expr of = claim.formula("of");
    std::size_t adding = 0;
    std::size_t subtracting = 0;
    std::size_t same_signs = 0;
    std::vector<Decision> decisions;
    Evidence shares;
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    for (const SceneSpec& scene : scenes) {
        // This checks in Real that the quantity is the sum of its parts.
        static_cast<void>(LinearLoads(scene, context.digits(), names[0], names[1]).parts(of));
        Decision found;
        const long first_bits = 2 * formula::bits_for(context.digits());
        for (long bits = first_bits; bits <= 8 * first_bits && is_open(found); bits *= 2) {
            EnclosedLoads loads(scene, names, bits);
            auto [first, second] = loads.parts(of);
            Ball second_load = loads.loads().second;
            if (claim.has("when_zero")) {
                second_load = loads.second_for_zero(claim.formula("when_zero"));
                second *= second_load / loads.loads().second;
            }
            const Ball product = says_add ? first * second : -(first * second);
            const Ball zero(0, bits);
            found = decision(Refutation::less(product, zero), Confirmation::less(zero, product));
            if (is_open(found)) {
                continue;
            }
            (certainly_positive(first * second) ? adding : subtracting) += 1;
            same_signs += certainly_positive(second_load * loads.loads().first) ? 1 : 0;
            if (shares.entries().size() < 3) {
                shares.add(scene.text(), ball_text(second / first, 20));
            }
        }
        decisions.push_back(found);
    }
    Outcome outcome;
    outcome.verdict = Judgement::of_all(decisions);
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("add", adding)
        .add("subtract", subtracting)
        .add("loads_of_one_sign", same_signs)
        .add("second_part_over_first", shares);
    outcome.note = "the parts of " + claim.text("of") + " by " + names[0] + " and " + names[1] +
                   " add in " + std::to_string(adding) + " of " + std::to_string(scenes.size()) +
                   " scenes, subtract in " + std::to_string(subtracting);
    return outcome;
}

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_loads.hpp"
#include "edgeproof/audit/sample/linear_loads.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {
namespace {

/// The contributions of two loads to a quantity in one scene.
struct Parts {
    Ball first;
    Ball second;
    Ball second_load;
};

Parts parts_in(EnclosedLoads& loads, const Claim& claim) {
    const formula::Expr of = claim.formula("of");
    Parts parts{loads.of_first(of), loads.of_second(of), loads.second()};
    if (claim.has("when_zero")) {
        parts.second_load = loads.second_for_zero(claim.formula("when_zero"));
        parts.second *= parts.second_load / loads.second();
    }
    return parts;
}

/// Checks the contributions of two loads to a quantity: with equal signs they add, otherwise they
/// subtract. With `when_zero` the second load is the one for which that formula vanishes.
Outcome check_superposition(const Claim& claim, const AuditContext& context) {
    const auto& loads = claim.list("loads");
    if (loads.size() != 2) {
        claim.reject("loads", "loads are not two", "write loads = [\"Q\", \"sig0\"]");
    }
    const bool says_add = claim.text("says") == "add";
    Outcome outcome;
    std::size_t adding = 0;
    std::size_t subtracting = 0;
    std::size_t same_signs = 0;
    std::vector<Decision> decisions;
    Evidence shares;
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    for (const SceneSpec& scene : scenes) {
        // This checks in Real that the quantity is the sum of its parts.
        static_cast<void>(
            LinearLoads(scene, context.digits(), loads[0], loads[1]).parts(claim.formula("of")));
        Decision found;
        const long first_bits = 2 * formula::bits_for(context.digits());
        for (long bits = first_bits; bits <= 8 * first_bits; bits *= 2) {
            EnclosedLoads in_balls(scene, loads[0], loads[1], bits);
            const Parts parts = parts_in(in_balls, claim);
            const Ball product = parts.first * parts.second;
            const Ball zero(0, bits);
            found =
                says_add
                    ? decision(Refutation::less(product, zero), Confirmation::less(zero, product))
                    : decision(Refutation::less(zero, product), Confirmation::less(product, zero));
            if (std::holds_alternative<std::monostate>(found)) {
                continue;
            }
            (certainly_positive(product) ? adding : subtracting) += 1;
            same_signs += certainly_positive(parts.second_load * in_balls.first()) ? 1 : 0;
            if (shares.entries().size() < 3) {
                shares.add(scene.text(), ball_text(parts.second / parts.first, 20));
            }
            break;
        }
        decisions.push_back(found);
    }
    outcome.verdict = Judgement::of_all(decisions);
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("add", adding)
        .add("subtract", subtracting)
        .add("loads_of_one_sign", same_signs)
        .add("second_part_over_first", shares);
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

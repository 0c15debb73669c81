// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_relative_error.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <map>
#include <memory>

namespace edgeproof::audit {

EnclosedReach enclosed_reach(const SceneSpec& scene, const ReachQuestion& question,
                             unsigned digits) {
    const contact::Profile profile = scene.make_profile();
    const contact::Load load = contact::Load::right_edge(scene.parameter("a"));
    std::map<long, std::unique_ptr<contact::ProvedContact>> contacts;
    const auto contact_at = [&](long bits) -> const contact::ProvedContact& {
        auto& made = contacts[bits];
        if (!made) {
            made = contact::proved_contact(profile, scene.parameter("Es"), load, bits);
        }
        return *made;
    };
    EnclosedReach reach;
    contact::BallExtentSearch search(contact_at, question.edge, question.terms, question.tolerance,
                                     question.range);
    const long needed = formula::bits_for(digits);
    reach.problem = look_closer(
        [&](long bits) {
            reach.extents = search.at(bits);
            reach.bits = bits;
            return true;
        },
        {2 * needed, 8 * needed});
    return reach;
}

namespace {

constexpr unsigned optimum_digits = 20;
constexpr unsigned shortfall_digits = 6;

} // namespace

ProvedOptimum proved_optimum(const contact::ReachProblem& problem,
                             const contact::ParameterRange& range, const Ball& claimed,
                             const std::string& parameter) {
    ProvedOptimum found;
    try {
        found.claimed_reach = proved_reach(problem, claimed).reach;
        contact::DesignOptions options;
        options.digits = optimum_digits + 5;
        // The best reach is not less than the reach of the claimed value.
        options.gap = contact::exact_value(
            Ball(Ball(found.claimed_reach.lower(), 64) / 1'000'000).with_bits(32).lower());
        found.best = best_reach(problem, range, options);
    } catch (const BudgetError& problem_found) {
        found.best.missing = problem_found.what();
        return found;
    }
    const contact::BestReach& best = found.best;
    found.proved = best.proved;
    found.falls_short = 1 - found.claimed_reach / best.reach;
    found.is_best = !certainly_less(Ball(Rational(1, 1'000'000), optimum_bits), found.falls_short);
    const auto digits = [](const Ball& x, unsigned count) { return round_ball(x, count).text; };
    found.text = parameter + " = " + digits(best.value, optimum_digits) +
                 (best.attained ? ", reaching " : ", approaching which it reaches up to ") +
                 digits(best.reach, optimum_digits) +
                 " of a + b (proved); the value claimed reaches " +
                 digits(found.claimed_reach, optimum_digits);
    if (!found.is_best) {
        found.text += ", which is " + digits(found.falls_short * 100, shortfall_digits) + " % less";
    }
    return found;
}

void ProvedOptimum::add_to(Evidence& evidence) const {
    if (!proved) {
        evidence.add("not_proved", best.missing);
        return;
    }
    const auto digits = [](const Ball& x) { return round_ball(x, optimum_digits).text; };
    evidence.add("best_value", digits(best.value))
        .add("reach_there", digits(best.reach))
        .add("attained", best.attained);
    if (best.touches_at) {
        evidence.add("error_touches_the_tolerance_at", digits(*best.touches_at));
    }
    evidence.add("reach_at_the_value_claimed", digits(claimed_reach))
        .add("falls_short_by", round_ball(falls_short, shortfall_digits).text)
        .add("proved_over_boxes", best.boxes);
}

} // namespace edgeproof::audit

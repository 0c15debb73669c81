// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/loads.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/escalate.hpp"

#include <algorithm>

namespace edgeproof::audit {

Outcome check_superposition(const Claim& claim, const AuditContext& context) {
    const std::vector<std::string>& names = two_loads(claim);
    const bool says_add = claim.text("says") == "add";
    const Expr of = claim.formula("of");
    std::size_t adding = 0;
    std::size_t subtracting = 0;
    std::size_t same_signs = 0;
    std::string problem;
    std::vector<Decision> decisions;
    Evidence shares;
    const std::vector<SceneSpec> scenes = context.scenes(claim);
    for (const SceneSpec& scene : scenes) {
        Decision found;
        const auto compare = [&](long with_bits) {
            EnclosedLoads loads(scene, names, with_bits);
            auto [first, second] = loads.parts(of);
            Ball second_load = loads.loads().second;
            if (claim.has("when_zero")) {
                second_load = loads.second_for_zero(claim.formula("when_zero"));
                second *= second_load / loads.loads().second;
            }
            const Ball product = says_add ? first * second : -(first * second);
            const Ball zero(0, with_bits);
            found = decision(Refutation::less(product, zero), Confirmation::less(zero, product));
            if (is_open(found)) {
                return false;
            }
            (certainly_positive(first * second) ? adding : subtracting) += 1;
            same_signs += certainly_positive(second_load * loads.loads().first) ? 1 : 0;
            if (shares.entries().size() < 3) {
                shares.add(scene.text(), ball_text(second / first, 20));
            }
            return true;
        };
        const std::string why = look_closer(compare, bits_to_decide(context.digits()));
        problem = problem.empty() ? why : problem;
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
                   " scenes, subtract in " + std::to_string(subtracting) +
                   (problem.empty() ? "" : "; " + problem);
    return outcome;
}

namespace {

using Loads = std::vector<std::shared_ptr<EnclosedLoads>>;

/// The zero of a coefficient: the printed ratio of the loads and the exact one, over all scenes.
struct Zero {
    double digits = 1e6; ///< the fewest digits of agreement that the balls prove
    std::vector<RatioSample> quotients;
    std::string value; ///< of the ratio in the first scene
};

Zero find_zero(const Loads& scenes, const Claim& claim, const Expr& coefficient) {
    const PrecisionScope scope(30);
    Zero zero;
    for (const auto& loads : scenes) {
        const Ball second = loads->second_for_zero(coefficient);
        const Ball at_zero = loads->with_second(claim.formula("ratio"), second);
        const Ball quotient = loads->with_second(claim.formula("says"), second) / at_zero;
        if (!quotient.is_finite()) {
            throw DomainError(claim.list("loads")[1] + " is not proved to have an effect on " +
                              to_text(coefficient));
        }
        const Real off = abs(quotient - 1).upper();
        zero.digits =
            off == 0 ? zero.digits : std::min(zero.digits, Real(-log10(off)).convert_to<double>());
        Variables parameters;
        for (const auto& [name, value] : loads->scene().parameters) {
            parameters.emplace(name, value.to<Real>());
        }
        zero.quotients.push_back(
            {std::move(parameters), at_working_precision(quotient.midpoint())});
        if (zero.value.empty()) {
            zero.value = value_text(at_zero.midpoint(), 20);
        }
    }
    // A quotient that is the same in all scenes does not depend on their parameters.
    const Real& first = zero.quotients.front().ratio;
    if (std::ranges::all_of(zero.quotients, [&](const RatioSample& q) {
            return abs(Real(q.ratio / first - 1)) < pow(Real(10), -20);
        })) {
        for (RatioSample& q : zero.quotients) {
            q.parameters.clear();
        }
    }
    return zero;
}

/// Judges the printed ratio in every scene by enclosures.
Judgement judge_ratio(const Loads& scenes, const Claim& claim, unsigned digits, long bits,
                      Outcome& outcome) {
    const PrintedFormula printed = printed_formula(claim);
    const auto* with_decimals = std::get_if<DecimalFormula>(&printed);
    std::vector<Decision> decisions;
    std::vector<DecimalEquation> equations;
    for (const auto& loads : scenes) {
        const Ball second = loads->second_for_zero(claim.formula("of"));
        const Ball ratio = loads->with_second(claim.formula("ratio"), second);
        const Ball value = loads->with_second(claim.formula("says"), second);
        if (decisions.empty()) {
            outcome.evidence.add("enclosures",
                                 pair_evidence(full_text(loads->scene()), "vanishes_at", ratio,
                                               "printed", value, digits));
        }
        decisions.push_back(
            decision(with_decimals != nullptr ? std::nullopt : Refutation::disjoint(value, ratio),
                     Confirmation::agreement(value, ratio, abs(ratio),
                                             AuditContext::digits_needed(digits))));
        if (with_decimals != nullptr) {
            equations.push_back(
                {[loads, second, e = with_decimals->expr()](const Decimals& numbers) {
                     set_decimals(loads->sample(), numbers);
                     return loads->with_second(e, second);
                 },
                 ratio, abs(ratio)});
        }
    }
    const Judgement exactly = Judgement::of_all(decisions);
    return with_decimals == nullptr || exactly == Verdict::confirmed
               ? exactly
               : judge_decimals(*with_decimals, equations, digits, bits, outcome);
}

/// Adds the ratio of tension to shear force for which one term stays within a tolerance for the
/// longest distance from the right edge, and the printed one, both as sigma_0 (a + b)/(2 Q): the
/// relative error depends only on this ratio.
void add_best_ratio(const Claim& claim, Outcome& outcome) {
    const std::string name = "ratio";
    const auto errors =
        contact::full_stick_errors(Expr::number(1), Expr::symbol(name), Expr::number(2),
                                   {Edge::right, 1, contact::ReachUnit::fraction, {name}});
    const Ball printed = formula::enclosed_constant(claim.formula("says"), optimum_bits);
    for (const std::string& text : claim.list("tolerances")) {
        contact::ReachProblem problem;
        problem.edges = {errors.get()};
        problem.tolerance = Exact::parse(text).rational();
        const ProvedOptimum found =
            proved_optimum(problem, {Rational(0), Rational(2)}, abs(printed), claim.text("ratio"));
        Evidence one;
        one.add("tolerance", text)
            .add("edge", "right, for the ratio's size; left, for its negative");
        found.add_to(one);
        outcome.evidence.add("one_term_reaches_farthest", one);
        if (found.proved) {
            outcome.note +=
                "; for the tolerance " + text + " one term reaches farthest at " + found.text;
        }
    }
}

} // namespace

Outcome check_vanishing(const Claim& claim, const AuditContext& context) {
    const std::vector<std::string>& names = two_loads(claim);
    const unsigned digits = context.digits();
    const long bits = 4 * formula::bits_for(digits);
    Loads scenes;
    for (const SceneSpec& scene : context.scenes(claim)) {
        scenes.push_back(std::make_shared<EnclosedLoads>(scene, names, bits));
    }
    const Zero zero = find_zero(scenes, claim, claim.formula("of"));
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("ratio", claim.text("ratio"))
        .add("vanishes_at", zero.value)
        .add("digits", digits_text(std::min(zero.digits, 1.0 * digits)));
    outcome.computed = claim.text("ratio") + " = " + zero.value;
    outcome.verdict = judge_ratio(scenes, claim, digits, bits, outcome);
    if (outcome.evidence.find("rounded") != nullptr) {
        return outcome;
    }
    if (outcome.verdict == Verdict::undecided) {
        outcome.note = "the enclosures do not decide where " + claim.text("of") + " vanishes";
    } else if (outcome.verdict == Verdict::confirmed) {
        outcome.note = claim.text("of") + " vanishes there";
    } else {
        const auto quotient = recognise_ratio(zero.quotients, 20);
        outcome.evidence.add("printed_over_exact",
                             quotient ? to_text(*quotient) : "no closed form");
        std::string value = "another value";
        if (quotient) {
            const Expr printed_value = claim.written("says");
            const Rational* q = quotient->rational();
            value = to_text(q != nullptr && *q == -1 ? -printed_value : printed_value / *quotient);
            outcome.correct = claim.text("ratio") + " = " + value + " for " + claim.text("of");
        }
        outcome.note = claim.text("of") + " vanishes at " + value;
    }
    Evidence elsewhere;
    for (const auto& [text, coefficient] : named_formulas(claim, "elsewhere")) {
        const Zero other = find_zero(scenes, claim, coefficient);
        const bool agrees = other.digits >= context.digits_needed();
        elsewhere.add(text,
                      agrees ? "vanishes at the printed value" : "vanishes at " + other.value);
        outcome.note += agrees ? "; it is " + text + " that vanishes at the printed value" : "";
    }
    if (claim.has("elsewhere")) {
        outcome.evidence.add("elsewhere", elsewhere);
    }
    if (claim.has("tolerances")) {
        add_best_ratio(claim, outcome);
    }
    return outcome;
}

} // namespace edgeproof::audit

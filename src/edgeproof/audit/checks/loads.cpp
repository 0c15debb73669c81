// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/loads.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {

Outcome check_superposition(const Claim& claim, const AuditContext& context) {
    const std::vector<std::string>& names = two_loads(claim);
    const bool says_add = claim.text("says") == "add";
    const Expr of = claim.formula("of");
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

namespace {

/// The zero of a coefficient: the comparison of the printed ratio of the loads with the exact one,
/// over all scenes.
struct Zero {
    double digits = 1e6; ///< the fewest digits of agreement
    std::vector<RatioSample> quotients;
    std::string value; ///< of the ratio in the first scene
};

Zero find_zero(const std::vector<LinearLoads>& scenes, const std::vector<Variables>& parameters,
               const Claim& claim, const Expr& coefficient) {
    Zero zero;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const LinearLoads& loads = scenes[i];
        const Real second = loads.second_for_zero(coefficient);
        const Real at_zero = loads.evaluate(claim.formula("ratio"), second);
        const Real as_printed = loads.evaluate(claim.formula("says"), second);
        const PrecisionScope scope(loads.digits() + 20);
        const Real off = abs(Real(as_printed / at_zero - 1));
        const double digits = off == 0 ? 1e6 : (-log10(off)).convert_to<double>();
        zero.digits = std::min(zero.digits, digits);
        zero.quotients.push_back({parameters[i], Real(as_printed / at_zero)});
        if (i == 0) {
            zero.value = value_text(at_zero, 20);
        }
    }
    // A quotient that is the same in all scenes does not depend on their parameters.
    const PrecisionScope scope(30);
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
Judgement judge_ratio(const std::vector<SceneSpec>& scenes, const Claim& claim, unsigned digits,
                      Outcome& outcome) {
    const PrintedFormula printed = printed_formula(claim);
    const auto* with_decimals = std::get_if<DecimalFormula>(&printed);
    std::vector<Decision> decisions;
    std::vector<DecimalEquation> equations;
    const long bits = 4 * formula::bits_for(digits);
    for (const SceneSpec& scene : scenes) {
        const auto loads = std::make_shared<EnclosedLoads>(scene, claim.list("loads"), bits);
        const Ball second = loads->second_for_zero(claim.formula("of"));
        const Ball ratio = loads->with_second(claim.formula("ratio"), second);
        const Ball value = loads->with_second(claim.formula("says"), second);
        if (decisions.empty()) {
            outcome.evidence.add("enclosures", pair_evidence(full_text(scene), "vanishes_at", ratio,
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
    std::vector<LinearLoads> scenes;
    std::vector<Variables> parameters;
    for (const SceneSpec& scene : context.scenes(claim)) {
        scenes.emplace_back(scene, digits, names[0], names[1]);
        parameters.push_back(EvaluatedScene(scene, digits).values_of(scene.parameters));
    }
    const Zero zero = find_zero(scenes, parameters, claim, claim.formula("of"));
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("ratio", claim.text("ratio"))
        .add("vanishes_at", zero.value)
        .add("digits", digits_text(std::min(zero.digits, 1.0 * digits)));
    outcome.computed = claim.text("ratio") + " = " + zero.value;
    outcome.verdict = judge_ratio(context.scenes(claim), claim, digits, outcome);
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
        const Zero other = find_zero(scenes, parameters, claim, coefficient);
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

namespace {

SceneSpec without(SceneSpec scene, const std::string& load) {
    scene.parameters.insert_or_assign(load, Exact());
    return scene;
}

/// Returns the scene with a second load that is not zero.
SceneSpec loaded(SceneSpec scene, const std::string& first, const std::string& second) {
    static_cast<void>(scene.parameter(first));
    if (scene.parameter(second).sign() == 0) {
        scene.parameters.insert_or_assign(second, Exact::of(Rational(1)));
    }
    return scene;
}

} // namespace

LinearLoads::LinearLoads(const SceneSpec& scene, unsigned digits, const std::string& first,
                         const std::string& second)
    : digits_(digits), second_(second), both_(loaded(scene, first, second), digits),
      only_first_(without(both_.spec(), second), digits),
      only_second_(without(both_.spec(), first), digits), second_value_(both_.parameter(second)) {}

LinearLoads::Parts LinearLoads::parts(const Expr& e) const {
    const Parts p{only_first_.evaluate(e).value, only_second_.evaluate(e).value};
    const Real whole = both_.evaluate(e).value;
    const PrecisionScope scope(digits_ + 20);
    const Real off = abs(Real(whole - p.first - p.second));
    if (off > (abs(p.first) + abs(p.second)) * pow(Real(10), -static_cast<int>(digits_))) {
        throw DomainError(to_text(e) + " is not the sum of its values under each load alone");
    }
    return p;
}

Real LinearLoads::second_for_zero(const Expr& e) const {
    const Parts p = parts(e);
    if (p.second == 0) {
        throw DomainError(second_ + " has no effect on " + to_text(e));
    }
    const PrecisionScope scope(digits_ + 20);
    return Real(-second_value_ * p.first / p.second);
}

Real LinearLoads::evaluate(const Expr& e, const Real& second) const {
    return both_.evaluate(e, nullptr, {{second_, second}}).value;
}

} // namespace edgeproof::audit

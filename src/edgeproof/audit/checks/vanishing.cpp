// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/decimal_fit.hpp"
#include "edgeproof/audit/checks/parts/enclosed_loads.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/sample/linear_loads.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// The zero of a coefficient: the comparison of the printed ratio of the loads with the exact one,
/// over all scenes.
struct Zero {
    bool agrees = true;
    double digits = 1e6; ///< the fewest digits of agreement
    std::vector<RatioSample> quotients;
    std::string value; ///< of the ratio in the first scene
};

Zero find_zero(const std::vector<LinearLoads>& scenes, const std::vector<Variables>& parameters,
               const formula::Expr& coefficient, const formula::Expr& ratio,
               const formula::Expr& printed, unsigned needed) {
    Zero zero;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const LinearLoads& loads = scenes[i];
        const Real second = loads.second_for_zero(coefficient);
        const Real at_zero = loads.evaluate(ratio, second);
        const Real as_printed = loads.evaluate(printed, second);
        const PrecisionScope scope(loads.digits() + 20);
        const Real off = abs(Real(as_printed / at_zero - 1));
        const double digits = off == 0 ? 1e6 : (-log10(off)).convert_to<double>();
        zero.digits = std::min(zero.digits, digits);
        zero.agrees = zero.agrees && digits >= needed;
        zero.quotients.push_back({parameters[i], Real(as_printed / at_zero)});
        if (i == 0) {
            zero.value = value_text(at_zero, 20);
        }
    }
    // A quotient that is the same in all scenes does not depend on their parameters.
    const PrecisionScope scope(30);
    const Real& first = zero.quotients.front().ratio;
    if (std::all_of(zero.quotients.begin(), zero.quotients.end(), [&](const RatioSample& q) {
            return abs(Real(q.ratio / first - 1)) < pow(Real(10), -20);
        })) {
        for (RatioSample& q : zero.quotients) {
            q.parameters.clear();
        }
    }
    return zero;
}

/// The ratio of the loads at which the coefficient vanishes in a scene, in balls: the coefficient
/// is linear in the loads, c = c_1 first + c_2 second.
struct EnclosedZero {
    std::shared_ptr<EnclosedLoads> loads;
    Ball second; ///< the second load at the zero
    Ball at_zero;

    EnclosedZero(const SceneSpec& scene, const Claim& claim, long bits)
        : loads(std::make_shared<EnclosedLoads>(scene, claim.list("loads")[0],
                                                claim.list("loads")[1], bits)),
          second(loads->second_for_zero(claim.formula("of"))),
          at_zero(loads->with_second(claim.formula("ratio"), second)) {}
};

/// Judges the printed ratio in every scene by enclosures.
Judgement judge_ratio(const std::vector<SceneSpec>& scenes, const Claim& claim, unsigned digits,
                      Outcome& outcome) {
    const PrintedFormula printed = printed_formula(claim);
    const formula::Expr as_printed = claim.formula("says");
    const double needed = AuditContext::digits_needed(digits);
    std::vector<Decision> decisions;
    std::vector<DecimalEquation> equations;
    const long bits = 4 * formula::bits_for(digits);
    for (const SceneSpec& scene : scenes) {
        const EnclosedZero zero(scene, claim, bits);
        const Ball value = zero.loads->with_second(as_printed, zero.second);
        const auto agrees = Confirmation::agreement(value, zero.at_zero, abs(zero.at_zero), needed);
        if (decisions.empty()) {
            add_pair({"vanishes_at",
                      {zero.at_zero, ""},
                      "printed",
                      {value, ""},
                      scene.family + ": " + scene.text()},
                     digits, outcome.evidence);
        }
        if (const auto* with_decimals = std::get_if<DecimalFormula>(&printed)) {
            decisions.push_back(decision(std::nullopt, agrees));
            equations.push_back({[zero, e = with_decimals->expr()](const Decimals& numbers) {
                                     for (std::size_t k = 0; k < numbers.size(); ++k) {
                                         zero.loads->sample().set(
                                             DecimalFormula::name_of_decimal(k), numbers[k]);
                                     }
                                     return zero.loads->with_second(e, zero.second);
                                 },
                                 zero.at_zero, abs(zero.at_zero)});
        } else {
            decisions.push_back(decision(Refutation::disjoint(value, zero.at_zero), agrees));
        }
    }
    const Judgement exactly = Judgement::of_all(decisions);
    const auto* with_decimals = std::get_if<DecimalFormula>(&printed);
    if (with_decimals == nullptr || exactly == Verdict::confirmed) {
        return exactly;
    }
    const std::size_t comparisons = equations.size();
    return judge_decimals(
        with_decimals->decimals(),
        DecimalFit(with_decimals->decimals(), std::move(equations), static_cast<unsigned>(needed),
                   bits),
        [&](const std::vector<Real>& numbers) { return with_decimals->text_with(numbers); },
        comparisons, digits, outcome);
}

/// Adds the ratio of tension to shear force for which one term stays within a tolerance for the
/// longest distance from the right edge, and the printed one, both as sigma_0 (a + b)/(2 Q): the
/// relative error depends only on this ratio.
void add_best_ratio(const Claim& claim, Outcome& outcome) {
    const auto name = std::string("ratio");
    const auto errors = contact::full_stick_errors(
        formula::Expr::number(1), formula::Expr::symbol(name), formula::Expr::number(2),
        {contact::Edge::right, 1, contact::ReachUnit::fraction, {name}});
    const Ball printed = formula::enclosed_constant(claim.formula("says"), optimum_bits);
    for (const std::string& text : claim.list("tolerances")) {
        contact::ReachProblem problem;
        problem.edges = {errors.get()};
        problem.tolerance = formula::Exact::parse(text).rational();
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

Outcome check_vanishing(const Claim& claim, const AuditContext& context) {
    std::vector<LinearLoads> scenes;
    std::vector<Variables> parameters;
    const auto& loads = claim.list("loads");
    if (loads.size() != 2) {
        claim.reject("loads", "loads are not two", "write loads = [\"Q\", \"sig0\"]");
    }
    for (const SceneSpec& scene : context.scenes(claim)) {
        scenes.emplace_back(scene, context.digits(), loads[0], loads[1]);
        const EvaluatedScene scene_values(scene, context.digits());
        Variables values;
        for (const auto& [name, value] : scene.parameters) {
            values.emplace(name, scene_values.parameter(name));
        }
        parameters.push_back(std::move(values));
    }
    const formula::Expr ratio = claim.formula("ratio");
    const formula::Expr printed = claim.formula("says");
    const auto zero_of = [&](const formula::Expr& coefficient) {
        return find_zero(scenes, parameters, coefficient, ratio, printed, context.digits_needed());
    };
    const Zero zero = zero_of(claim.formula("of"));
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("scenes", scenes.size())
        .add("ratio", claim.text("ratio"))
        .add("vanishes_at", zero.value)
        .add("digits", digits_text(std::min(zero.digits, 1.0 * context.digits())));
    outcome.computed = claim.text("ratio") + " = " + zero.value;
    outcome.verdict = judge_ratio(context.scenes(claim), claim, context.digits(), outcome);
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
            const formula::Expr printed_value = claim.written("says");
            const Rational* q = quotient->rational();
            value = to_text(q != nullptr && *q == -1 ? -printed_value : printed_value / *quotient);
            outcome.correct = claim.text("ratio") + " = " + value + " for " + claim.text("of");
        }
        outcome.note = claim.text("of") + " vanishes at " + value;
    }
    if (claim.has("elsewhere")) {
        std::vector<std::string> at;
        Evidence others;
        for (std::size_t i = 0; i < claim.list("elsewhere").size(); ++i) {
            const std::string& text = claim.list("elsewhere")[i];
            const Zero other = zero_of(claim.formulas("elsewhere")[i]);
            others.add(text, other.agrees ? "vanishes at the printed value"
                                          : "vanishes at " + other.value);
            if (other.agrees) {
                at.push_back(text);
            }
        }
        outcome.evidence.add("elsewhere", others);
        for (const std::string& text : at) {
            outcome.note += "; it is " + text + " that vanishes at the printed value";
        }
    }
    if (claim.has("tolerances")) {
        add_best_ratio(claim, outcome);
    }
    return outcome;
}

} // namespace

CheckKind vanishing_kind() {
    using Type = KeySpec::Type;
    return {"vanishing",
            {required_formula("says"),
             required_formula("of"),
             required_formula("ratio"),
             {.name = "loads", .type = Type::list, .required = true},
             {.name = "tolerances", .type = Type::list},
             {.name = "elsewhere", .type = Type::formulas}},
            check_vanishing};
}

} // namespace edgeproof::audit

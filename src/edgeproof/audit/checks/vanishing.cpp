// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/proved_optimum.hpp"
#include "edgeproof/audit/diagnosis/ratio.hpp"
#include "edgeproof/audit/sample/linear_loads.hpp"
#include "edgeproof/formula/exact/enclosed_constant.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// Where a coefficient vanishes: the printed ratio of the loads against the one that makes it so,
/// over all scenes.
struct Zero {
    bool agrees = true;
    double digits = 1e6; ///< to which they agree, at worst
    std::optional<Difference> against;
    std::vector<RatioSample> quotients;
    std::string value; ///< of the ratio, in the first scene
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
        if (digits < needed && !zero.against) {
            zero.against = Difference::of(as_printed, at_zero, Real(0));
        }
        zero.quotients.push_back({parameters[i], Real(as_printed / at_zero)});
        if (i == 0) {
            zero.value = value_text(at_zero, 20);
        }
    }
    // A quotient that is the same in all scenes owes nothing to their parameters.
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

/// The ratio of the loads at which the coefficient vanishes in a scene, and the printed one, in
/// balls: the coefficient is linear in the loads, c = c_1 first + c_2 second.
std::pair<Enclosed, Enclosed> enclosed_zero(const SceneSpec& scene, const Claim& claim,
                                            unsigned digits) {
    const auto& loads = claim.list("loads");
    std::pair<Enclosed, Enclosed> found;
    try {
        const long bits = 2 * formula::bits_for(digits);
        EnclosedSample sample(Sample{scene, std::nullopt, contact::Edge::right, {}}, bits);
        const Ball none(0, bits);
        const Ball one(1, bits);
        const auto with = [&](const Ball& first, const Ball& second, const formula::Expr& e) {
            sample.set(loads[0], first);
            sample.set(loads[1], second);
            return sample.evaluate(e);
        };
        const formula::Expr of = claim.formula("of");
        const Ball second = -(with(one, none, of) / with(none, one, of));
        found.first.ball = with(one, second, claim.formula("ratio"));
        found.second.ball = with(one, second, claim.formula("says"));
    } catch (const Error& error) {
        found.first.problem = error.what();
    }
    return found;
}

/// At which ratio of tension to shear force one term stays within a tolerance for the longest
/// distance from the right edge, beside the printed one: both by ratio sigma_0 (a + b)/(2 Q), which
/// is all that the relative error depends on.
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
    outcome.verdict = zero.agrees ? Judgement(NotRefuted::confirmed) : Judgement(zero.against);
    outcome.computed = claim.text("ratio") + " = " + zero.value;
    outcome.note = zero.agrees ? claim.text("of") + " vanishes there" : "";
    const SceneSpec first = context.scenes(claim).front();
    const auto [at_zero, as_printed] = enclosed_zero(first, claim, context.digits());
    add_pair("vanishes_at", at_zero, "printed", as_printed, first.family + ": " + first.text(),
             context.digits(), outcome);
    if (!zero.agrees) {
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

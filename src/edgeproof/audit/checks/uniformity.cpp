// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::audit {
namespace {

constexpr int rungs_to_the_breakdown = 20; // decades towards the place of the breakdown

/// What an expansion in a small variable leaves, over the power of it that comes next, as another
/// variable runs to where the expansion is said to break down.
struct Rest {
    double slope = 0; ///< growth by decade of the distance: 1 for a pole
    bool vanishes = false;
    std::string first;
    std::string last;
};

Rest follow(const EvaluatedScene& scene_values, const Claim& claim, const Variables& fixed,
            const std::string& variable, const formula::Expr& rest, unsigned digits) {
    const formula::Expr towards = formula::Exact::parse(claim.text("towards")).expr();
    const PrecisionScope scope(2 * digits);
    const Real end = scene_values.evaluate(towards).value;
    std::vector<Real> values;
    for (int k = 1; k <= rungs_to_the_breakdown; ++k) {
        Variables at = fixed;
        at.insert_or_assign(variable, Real(end - pow(Real(10), -k)));
        values.push_back(abs(scene_values.evaluate(rest, nullptr, at).value));
    }
    Rest found;
    // Where nothing is left but roundoff, the expansion ends: nothing can break down.
    const Real noise = pow(Real(10), -static_cast<int>(digits) / 3);
    found.vanishes =
        std::all_of(values.begin(), values.end(), [&](const Real& v) { return v < noise; });
    found.first = value_text(values.front(), 12);
    found.last = value_text(values.back(), 12);
    if (!found.vanishes) {
        // The last half of the sweep.
        const Real growth = values.back() / values[rungs_to_the_breakdown / 2 - 1];
        found.slope = Real(log10(growth) / (rungs_to_the_breakdown / 2)).convert_to<double>();
    }
    return found;
}

/// What the printed term has on the last step, and what is left there, in balls.
void add_last_rung(const Claim& claim, const Sample& sample, const formula::Expr& rest,
                   const formula::Expr& term, unsigned digits, Outcome& outcome) {
    const std::string& variable = claim.text("variable");
    const formula::Expr at = formula::Exact::parse(claim.text("towards")).expr() -
                             pow(formula::Expr::number(Rational(10)),
                                 formula::Expr::number(Rational(-rungs_to_the_breakdown)));
    add_pair("printed", enclosed(substitute(term, variable, at), sample, digits), "exact",
             enclosed(substitute(rest, variable, at), sample, digits),
             sample.text() + ", " + variable + " = " + formula::Exact(at).text(), digits, outcome);
}

/// That an expansion breaks down where another variable comes to a limit: what it leaves, over the
/// power that is to come next, must grow there.
Outcome check_uniformity(const Claim& claim, const AuditContext& context) {
    const std::string& small = claim.text("small");
    const std::string& variable = claim.text("variable");
    const auto order = static_cast<unsigned>(claim.integer("order"));
    const formula::Expr rest =
        (claim.formula("of") - claim.formula("approximation")) /
        pow(formula::Expr::symbol(small), formula::Expr::number(Rational(order)));
    std::optional<formula::Expr> predicted;
    if (claim.has("term")) {
        predicted = claim.formula("term");
    }
    // The rest loses order times the decades of the small variable, and those of the distance.
    const unsigned digits = 4 * rungs_to_the_breakdown + 60;
    const bool says_breaks = claim.text("says") == "breaks down";
    std::optional<Difference> against;
    std::size_t breaking = 0;
    std::size_t uniform = 0;
    std::size_t nothing_left = 0;
    // The first at which the printed term breaks down, and what is left does not.
    const Sample* by_the_term = nullptr;
    std::string last;
    Evidence in_scenes;
    const std::vector<Sample> samples = context.samples(claim);
    for (const Sample& sample : samples) {
        const EvaluatedScene scene_values(sample.scene, digits);
        Variables fixed = scene_values.values_of(sample.variables);
        if (!fixed.contains(small)) {
            claim.reject("vary", "vary does not say how small " + small + " is",
                         "write vary = { " + small + " = [\"b*1e-6\"] }");
        }
        const Rest exact = follow(scene_values, claim, fixed, variable, rest, digits);
        Evidence one;
        // The growth claimed: 1 by decade where it breaks down, 0 where it does not.
        if (!against && !exact.vanishes) {
            against = Difference::of(Real(says_breaks ? 1 : 0), Real(exact.slope), Real("0.5"));
        }
        if (exact.vanishes) {
            ++nothing_left;
            one.add("left", "nothing");
        } else {
            (exact.slope > 0.9 ? breaking : exact.slope < 0.1 ? uniform : nothing_left) += 1;
            one.add("growth_by_decade", fmt::format("{:.6f}", exact.slope))
                .add("at_a_tenth", exact.first)
                .add("at_1e-20", exact.last);
        }
        if (predicted) {
            const Rest printed = follow(scene_values, claim, fixed, variable, *predicted, digits);
            one.add("growth_of_the_printed_term", fmt::format("{:.6f}", printed.slope));
            if (by_the_term == nullptr && printed.slope > 0.9 && !exact.vanishes &&
                exact.slope < 0.1) {
                by_the_term = &sample;
            }
        }
        in_scenes.add(sample.text(), one);
    }
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"))
        .add("approximation", claim.text("approximation"))
        .add("samples", samples.size())
        .add("break_down", breaking)
        .add("uniform", uniform)
        .add("in_scenes", in_scenes);
    if (breaking > 0 && uniform == 0) {
        outcome.verdict = says_breaks ? Judgement(NotRefuted::confirmed) : Judgement(against);
        outcome.note = "what is left over " + small + "^" + std::to_string(order) +
                       " grows without bound as " + variable + " -> " + claim.text("towards");
    } else if (uniform > 0 && breaking == 0) {
        outcome.verdict = says_breaks ? Judgement(against) : Judgement(NotRefuted::confirmed);
        outcome.note = "what is left over " + small + "^" + std::to_string(order) +
                       " stays bounded as " + variable + " -> " + claim.text("towards") +
                       ", in all of " + std::to_string(uniform) + " samples";
        if (by_the_term != nullptr) {
            add_last_rung(claim, *by_the_term, rest, *predicted, context.digits(), outcome);
        }
    } else {
        outcome.note = "it breaks down at " + std::to_string(breaking) + " samples, not at " +
                       std::to_string(uniform);
    }
    return outcome;
}

} // namespace

CheckKind uniformity_kind() {
    using Type = KeySpec::Type;
    return {"uniformity",
            {{.name = "says",
              .type = Type::choice,
              .required = true,
              .choices = {"breaks down", "uniform"}},
             required_formula("of"),
             required_formula("approximation"),
             optional_formula("term"),
             {.name = "small", .required = true},
             {.name = "order", .type = Type::integer, .required = true},
             {.name = "variable", .required = true},
             {.name = "towards", .type = Type::number, .required = true}},
            check_uniformity};
}

} // namespace edgeproof::audit

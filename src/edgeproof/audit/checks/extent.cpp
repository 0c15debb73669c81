// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <cstdlib>
#include <map>
#include <optional>

namespace edgeproof::audit {
namespace {

/// A field's formula in the parameters of a scene, as an exact number.
formula::Exact exact_in(const Claim& claim, std::string_view key, const SceneSpec& scene) {
    formula::Expr e = claim.formula(key);
    for (const auto& [name, value] : scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    try {
        return formula::Exact(e);
    } catch (const Error&) {
        claim.reject(key, std::string(key) + " is not a number in the scene " + scene.text(),
                     "use numbers and the family's parameters only");
    }
}

/// One scene's figure, and what else could have been meant by it.
struct ReachInScene {
    Real value;
    Evidence evidence;
    bool none = false; ///< no first exit: the value is the end of the part looked at
};

ReachInScene reach_in(const SceneSpec& scene, const Claim& claim, const AuditContext& context,
                      const QuotedFigure& figure) {
    const contact::Edge edge = claim.edge();
    const auto terms = static_cast<std::size_t>(claim.integer("terms"));
    const formula::Exact tolerance = formula::Exact::parse(claim.text("tolerance"));
    contact::ExtentRange range;
    if (claim.has("upto")) {
        range.to = exact_in(claim, "upto", scene);
    }
    const EvaluatedScene scene_values(scene, context.digits());
    const contact::Extents extents =
        within_tolerance(scene_values.contact(), edge, terms, tolerance, range);
    const PrecisionScope scope(context.digits() + 20);
    const Real base = scene_values.evaluate(claim.formula("base")).value;
    const bool first = claim.text("reach") == "first-exit";
    ReachInScene reach;
    reach.value = (first ? extents.first_exit : extents.measure) / base;
    reach.none = first && !extents.leaves;
    Evidence& e = reach.evidence;
    e.add("at", scene.family + ": " + scene.text())
        .add("value", value_text(reach.value, context.digits()))
        .add("rounds_to", figure.rounded(reach.value))
        .add("units_off", figure.units_off(reach.value))
        .add("crossings", extents.crossings.size())
        .add("first_exit_of_base", figure.text(Real(extents.first_exit / base)))
        .add("measure_of_base", figure.text(Real(extents.measure / base)))
        .add("first_exit_of_whole_contact", figure.text(Real(extents.first_exit / extents.length)))
        .add("measure_of_whole_contact", figure.text(Real(extents.measure / extents.length)));
    if (!extents.leaves) {
        e.add("first_exit", "none: within the tolerance all over the part looked at");
    }
    // The tolerance under which the quoted figure would be the distance.
    const Real u = Real(figure.value()) * base;
    if (u > 0 && u < extents.length) {
        const Real error = scene_values.local(edge, terms, u) / scene_values.pressure(edge, u) - 1;
        e.add("error_at_the_quoted_distance", to_decimal(Real(error * 100), 4) + " %");
    }
    return reach;
}

/// The same figure in balls: every crossing found, and proved to be all that there are.
Enclosed enclosed_reach(const SceneSpec& scene, const Claim& claim, const AuditContext& context) {
    const contact::Edge edge = claim.edge();
    contact::ExtentRange range;
    if (claim.has("upto")) {
        range.to = exact_in(claim, "upto", scene);
    }
    const contact::Profile profile = scene.make_profile();
    const contact::Load load = contact::Load::right_edge(scene.parameter("a"));
    std::map<long, contact::BallContact> contacts;
    const auto contact_at = [&](long bits) -> const contact::BallContact& {
        return contacts.try_emplace(bits, profile, scene.parameter("Es"), load, bits).first->second;
    };
    Enclosed reach;
    contact::BallExtentSearch search(contact_at, edge,
                                     static_cast<std::size_t>(claim.integer("terms")),
                                     formula::Exact::parse(claim.text("tolerance")), range);
    const Sample sample{scene, std::nullopt, edge, {}};
    const long needed = formula::bits_for(context.digits());
    for (long bits = 2 * needed; bits <= 8 * needed && !reach.ball; bits *= 2) {
        try {
            const contact::EnclosedExtents extents = search.at(bits);
            const bool first = claim.text("reach") == "first-exit";
            reach.ball = (first ? extents.first_exit : extents.measure) /
                         EnclosedSample(sample, bits).evaluate(claim.formula("base"));
        } catch (const BudgetError& error) {
            reach.problem = error.what();
        } catch (const Error& error) {
            reach.problem = error.what();
            break;
        }
    }
    return reach;
}

/// The ball beside all that would have been rounded to the quoted figure, give or take a unit.
void enclose_figure(const Enclosed& computed, const QuotedFigure& figure, const std::string& at,
                    unsigned digits, Outcome& outcome) {
    Evidence e;
    if (!computed.ball) {
        outcome.evidence.add("enclosures", e.add("none", computed.problem));
        return;
    }
    const auto [lower, upper] =
        figure.within_units(outcome.verdict == Verdict::refuted ? Rational(3, 2) : Rational(1, 2));
    const Ball& ball = *computed.ball;
    const bool apart = certainly_less(ball, Ball(lower, ball.bits())) ||
                       certainly_less(Ball(upper, ball.bits()), ball);
    e.add("at", at)
        .add("computed", ball_text(ball, digits))
        .add("quoted", exact_text(lower) + " ... " + exact_text(upper))
        .add("disjoint", apart);
    if (!apart && (outcome.verdict == Verdict::refuted || outcome.verdict == Verdict::imprecise)) {
        outcome.verdict = NotRefuted::undecided;
        outcome.note = "the estimate has it differ, the enclosure does not";
    }
    outcome.evidence.add("enclosures", std::move(e));
}

Outcome check_extent(const Claim& claim, const AuditContext& context) {
    const QuotedFigure figure = QuotedFigure::of(claim);
    if (claim.integer("terms") < 1 || claim.integer("terms") > 9) {
        claim.reject("terms", "an approximation of " + claim.text("terms") + " terms",
                     "write 1 to 9");
    }
    Outcome outcome;
    std::vector<EvidenceItem> scenes;
    const PrecisionScope scope(context.digits() + 20);
    std::optional<Real> at_worst;
    bool none = false;
    long worst = -1;
    std::optional<SceneSpec> worst_scene;
    for (const SceneSpec& scene : context.scenes(claim)) {
        try {
            ReachInScene reach = reach_in(scene, claim, context, figure);
            const long off = std::labs(figure.units_off(reach.value));
            if (off > worst) {
                worst = off;
                worst_scene = scene;
                at_worst = reach.value;
                none = reach.none;
                outcome.verdict = figure.verdict(reach.value);
                outcome.computed = figure.text(reach.value);
            }
            scenes.emplace_back(std::move(reach.evidence));
        } catch (const InputError& error) {
            claim.reject("tolerance", error.problem(), error.instead());
        }
    }
    outcome.note = figure.note(*at_worst);
    outcome.evidence.add("scenes", std::move(scenes));
    enclose_figure(enclosed_reach(*worst_scene, claim, context), figure,
                   worst_scene->family + ": " + worst_scene->text(), context.digits(), outcome);
    if (none) {
        // What is computed is where the part looked at ends: a figure beyond it may stand.
        outcome.note = "there is no first exit up to " + figure.text(*at_worst) +
                       ", the end of the part looked at";
        if (Real(figure.value()) >= *at_worst || outcome.verdict != Verdict::refuted) {
            outcome.verdict = NotRefuted::undecided;
        }
    }
    return outcome;
}

} // namespace

CheckKind extent_kind() {
    using Type = KeySpec::Type;
    return {"extent",
            {{.name = "terms", .type = Type::integer, .required = true},
             {.name = "tolerance", .type = Type::number, .required = true},
             required_formula("base"),
             {.name = "reach",
              .type = Type::choice,
              .required = true,
              .choices = {"first-exit", "measure"}},
             optional_formula("upto")},
            check_extent};
}

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/extent.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/quoted_figure.hpp"
#include "edgeproof/audit/spots.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/text.hpp"

#include <cstdlib>

namespace edgeproof {
namespace {

/// A field's formula in the parameters of a scene, as an exact number.
Exact exact_in(const Claim& claim, std::string_view key, const SceneSpec& scene) {
    Expr e = claim.formula(key);
    for (const auto& [name, value] : scene.parameters) {
        e = substitute(e, name, value.expr());
    }
    try {
        return Exact(e);
    } catch (const Error&) {
        claim.reject(key, std::string(key) + " is not a number in the scene " + scene.text(),
                     "use numbers and the family's parameters only");
    }
}

/// One scene's figure, and what else could have been meant by it.
struct Reach {
    Real value;
    Evidence evidence;
};

Reach reach_in(const SceneSpec& scene, const Claim& claim, const AuditContext& context,
               const QuotedFigure& figure) {
    const Edge edge = claim.text_or("edge", "right") == "right" ? Edge::right : Edge::left;
    const auto terms = static_cast<std::size_t>(claim.integer("terms"));
    const Exact tolerance = Exact::parse(claim.text("tolerance"));
    ExtentRange range;
    if (claim.has("upto")) {
        range.to = exact_in(claim, "upto", scene);
    }
    const Setting setting(scene, context.digits());
    const Extents extents = within_tolerance(setting.contact(), edge, terms, tolerance, range);
    const PrecisionScope scope(context.digits() + 20);
    const Real base = setting.evaluate(claim.formula("base")).value;
    const bool first = claim.text("reach") == "first-exit";
    Reach reach;
    reach.value = (first ? extents.first_exit : extents.measure) / base;
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
    // The tolerance under which the quoted figure would be the distance.
    const Real u = Real(figure.value()) * base;
    if (u > 0 && u < extents.length) {
        const Real error = setting.local(edge, terms, u) / setting.pressure(edge, u) - 1;
        e.add("error_at_the_quoted_distance", to_decimal(Real(error * 100), 4) + " %");
    }
    return reach;
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
    long worst = -1;
    for (const SceneSpec& scene : context.scenes(claim)) {
        try {
            Reach reach = reach_in(scene, claim, context, figure);
            const long off = std::labs(figure.units_off(reach.value));
            if (off > worst) {
                worst = off;
                at_worst = reach.value;
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
    return outcome;
}

} // namespace

CheckKind extent_kind() {
    using Type = KeySpec::Type;
    return {"extent",
            {{.name = "terms", .type = Type::integer, .required = true},
             {.name = "tolerance", .type = Type::number, .required = true},
             {.name = "base", .type = Type::formula, .required = true},
             {.name = "reach",
              .type = Type::choice,
              .required = true,
              .choices = {"first-exit", "measure"}},
             {.name = "upto", .type = Type::formula}},
            check_extent};
}

} // namespace edgeproof

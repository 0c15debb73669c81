// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <cstdlib>
#include <map>

namespace edgeproof::audit {
namespace {

/// Returns the rank of a verdict on a figure, from good to bad.
int badness(Verdict v) {
    switch (v) {
    case Verdict::confirmed:
        return 0;
    case Verdict::imprecise:
        return 1;
    case Verdict::refuted:
        return 3;
    default:
        return 2;
    }
}

struct FigureAt {
    Judgement verdict;
    std::optional<Ball> value;
    std::string problem;
};

/// Uses an exact number, or an enclosure with enough bits to round it and to show `digits`.
FigureAt figure_at(const Sample& sample, const Expr& of, const QuotedFigure& figure,
                   unsigned digits) {
    FigureAt found;
    SampleInBalls in_balls(sample, digits);
    const bool decided = in_balls.until([&](const EnclosedSample& at) {
        const Ball x = at.evaluate(of);
        if (!x.is_finite()) {
            return false;
        }
        found.value = x;
        found.verdict = figure.verdict(x);
        return found.verdict != Verdict::undecided &&
               x.relative_accuracy_bits() >= formula::bits_for(digits);
    });
    if (found.verdict == Verdict::undecided) {
        if (const auto exact = exact_value(of, sample)) {
            found.verdict = figure.verdict_half_way(*exact);
        }
    }
    if (!decided) {
        found.problem = in_balls.problem();
    }
    return found;
}

} // namespace

Outcome check_figure(const Claim& claim, const AuditContext& context) {
    const QuotedFigure figure = QuotedFigure::of(claim);
    const Expr of = claim.formula("of");
    const unsigned digits = std::max(context.digits(), figure.digits() + 10);
    const ClaimSamples samples(claim, context);
    const PrecisionScope scope(digits + 20);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of")).add("samples", samples.all().size());
    std::optional<Real> least;
    std::optional<Real> most;
    std::optional<Real> at_worst;
    int worst = -1;
    for (const Sample& sample : samples.all()) {
        const FigureAt found = figure_at(sample, of, figure, digits);
        if (!found.value) {
            outcome.verdict = {};
            outcome.note = found.problem + ", at " + full_text(sample);
            return outcome;
        }
        const Real value = found.value->midpoint();
        if (badness(found.verdict) > worst) {
            worst = badness(found.verdict);
            at_worst = value;
            outcome.verdict = found.verdict;
            outcome.computed = figure.text(value);
            outcome.evidence.add("at", full_text(sample))
                .add("value", value_text(value, context.digits()))
                .add("rounds_to", figure.rounded(value))
                .add("units_off", figure.units_off(value))
                .add("enclosure", ball_text(*found.value, context.digits()));
        }
        least = !least || value < *least ? value : *least;
        most = !most || value > *most ? value : *most;
    }
    if (!least) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    outcome.evidence.add("range",
                         std::vector<std::string>{figure.text(*least, 12), figure.text(*most, 12)});
    outcome.note = outcome.verdict == Verdict::undecided
                       ? "the enclosure does not decide how it is rounded"
                       : figure.note(*at_worst);
    return outcome;
}

namespace {

/// Returns a field's formula in the parameters of a scene as an exact number.
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

ReachQuestion question_in(const SceneSpec& scene, const Claim& claim) {
    ReachQuestion question{claim.edge(),
                           static_cast<std::size_t>(claim.integer("terms")),
                           Exact::parse(claim.text("tolerance")),
                           {}};
    if (claim.has("upto")) {
        question.range.to = exact_in(claim, "upto", scene);
    }
    return question;
}

/// The proved figure in one scene, and evidence on other possible meanings of it.
struct ReachInScene {
    std::optional<Ball> value;
    std::string problem; ///< the reason why there is no value
    Evidence evidence;
    bool none = false; ///< no first exit: the value is the end of the searched part
};

ReachInScene reach_in(const SceneSpec& scene, const ReachQuestion& question, const Claim& claim,
                      unsigned digits, const QuotedFigure& figure) {
    const EnclosedReach found = enclosed_reach(scene, question, digits);
    ReachInScene reach{std::nullopt, found.problem, Evidence().add("at", full_text(scene)), false};
    if (!found.extents) {
        reach.evidence.add("none", found.problem);
        return reach;
    }
    const contact::EnclosedExtents& extents = *found.extents;
    EnclosedSample at({scene, std::nullopt, question.edge, {}}, found.bits);
    const Ball base = at.evaluate(claim.formula("base"));
    const bool first = claim.text("reach") == "first-exit";
    reach.value = (first ? extents.first_exit : extents.measure) / base;
    reach.none = first && !extents.leaves;
    const auto of = [&](const Ball& length, const Ball& part) {
        return figure.text(Real((length / part).midpoint()));
    };
    const Real value = reach.value->midpoint();
    Evidence& e = reach.evidence;
    e.add("value", value_text(value, digits))
        .add("rounds_to", figure.rounded(value))
        .add("units_off", figure.units_off(value))
        .add("crossings", extents.crossings.size())
        .add("first_exit_of_base", of(extents.first_exit, base))
        .add("measure_of_base", of(extents.measure, base))
        .add("first_exit_of_whole_contact", of(extents.first_exit, extents.length))
        .add("measure_of_whole_contact", of(extents.measure, extents.length));
    if (!extents.leaves) {
        e.add("first_exit", "none: within the tolerance all over the part looked at");
    }
    // Find the tolerance for which the quoted figure would be the distance.
    const Ball u = Ball(figure.value(), at.bits()) * base;
    if (certainly_positive(u) && certainly_less(u, extents.length)) {
        at.set_place(question.edge, u);
        const Expr x = Expr::symbol("x");
        const Expr local =
            Expr::call(question.edge == Edge::right ? "right_local" : "left_local",
                       {Expr::number(Rational(static_cast<long>(question.terms))), x});
        const Ball error = at.evaluate(local) / at.evaluate(Expr::call("p", {x})) - 1;
        e.add("error_at_the_quoted_distance", to_decimal((error * 100).midpoint(), 4) + " %");
    }
    return reach;
}

/// Evidence: the ball and the interval of numbers that round to the quoted figure; for a
/// refutation, the interval is larger by one unit on each side.
Evidence enclosed_evidence(const Ball& ball, const QuotedFigure& figure, Verdict verdict,
                           const std::string& at, unsigned digits) {
    const auto [lower, upper] =
        figure.within_units(verdict == Verdict::refuted ? Rational(3, 2) : Rational(1, 2));
    Evidence e;
    e.add("at", at)
        .add("computed", ball_text(ball, digits))
        .add("quoted", exact_text(lower) + " ... " + exact_text(upper))
        .add("disjoint", certainly_less(ball, Ball(lower, ball.bits())) ||
                             certainly_less(Ball(upper, ball.bits()), ball));
    return e;
}

} // namespace

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
    bool undecided = false;
    std::string problem;
    for (const SceneSpec& scene : context.scenes(claim)) {
        try {
            const ReachQuestion question = question_in(scene, claim);
            ReachInScene reach = reach_in(scene, question, claim, context.digits(), figure);
            Judgement verdict = reach.value ? figure.verdict(*reach.value) : Judgement();
            const Real value = reach.value ? reach.value->midpoint() : Real(0);
            if (reach.none && (Real(figure.value()) >= value || verdict != Verdict::refuted)) {
                // There is no exit in the searched part: a figure beyond its end may be right.
                verdict = {};
            }
            if (verdict == Verdict::undecided && !undecided) {
                undecided = true;
                problem = reach.value ? "the enclosure does not decide how it is rounded"
                                      : "no enclosure: " + reach.problem;
            }
            const long off = reach.value ? std::labs(figure.units_off(value)) : -1;
            if (off > worst) {
                worst = off;
                at_worst = value;
                none = reach.none;
                outcome.verdict = verdict;
                outcome.computed = figure.text(value);
                outcome.evidence.add("enclosures",
                                     enclosed_evidence(*reach.value, figure, verdict,
                                                       full_text(scene), context.digits()));
            }
            scenes.emplace_back(std::move(reach.evidence));
        } catch (const InputError& error) {
            claim.reject("tolerance", error.problem(), error.instead());
        }
    }
    outcome.note = at_worst ? figure.note(*at_worst) : problem;
    if (undecided && outcome.verdict != Verdict::refuted) {
        outcome.verdict = {};
        outcome.note = problem;
    }
    if (none) {
        outcome.note = "there is no first exit up to " + figure.text(*at_worst) +
                       ", the end of the part examined";
    }
    outcome.evidence.add("scenes", std::move(scenes));
    return outcome;
}

} // namespace edgeproof::audit

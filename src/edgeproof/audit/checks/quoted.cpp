// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

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

} // namespace edgeproof::audit

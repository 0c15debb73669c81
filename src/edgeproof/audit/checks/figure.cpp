// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {
namespace {

/// How bad a verdict on a figure is.
int badness(Verdict v) { return v == Verdict::confirmed ? 0 : v == Verdict::imprecise ? 1 : 2; }

Outcome check_figure(const Claim& claim, const AuditContext& context) {
    const QuotedFigure figure = QuotedFigure::of(claim);
    const formula::Expr of = claim.formula("of");
    const std::shared_ptr<EvaluatedSamples> sampled =
        EvaluatedSamples::of(claim, context, context.digits());
    const EvaluatedSamples& samples_at = *sampled;
    const PrecisionScope scope(context.digits() + 20);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of")).add("samples", samples_at.all().size());
    std::optional<Real> least;
    std::optional<Real> most;
    std::optional<Real> at_worst;
    int worst = -1;
    for (const EvaluatedSample& sample_at : samples_at.all()) {
        const FormulaValue value = sample_at.evaluate(of);
        if (!value.converged || !isfinite(value.value)) {
            outcome.verdict = NotRefuted::undecided;
            outcome.note = (value.converged ? "a number beyond the range of the arithmetic at "
                                            : "an integral did not converge at ") +
                           sample_at.text;
            return outcome;
        }
        const Judgement verdict = figure.verdict(value.value);
        if (badness(verdict) > worst) {
            worst = badness(verdict);
            at_worst = value.value;
            outcome.verdict = verdict;
            outcome.computed = figure.text(value.value);
            outcome.evidence.add("at", sample_at.text)
                .add("value", value_text(value.value, context.digits()))
                .add("rounds_to", figure.rounded(value.value))
                .add("units_off", figure.units_off(value.value));
        }
        least = !least || value.value < *least ? value.value : *least;
        most = !most || value.value > *most ? value.value : *most;
    }
    if (!least) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    outcome.evidence.add("range",
                         std::vector<std::string>{figure.text(*least, 12), figure.text(*most, 12)});
    outcome.note = figure.note(*at_worst);
    return outcome;
}

} // namespace

CheckKind figure_kind() {
    return {
        "figure", {{.name = "of", .type = KeySpec::Type::formula, .required = true}}, check_figure};
}

} // namespace edgeproof::audit

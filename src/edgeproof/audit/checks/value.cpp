// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"

namespace edgeproof::audit {
namespace {

/// Compares with the `digits` of the context, or fewer.
Outcome compare_values(const Claim& claim, const AuditContext& context, unsigned digits) {
    const formula::Expr printed = claim.formula("says");
    const formula::Expr exact = claim.formula("of");
    std::optional<formula::Expr> scale;
    if (claim.has("scale")) {
        scale = claim.formula("scale");
    }
    const std::shared_ptr<EvaluatedSamples> sampled = EvaluatedSamples::of(claim, context, digits);
    EvaluatedSamples& samples_at = *sampled;
    Outcome outcome;
    if (samples_at.all().empty()) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    const Agreement agreement = samples_at.compare(printed, exact, scale);
    const double needed = AuditContext::digits_needed(digits);
    outcome.evidence.add("of", claim.text("of"));
    outcome.sample_use = agreement.use(needed);
    report_agreement(agreement, samples_at, digits, outcome.evidence);
    outcome.verdict = judge_formula(claim, samples_at, agreement, exact, scale, digits, outcome);
    if (outcome.evidence.find("rounded") != nullptr) {
        return outcome;
    }
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = "agrees at " + std::to_string(samples_at.all().size()) + " samples";
    } else if (outcome.note.empty() ||
               (outcome.verdict == Verdict::undecided && agreement.limited())) {
        outcome.note = agreement.obstacle(needed);
    }
    if (outcome.verdict != Verdict::refuted ||
        std::holds_alternative<DecimalFormula>(printed_formula(claim))) {
        return outcome;
    }
    QuickSamples quick(claim, context, exact);
    RefutedFormula refuted = refuted_by_samples(claim, agreement, samples_at, outcome.evidence);
    refuted.passes_screening = [&](const formula::Expr& e) { return quick.passes_screening(e); };
    refuted.verdict_of = [&](const formula::Expr& e) -> std::optional<Verdict> {
        return confirmed_at_samples(samples_at, expand_definitions(e, claim.vocabulary), exact,
                                    scale, digits)
                   ? std::optional(Verdict::confirmed)
                   : std::nullopt;
    };
    diagnose(refuted, outcome);
    return outcome;
}

/// True if a confirmed claim holds to all digits, at samples spread evenly over the others.
bool holds_to_all_digits(const Claim& claim, const AuditContext& context, Evidence& evidence) {
    const auto samples_at =
        EvaluatedSamples::of(claim, context, context.digits(), ManyDigits::samples);
    std::optional<formula::Expr> scale;
    if (claim.has("scale")) {
        scale = claim.formula("scale");
    }
    const formula::Expr exact = claim.formula("of");
    const Agreement agreement = samples_at->compare(claim.formula("says"), exact, scale);
    Outcome more;
    report_agreement(agreement, *samples_at, context.digits(), more.evidence);
    const Judgement verdict =
        judge_formula(claim, *samples_at, agreement, exact, scale, context.digits(), more);
    evidence.add("all_digits", std::move(more.evidence));
    return verdict == Verdict::confirmed;
}

Outcome check_value(const Claim& claim, const AuditContext& context) {
    const bool integrals = has_binder(claim.formula("says")) || has_binder(claim.formula("of"));
    if (integrals && context.digits() > ManyDigits::everywhere) {
        Outcome outcome = compare_values(claim, context, ManyDigits::everywhere);
        if (outcome.verdict == Verdict::refuted || is_rounded(outcome) ||
            (outcome.verdict == Verdict::confirmed &&
             holds_to_all_digits(claim, context, outcome.evidence))) {
            return outcome;
        }
    }
    return compare_values(claim, context, context.digits());
}

} // namespace

CheckKind value_kind() {
    return {"value",
            {required_formula("says"), required_formula("of"), optional_formula("scale")},
            check_value};
}

} // namespace edgeproof::audit

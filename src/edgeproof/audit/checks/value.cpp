// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/checks/parts/rounded.hpp"

namespace edgeproof::audit {
namespace {

/// `digits` of context, or fewer.
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
    outcome.verdict = judge_samples(agreement, needed);
    outcome.evidence.add("of", claim.text("of"));
    outcome.sample_use = agreement.use(needed);
    report_agreement(agreement, samples_at, digits, outcome.evidence);
    add_enclosures(agreement, samples_at, printed, exact, scale, digits, outcome);
    judge_rounded(claim, samples_at, exact, digits, outcome);
    if (outcome.evidence.find("rounded") != nullptr) {
        return outcome;
    }
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = "agrees at " + std::to_string(samples_at.all().size()) + " samples";
        return outcome;
    }
    if (outcome.verdict != Verdict::refuted) {
        if (outcome.note.empty()) {
            outcome.note = agreement.obstacle(needed);
        }
        return outcome;
    }
    QuickSamples quick(claim, context, exact);
    RefutedFormula refuted = refuted_by_samples(claim, agreement, samples_at, outcome.evidence);
    refuted.passes_screening = [&](const formula::Expr& e) { return quick.passes_screening(e); };
    refuted.verdict_of = [&](const formula::Expr& e) -> std::optional<Verdict> {
        return judge_samples(
            samples_at.compare(expand_definitions(e, claim.vocabulary), exact, scale), needed);
    };
    diagnose(refuted, outcome);
    return outcome;
}

/// Whether a confirmed claim holds to all digits, at samples spread evenly over the others.
bool holds_to_all_digits(const Claim& claim, const AuditContext& context, Evidence& evidence) {
    const auto samples_at =
        EvaluatedSamples::of(claim, context, context.digits(), ManyDigits::samples);
    std::optional<formula::Expr> scale;
    if (claim.has("scale")) {
        scale = claim.formula("scale");
    }
    const Agreement agreement =
        samples_at->compare(claim.formula("says"), claim.formula("of"), scale);
    Evidence more;
    report_agreement(agreement, *samples_at, context.digits(), more);
    evidence.add("all_digits", std::move(more));
    return judge_samples(agreement, context.digits_needed()) == Verdict::confirmed;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"

namespace edgeproof::audit {
namespace {

/// Compares with the `digits` of the context, or fewer.
Outcome compare_values(const Claim& claim, const AuditContext& context, unsigned digits) {
    const FormulaComparison comparison(claim, context, digits);
    Outcome outcome;
    if (comparison.samples() == 0) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    outcome.evidence.add("of", claim.text("of"));
    comparison.judge("agrees at " + std::to_string(comparison.samples()) + " samples", outcome);
    if (comparison.needs_correction(outcome)) {
        RefutedFormula refuted = comparison.refuted(outcome.evidence);
        refuted.passes_screening = Screening(claim, context, claim.formula("of"));
        refuted.verdict_of = [&](const formula::Expr& e) {
            return comparison.confirms(expand_definitions(e, claim.vocabulary))
                       ? std::optional(Verdict::confirmed)
                       : std::nullopt;
        };
        diagnose(refuted, outcome);
    }
    return outcome;
}

/// True if a confirmed claim holds to all digits, at samples spread evenly over the others.
bool holds_to_all_digits(const Claim& claim, const AuditContext& context, Evidence& evidence) {
    Outcome more;
    FormulaComparison(claim, context, context.digits(), ManyDigits::samples).judge("", more);
    evidence.add("all_digits", std::move(more.evidence));
    return more.verdict == Verdict::confirmed;
}

} // namespace

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

} // namespace edgeproof::audit

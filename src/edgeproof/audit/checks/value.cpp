// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/comparison.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/rounded.hpp"

namespace edgeproof {
namespace {

/// `digits` of context, or fewer.
Outcome compare_values(const Claim& claim, const AuditContext& context, unsigned digits) {
    const Expr printed = claim.formula("says");
    const Expr exact = claim.formula("of");
    std::optional<Expr> scale;
    if (claim.has("scale")) {
        scale = claim.formula("scale");
    }
    const std::shared_ptr<Spots> sampled = Spots::of(claim, context, digits);
    Spots& spots = *sampled;
    Outcome outcome;
    if (spots.all().empty()) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    const Agreement agreement = spots.compare(printed, exact, scale);
    const double needed = AuditContext::digits_needed(digits);
    outcome.verdict = judge_samples(agreement, needed);
    outcome.evidence.add("of", claim.text("of"));
    report_agreement(agreement, spots, digits, outcome.evidence);
    add_enclosures(agreement, spots, printed, exact, scale, digits, outcome);
    judge_rounded(claim, spots, exact, digits, outcome);
    if (outcome.evidence.find("rounded") != nullptr) {
        return outcome;
    }
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = "agrees at " + std::to_string(spots.all().size()) + " samples";
        return outcome;
    }
    if (outcome.verdict != Verdict::refuted) {
        if (outcome.note.empty()) {
            outcome.note = agreement.obstacle(needed);
        }
        return outcome;
    }
    QuickSamples quick(claim, context, exact);
    Patient patient;
    patient.printed = claim.written("says");
    patient.exact = claim.written("of");
    patient.alphabet = alphabet_for(claim, patient.printed, claim.written("of"),
                                    &spots.all().front().sample.scene);
    patient.ratio = ratio_by_samples(agreement, spots, outcome.evidence);
    patient.looks_right = [&](const Expr& e) { return quick.looks_right(e); };
    patient.verdict_of = [&](const Expr& e) -> std::optional<Verdict> {
        return judge_samples(spots.compare(expand_definitions(e, claim.vocabulary), exact, scale),
                             needed);
    };
    diagnose(patient, outcome);
    return outcome;
}

/// Whether a confirmed claim holds to all digits, at samples spread evenly over the others.
bool holds_to_all_digits(const Claim& claim, const AuditContext& context, Evidence& evidence) {
    const auto spots = Spots::of(claim, context, context.digits(), ManyDigits::samples);
    std::optional<Expr> scale;
    if (claim.has("scale")) {
        scale = claim.formula("scale");
    }
    const Agreement agreement = spots->compare(claim.formula("says"), claim.formula("of"), scale);
    Evidence more;
    report_agreement(agreement, *spots, context.digits(), more);
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
    using Type = KeySpec::Type;
    return {"value",
            {{.name = "says", .type = Type::formula, .required = true},
             {.name = "of", .type = Type::formula, .required = true},
             {.name = "scale", .type = Type::formula}},
            check_value};
}

} // namespace edgeproof

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/comparison.hpp"
#include "edgeproof/audit/checks/kinds.hpp"

namespace edgeproof {
namespace {

Outcome check_value(const Claim& claim, const AuditContext& context) {
    const Expr printed = claim.formula("says");
    const Expr exact = claim.formula("of");
    std::optional<Expr> scale;
    if (claim.has("scale")) {
        scale = claim.formula("scale");
    }
    const std::shared_ptr<Spots> sampled = Spots::of(claim, context, context.digits());
    Spots& spots = *sampled;
    Outcome outcome;
    if (spots.all().empty()) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    const Agreement agreement = spots.compare(printed, exact, scale);
    outcome.verdict = verdict_by_samples(agreement, context);
    outcome.evidence.add("of", claim.text("of"));
    report_agreement(agreement, spots, context.digits(), outcome.evidence);
    add_enclosures(agreement, spots, printed, exact, scale, context.digits(), outcome);
    if (outcome.verdict == Verdict::confirmed) {
        outcome.note = "agrees at " + std::to_string(spots.all().size()) + " samples";
        return outcome;
    }
    if (outcome.verdict == Verdict::undecided) {
        if (outcome.note.empty()) {
            outcome.note = "the values are not good enough to decide";
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
        return verdict_by_samples(
            spots.compare(expand_definitions(e, claim.vocabulary), exact, scale), context);
    };
    diagnose(patient, outcome);
    return outcome;
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

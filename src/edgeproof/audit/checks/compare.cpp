// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::audit {
namespace {

/// The exact formula in symbols, and whether the printed one is identically equal to it.
struct Derivation {
    std::optional<Expr> exact;
    bool proved = false;
};

/// True for a formula in the derivatives of P and b, which the derived formula contains.
bool holds_derivative(const Expr& e) {
    return std::ranges::any_of(free_symbols(e), [](const std::string& name) {
        return order_behind(name, "P") || order_behind(name, "b");
    });
}

/// The derivations are those of plane contacts.
Derivation derivation_of(const Claim& claim, const AuditContext& context) {
    Derivation found;
    const SymbolicCase under = symbolic_case(claim, context);
    if (claim.has("over") && context.ledger().family(claim.text("over")).axisymmetric()) {
        return found;
    }
    try {
        const Expr& exact = claim.formula("of");
        const bool proved = proved_equal(claim.formula("says"), exact, under);
        if (proved || holds_derivative(claim.formula("says"))) {
            found = {derive(exact, under), proved};
        }
    } catch (const Error&) {
        // without algebra
    }
    return found;
}

} // namespace

Outcome check_compare(const Claim& claim, const AuditContext& context) {
    if (claim.has("quoted")) {
        for (const char* const key : {"says", "scale", "given"}) {
            if (claim.has(key)) {
                claim.reject(key,
                             "a quoted number is compared by rounding, without " + std::string(key),
                             "write says or quoted, not both");
            }
        }
        return compare_figure(claim, context);
    }
    const Derivation derivation = derivation_of(claim, context);
    const FormulaComparison comparison(claim, context);
    Outcome outcome;
    if (comparison.samples() == 0) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    outcome.evidence.add("of", claim.text("of"));
    if (derivation.proved) {
        outcome.evidence.add("derived", to_text(*derivation.exact));
    }
    comparison.judge(outcome);
    if (derivation.proved && outcome.verdict == Verdict::confirmed && !is_rounded(outcome)) {
        outcome.verdict = Judgement::proved_by_symbols();
        outcome.note = "identically equal to the derived form; " + outcome.note;
    } else if (derivation.proved && outcome.verdict == Verdict::refuted) {
        outcome.verdict = {};
        outcome.note = "equal in symbols but not at the samples";
    } else if (comparison.needs_correction(outcome)) {
        RefutedFormula refuted = comparison.refuted(outcome.evidence);
        if (derivation.exact) {
            refuted.derived = derivation.exact;
        }
        refuted.passes_screening = screening(claim, context);
        refuted.is_right = [&](const Expr& e) {
            return comparison.confirms(expand_definitions(e, claim.vocabulary));
        };
        diagnose(refuted, outcome);
    }
    return outcome;
}

} // namespace edgeproof::audit

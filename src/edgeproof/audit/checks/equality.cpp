// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {

namespace {

/// Tests candidates with random numbers for the symbols.
Screening formal_screening(const Claim& claim, const SymbolicCase& under, const Expr& derived,
                           const std::vector<std::string>& alphabet) {
    const PrecisionScope scope(FormalValues::digits);
    Screening screening(claim, FormalValues::digits, pow(Real(10), -30));
    std::set<std::string> names = free_symbols(derived);
    for (const std::string& name : alphabet) {
        names.merge(free_symbols(expand_definitions(Expr::symbol(name), claim.vocabulary)));
    }
    for (std::size_t draw = 0; draw < 40 && screening.points() < 3; ++draw) {
        try {
            const FormalValues values(names, under, draw);
            screening.add_point([values](const Expr& e) { return values.evaluate(e); },
                                values.evaluate(derived));
        } catch (const DomainError&) {
            continue; // a drawn point outside the domain of a root
        }
    }
    return screening;
}

/// Seeks a correction of a refuted formula; `derived`: the exact formula in symbols, if it is
/// known.
void correct(const FormulaComparison& comparison, const Claim& claim, const AuditContext& context,
             const std::optional<Expr>& derived, Outcome& outcome) {
    const SymbolicCase under = symbolic_case(claim, context);
    const Expr& exact = claim.formula("of");
    RefutedFormula refuted = comparison.refuted(outcome.evidence);
    if (derived && !refuted.ratio) {
        try {
            outcome.evidence.add("ratio", to_text(derive(claim.formula("says") / *derived, under)));
        } catch (const Error&) {
            outcome.evidence.add("ratio", "no closed form");
        }
    }
    refuted.derived = derived ? derived : refuted.derived;
    refuted.passes_screening =
        derived ? formal_screening(claim, under, *derived, refuted.alphabet.symbols)
                : Screening(claim, context, exact);
    refuted.verdict_of = [&](const Expr& e) -> std::optional<Verdict> {
        const Expr full = expand_definitions(e, claim.vocabulary);
        if (!comparison.confirms(full)) {
            return std::nullopt;
        }
        return derived && proved_equal(full, exact, under) ? Verdict::proved : Verdict::confirmed;
    };
    diagnose(refuted, outcome);
}

/// Compares with the `digits` of the context, or fewer.
Outcome compare_values(const Claim& claim, const AuditContext& context, unsigned digits) {
    const FormulaComparison comparison(claim, context, digits);
    Outcome outcome;
    if (comparison.samples() == 0) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    outcome.evidence.add("of", claim.text("of"));
    comparison.judge(outcome);
    if (comparison.needs_correction(outcome)) {
        correct(comparison, claim, context, std::nullopt, outcome);
    }
    return outcome;
}

/// True if a confirmed claim holds to all digits, at samples spread evenly over the others.
bool holds_to_all_digits(const Claim& claim, const AuditContext& context, Evidence& evidence) {
    Outcome more;
    FormulaComparison(claim, context, context.digits(), ManyDigits::samples).judge(more);
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

Outcome check_identity(const Claim& claim, const AuditContext& context) {
    const Expr& exact = claim.formula("of");
    const SymbolicCase under = symbolic_case(claim, context);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"));
    std::optional<Expr> derived;
    bool proved = false;
    try {
        derived = derive(exact, under);
        proved = proved_equal(claim.formula("says"), exact, under);
        outcome.evidence.add("derived", to_text(*derived));
    } catch (const Error& error) {
        outcome.evidence.add("not_symbolic", error.what());
    }
    // Compare at samples, too: there the exact value is computed from the contact, without symbols.
    const FormulaComparison comparison(claim, context, context.digits());
    comparison.judge(outcome);
    if (outcome.verdict == Verdict::confirmed && !is_rounded(outcome)) {
        outcome.note = proved ? "identically equal to the derived form; " + outcome.note
                              : outcome.note + "; not proved in symbols";
    }
    if (proved && outcome.evidence.find("rounded") == nullptr) {
        const bool confirmed = outcome.verdict == Verdict::confirmed;
        outcome.verdict = confirmed ? Judgement::proved_by_symbols() : Judgement();
        if (!confirmed) {
            outcome.note = "equal in symbols but not at the samples";
        }
    } else if (comparison.needs_correction(outcome)) {
        correct(comparison, claim, context, derived, outcome);
    }
    return outcome;
}

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/checks/parts/comparison.hpp"
#include "edgeproof/audit/sample/formal_values.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {
namespace {

/// Tests candidates with random numbers for the symbols.
class QuickSymbols {
public:
    QuickSymbols(const Claim& claim, const SymbolicCase& under, const formula::Expr& derived,
                 const std::vector<std::string>& alphabet)
        : claim_(claim) {
        std::set<std::string> names = free_symbols(derived);
        for (const std::string& name : alphabet) {
            names.merge(
                free_symbols(expand_definitions(formula::Expr::symbol(name), claim.vocabulary)));
        }
        for (std::size_t draw = 0; draw < 40 && draws_.size() < 3; ++draw) {
            try {
                FormalValues values(names, under, draw);
                const Real target = values.evaluate(derived);
                draws_.emplace_back(std::move(values), target);
            } catch (const DomainError&) {
                continue; // a drawn point outside the domain of a root
            }
        }
    }
    [[nodiscard]] bool passes_screening(const formula::Expr& written) const {
        const formula::Expr e = expand_definitions(written, claim_.vocabulary);
        const PrecisionScope scope(FormalValues::digits);
        const Real tolerance = pow(Real(10), -30);
        return !draws_.empty() && std::all_of(draws_.begin(), draws_.end(), [&](const auto& draw) {
            return abs(draw.first.evaluate(e) - draw.second) <= tolerance * abs(draw.second);
        });
    }

private:
    const Claim& claim_;
    std::vector<std::pair<FormalValues, Real>> draws_;
};

Outcome check_identity(const Claim& claim, const AuditContext& context) {
    const formula::Expr printed = claim.formula("says");
    const formula::Expr exact = claim.formula("of");
    const SymbolicCase under = symbolic_case(claim, context);
    Outcome outcome;
    outcome.evidence.add("of", claim.text("of"));
    std::optional<formula::Expr> derived;
    bool proved = false;
    try {
        derived = derive(exact, under);
        proved = proved_equal(printed, exact, under);
    } catch (const Error& error) {
        outcome.evidence.add("not_symbolic", error.what());
    }
    if (derived) {
        outcome.evidence.add("derived", to_text(*derived)).add("derived_tex", to_tex(*derived));
    }
    // Compare at samples, too: there the exact value is computed from the contact, without symbols.
    const std::shared_ptr<EvaluatedSamples> sampled =
        EvaluatedSamples::of(claim, context, context.digits());
    EvaluatedSamples& samples_at = *sampled;
    const Agreement agreement = samples_at.compare(printed, exact);
    outcome.sample_use = agreement.use(context.digits_needed());
    report_agreement(agreement, samples_at, context.digits(), outcome.evidence);
    const Judgement by_samples = samples_at.all().empty()
                                     ? Judgement()
                                     : judge_formula(claim, samples_at, agreement, exact,
                                                     std::nullopt, context.digits(), outcome);
    outcome.verdict = by_samples;
    if (outcome.evidence.find("rounded") != nullptr) {
        return outcome;
    }
    if (proved) {
        outcome.verdict =
            by_samples == Verdict::confirmed ? Judgement::proved_by_symbols() : Judgement();
        outcome.note = by_samples == Verdict::confirmed
                           ? "identically equal to the derived form; agrees at " +
                                 std::to_string(samples_at.all().size()) + " samples"
                           : "equal in symbols but not at the samples";
        return outcome;
    }
    if (by_samples != Verdict::refuted ||
        std::holds_alternative<DecimalFormula>(printed_formula(claim))) {
        if (by_samples == Verdict::confirmed) {
            outcome.note = "agrees at the samples; not proved in symbols";
        } else if (outcome.note.empty() ||
                   (by_samples == Verdict::undecided && agreement.limited())) {
            outcome.note = agreement.obstacle(context.digits_needed());
        }
        return outcome;
    }
    RefutedFormula refuted = refuted_by_samples(claim, agreement, samples_at, outcome.evidence);
    if (derived && !refuted.ratio) {
        try {
            const formula::Expr ratio = derive(printed / *derived, under);
            outcome.evidence.add("ratio", to_text(ratio)).add("ratio_tex", to_tex(ratio));
        } catch (const Error&) {
            outcome.evidence.add("ratio", "no closed form");
        }
    }
    refuted.verdict_of = [&](const formula::Expr& e) -> std::optional<Verdict> {
        const formula::Expr full = expand_definitions(e, claim.vocabulary);
        if (!confirmed_at_samples(samples_at, full, exact, std::nullopt, context.digits())) {
            return std::nullopt;
        }
        return derived && proved_equal(full, exact, under) ? Verdict::proved : Verdict::confirmed;
    };
    std::optional<QuickSymbols> quick;
    std::optional<QuickSamples> sampled_quick;
    if (derived) {
        refuted.derived = derived;
        quick.emplace(claim, under, *derived, refuted.alphabet.symbols);
        refuted.passes_screening = [&](const formula::Expr& e) {
            return quick->passes_screening(e);
        };
    } else {
        sampled_quick.emplace(claim, context, exact);
        refuted.passes_screening = [&](const formula::Expr& e) {
            return sampled_quick->passes_screening(e);
        };
    }
    diagnose(refuted, outcome);
    return outcome;
}

} // namespace

CheckKind identity_kind() {
    using Type = KeySpec::Type;
    return {"identity",
            {required_formula("says"),
             required_formula("of"),
             {.name = "given", .type = Type::formula_table}},
            check_identity};
}

} // namespace edgeproof::audit

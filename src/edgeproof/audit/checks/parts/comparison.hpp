// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"

#include <memory>
#include <optional>

/// Functions that the kinds value, identity and expansion share.
namespace edgeproof::audit {

/// b = a for a family of symmetric contacts; P(a), b(a) if `given` names them.
[[nodiscard]] SymbolicCase symbolic_case(const Claim& claim, const AuditContext& context);

/// Adds the digits, the samples and the worst sample to the evidence.
void report_agreement(const Agreement& agreement, const EvaluatedSamples& samples_at,
                      unsigned digits, Evidence& evidence);

/// Judges two formulas at the samples of a claim, and adds `note` and the evidence. A printed
/// formula with decimals is confirmed as it stands or with other numbers that round to them (then
/// the evidence has `rounded`), and refuted if no such numbers fit.
[[nodiscard]] Judgement judge_formula(const Claim& claim, EvaluatedSamples& samples_at,
                                      const Agreement& agreement, const formula::Expr& exact,
                                      const std::optional<formula::Expr>& scale, unsigned digits,
                                      Outcome& outcome);

/// True if a formula that the program made is confirmed at the samples, by enclosures.
[[nodiscard]] bool confirmed_at_samples(EvaluatedSamples& samples_at, const formula::Expr& made,
                                        const formula::Expr& exact,
                                        const std::optional<formula::Expr>& scale, unsigned digits);

/// Returns the data for the diagnosis: the formulas `says` and `of`, the names of the claim and of
/// the first sample's scene, and printed/exact at all samples, if it is recognised. Also adds the
/// range of this ratio to the evidence.
[[nodiscard]] RefutedFormula refuted_by_samples(const Claim& claim, const Agreement& agreement,
                                                const EvaluatedSamples& samples_at,
                                                Evidence& evidence);

/// Tests candidates at a few samples, to a few digits; expressions are as written in the claim.
class QuickSamples {
public:
    QuickSamples(const Claim& claim, const AuditContext& context, const formula::Expr& exact);
    [[nodiscard]] bool passes_screening(const formula::Expr& written);

private:
    static constexpr unsigned digits = 10;
    static constexpr std::size_t most_samples = 4;
    const Claim& claim_;
    std::shared_ptr<EvaluatedSamples> samples_at_;
    std::vector<std::pair<std::size_t, Real>> targets_;
};

} // namespace edgeproof::audit

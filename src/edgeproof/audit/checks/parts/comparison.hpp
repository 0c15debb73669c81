// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/diagnosis/diagnosis.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The common parts of the kinds that compare formulas.
namespace edgeproof::audit {

/// Returns the formulas of a list or table of a claim, each with its text in the list or its name
/// in the table; none if the claim has no such field.
[[nodiscard]] std::vector<std::pair<std::string, Expr>> named_formulas(const Claim& claim,
                                                                       std::string_view key);

/// b = a for a family of symmetric contacts; P(a), b(a) if `given` names them.
[[nodiscard]] SymbolicCase symbolic_case(const Claim& claim, const AuditContext& context);

/// Returns a test of candidates for a correction in numbers, to a few digits: true for a formula
/// (as written in the claim) that has the exact value at a few samples of the claim and at other
/// contacts. It refers to the claim.
[[nodiscard]] std::function<bool(const Expr&)> screening(const Claim& claim,
                                                         const AuditContext& context);

/// The formulas `says` and `of` of a claim, compared at its samples; `scale`, if the claim has it,
/// is the reference for their difference.
class FormulaComparison {
public:
    FormulaComparison(const Claim& claim, const AuditContext& context);

    [[nodiscard]] std::size_t samples() const { return samples_.all().size(); }
    /// Judges the printed formula by enclosures, and adds the note and the evidence: the digits,
    /// the samples, the worst sample and its enclosures. A printed formula with decimals is
    /// confirmed as it stands or with other numbers that round to them (then the evidence has
    /// `rounded`), and refuted if no such numbers fit.
    void judge(Outcome& outcome) const;
    /// True if the judged formula is refuted, or has no value at some samples, so that a correction
    /// is sought: not for a formula with decimals, for which `judge` has found numbers that fit.
    [[nodiscard]] bool needs_correction(const Outcome& outcome) const;
    /// True if a formula that the program made is confirmed at the samples, by enclosures, and not
    /// proved to differ at more digits.
    [[nodiscard]] bool confirms(const Expr& made) const;
    /// Returns the data for the diagnosis: the formulas, the names of the claim and of the first
    /// sample's scene, and printed/exact at all samples, if it is recognised. Also adds the range
    /// of this ratio to the evidence.
    [[nodiscard]] RefutedFormula refuted(Evidence& evidence) const;

private:
    [[nodiscard]] SampledComparison with() const { return {samples_, exact_, scale_, digits_}; }
    void report(Evidence& evidence) const;
    [[nodiscard]] Judgement by_enclosures(Outcome& outcome) const;
    [[nodiscard]] Judgement by_decimals(Outcome& outcome) const;
    [[nodiscard]] std::optional<Expr> ratio(Evidence& evidence) const;
    [[nodiscard]] std::optional<Expr> of_cylinder() const;

    const Claim& claim_;
    PrintedFormula printed_;
    Expr exact_;
    std::optional<Expr> scale_;
    unsigned digits_;
    ClaimSamples samples_;
    Agreement agreement_; ///< of the formula as it is printed
};

} // namespace edgeproof::audit

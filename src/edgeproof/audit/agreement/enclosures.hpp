// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include <array>
#include <string_view>

namespace edgeproof::audit {

/// Two formulas that are equal according to a claim. Their difference is compared with `scale`; if
/// there is none, with the exact value; if that is zero, with the sum of the sizes of the terms.
struct ComparedFormulas {
    formula::Expr printed;
    formula::Expr exact;
    std::optional<formula::Expr> scale;
    [[nodiscard]] bool have_integrals() const { return has_binder(printed) || has_binder(exact); }
};

/// Judges a printed formula by enclosures at the samples of a claim. `agreement` (in Real) only
/// determines the order of the samples. Adds the evidence `enclosures`.
/// Refuted: the two balls are disjoint at one sample.
/// Confirmed: see compare_by_enclosures.
/// Underspecified: the printed formula has no value at some sample, and differs at none.
[[nodiscard]] Judgement judge_by_enclosures(const Agreement& agreement,
                                            const EvaluatedSamples& samples_at,
                                            const ExactFormula& printed, const formula::Expr& exact,
                                            const std::optional<formula::Expr>& scale,
                                            unsigned digits, Outcome& outcome);

/// Compares two formulas at the samples by enclosures. They agree if the balls prove D - 5 digits
/// at every sample; for formulas with integrals, at the samples that agree least and at some others
/// (the evidence states their number). Returns nothing, and adds a note, if the balls do not
/// decide.
[[nodiscard]] Decision compare_by_enclosures(const Agreement& agreement,
                                             const EvaluatedSamples& samples_at,
                                             const ComparedFormulas& formulas, unsigned digits,
                                             Outcome& outcome);

/// Two numbers that are equal according to a claim.
struct ComparedNumbers {
    std::string first_name;
    Enclosed first;
    std::string second_name;
    Enclosed second;
    std::string at; ///< the sample
};

/// Adds two enclosures to the evidence.
void add_pair(const ComparedNumbers& numbers, unsigned digits, Evidence& evidence);

/// The evidence of a verdict.
enum class Basis {
    theorem,    ///< theorems that Coq checked and that state the whole verdict
    identity,   ///< computer algebra: printed minus derived is zero
    enclosures, ///< balls at the samples: disjoint, or equal to the digits that the balls prove
    text,       ///< the printed text: it contains nothing that has a value
    none        ///< nothing: the verdict is `undecided`
};
inline constexpr std::array<Basis, 5> all_bases{Basis::theorem, Basis::identity, Basis::enclosures,
                                                Basis::text, Basis::none};
/// "theorem", "identity", "enclosures", "text", "none".
[[nodiscard]] std::string_view name_of(Basis basis);
/// The strongest basis of the whole verdict.
[[nodiscard]] Basis basis_of(const ClaimResult& result);

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/audit_result.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include <array>
#include <string_view>

namespace edgeproof::audit {

/// Two formulas that a claim says are equal, and what their difference is compared with: `scale`,
/// or where there is none the exact value, or where that is zero the sum of the sizes of the terms.
struct ComparedFormulas {
    formula::Expr printed;
    formula::Expr exact;
    std::optional<formula::Expr> scale;
    [[nodiscard]] bool have_integrals() const { return has_binder(printed) || has_binder(exact); }
};

/// The verdict on a printed formula, by enclosures at the samples of a claim. `agreement` (in Real)
/// only says where to look first. Evidence `enclosures`.
/// Refuted: at one sample the two balls have no number in common.
/// Confirmed: as below.
/// Underspecified: the printed formula has no value at some sample, and differs at none.
[[nodiscard]] Judgement judge_by_enclosures(const Agreement& agreement,
                                            const EvaluatedSamples& samples_at,
                                            const ExactFormula& printed, const formula::Expr& exact,
                                            const std::optional<formula::Expr>& scale,
                                            unsigned digits, Outcome& outcome);

/// What the enclosures decide of two formulas at the samples. They agree if the balls prove D - 5
/// digits at every sample, or where there are integrals at the samples that agree least and at some
/// others, which the evidence counts. Nothing, and a note, where the balls decide nothing.
[[nodiscard]] Decision compare_by_enclosures(const Agreement& agreement,
                                             const EvaluatedSamples& samples_at,
                                             const ComparedFormulas& formulas, unsigned digits,
                                             Outcome& outcome);

/// Two numbers that a claim says are equal.
struct ComparedNumbers {
    std::string first_name;
    Enclosed first;
    std::string second_name;
    Enclosed second;
    std::string at; ///< the sample
};

/// Puts two enclosures into the evidence.
void add_pair(const ComparedNumbers& numbers, unsigned digits, Evidence& evidence);

/// What a verdict rests on.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include <array>
#include <string_view>

namespace edgeproof::audit {

/// The values that a printed formula is compared with at the samples of a claim. Differences are
/// compared with `scale`; if there is none, with the exact value; if that is zero, with the sum of
/// the sizes of the terms.
struct SampledComparison {
    const EvaluatedSamples& samples_at;
    const Agreement& agreement; ///< in Real; only determines the order of the samples
    Expr exact;
    std::optional<Expr> scale;
    unsigned digits = 0;
};

/// Judges a printed formula by enclosures at the samples. Adds the evidence `enclosures`.
/// Refuted: the two balls are disjoint at one sample, and do not prove D - 5 digits there.
/// Confirmed: see compare_by_enclosures.
/// Underspecified: the printed formula has no value at some sample, and differs at none.
[[nodiscard]] Judgement judge_by_enclosures(const ExactFormula& printed,
                                            const SampledComparison& with, Outcome& outcome);

/// Compares two formulas at the samples by enclosures. They agree if the balls prove D - 5 digits
/// at every sample; for formulas with integrals, at the samples that agree least and at some others
/// (the evidence states their number). The note has the number of samples enclosed, and the
/// greatest difference that is proved; or why the balls do not decide.
[[nodiscard]] Decision compare_by_enclosures(const Expr& printed, const SampledComparison& with,
                                             Outcome& outcome);

/// True if a formula that the program made is proved to differ at one of these samples, by balls of
/// twice the digits: it is then no correction, however well it agrees.
[[nodiscard]] bool provably_different(const Expr& made, SampledComparison with);

/// Returns the evidence on two numbers that are equal according to a claim: their enclosures at a
/// sample, and whether these are disjoint.
[[nodiscard]] Evidence pair_evidence(const std::string& at, std::string_view first_name,
                                     const Ball& first, std::string_view second_name,
                                     const Ball& second, unsigned digits);
/// The same; or the reason why there is no enclosure.
[[nodiscard]] Evidence pair_evidence(const std::string& at, std::string_view first_name,
                                     const Enclosed& first, std::string_view second_name,
                                     const Enclosed& second, unsigned digits);

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
/// The verdict in a table for people: "confirmed at the samples" where nothing is proved between
/// them.
[[nodiscard]] std::string verdict_text(const ClaimResult& result);

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/audit_result.hpp"

#include <array>
#include <string_view>

namespace edgeproof::audit {

/// What balls say of a verdict that was found in Real, put into its evidence as `enclosures`.
/// Refuted: the two balls at a sample where they have no number in common, the verdict's proof.
/// Confirmed: the least number of digits to which the balls prove agreement, relative to `scale`
/// where there is one, and at how many samples (of integrals, those that agree least and some of
/// the others); both balls of the worst. Balls that have no number in common make it undecided.
/// Where there is no enclosure (a profile without a closed form) it says so, and why.
void add_enclosures(const Agreement& agreement, const EvaluatedSamples& samples_at,
                    const formula::Expr& printed, const formula::Expr& exact,
                    const std::optional<formula::Expr>& scale, unsigned digits, Outcome& outcome);

/// The same for two numbers that a check found to differ: the evidence of two balls. A verdict of
/// refuted becomes undecided if they do overlap.
void add_pair(const std::string& first, const Enclosed& x, const std::string& second,
              const Enclosed& y, const std::string& at, unsigned digits, Outcome& outcome);

/// Whether a refutation is proved by disjoint enclosures: under every reading that fails.
[[nodiscard]] bool rests_on_enclosures(const ClaimResult& result);

/// What a verdict rests on.
enum class Basis {
    theorem,    ///< theorems that Coq checks, which say all that the verdict does
    identity,   ///< a computer algebra system's: printed less derived is zero
    enclosures, ///< balls: disjoint, or agreeing to the digits that they prove, at the samples
    estimates,  ///< values in `Real` by quadratures and closed forms, at the samples
    text        ///< what is printed: nothing in it that has a value to check
};
inline constexpr std::array<Basis, 5> all_bases{Basis::theorem, Basis::identity, Basis::enclosures,
                                                Basis::estimates, Basis::text};
/// "theorem", "identity", "enclosures", "estimates", "text".
[[nodiscard]] std::string_view name_of(Basis basis);
/// The firmest that holds of the whole verdict: of several readings, each has to have it.
[[nodiscard]] Basis basis_of(const ClaimResult& result);

} // namespace edgeproof::audit

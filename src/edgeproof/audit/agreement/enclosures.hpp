// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/agreement/samples.hpp"
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"

#include <array>
#include <string_view>

namespace edgeproof::audit {

/// The values that a printed formula is compared with at the samples of a claim. Differences are
/// compared with `scale`; if there is none, with the exact value; if that is zero, with the sum of
/// the sizes of the terms.
struct SampledComparison {
    const ClaimSamples& samples;
    Expr exact;
    std::optional<Expr> scale;
    unsigned digits = 0;
};

/// A printed formula and the exact one in balls at one sample.
struct Pair {
    std::size_t sample = 0; ///< its index
    /// Together, or none; `exact` also without a printed value.
    std::optional<Ball> printed;
    std::optional<Ball> exact;
    std::optional<Ball> scale;
    std::string problem;                 ///< the reason why there is no enclosure
    std::optional<std::string> no_value; ///< the reason why the printed formula has no value

    [[nodiscard]] bool apart() const { return printed && disjoint(*printed, *exact); }
    [[nodiscard]] std::optional<Confirmation> agreement(double digits) const;
    /// Made if the balls are disjoint and do not prove agreement to these digits.
    [[nodiscard]] std::optional<Refutation> refutation(double digits) const;
    /// Returns the greatest relative difference that the balls prove; 0 if they overlap.
    [[nodiscard]] Real proved_difference() const;
    /// Returns the digits to which any two numbers in the balls agree, relative to the scale; a
    /// large negative number if there are none.
    [[nodiscard]] double digits() const;
};

/// A printed formula compared by enclosures at all samples; for formulas with integrals at some
/// that are spread from the first to the last, and at any other sample where enclosures to a few
/// digits do not show that the formulas agree.
class Agreement {
public:
    Agreement(const Expr& printed, const SampledComparison& with);

    [[nodiscard]] const std::vector<Pair>& pairs() const noexcept { return pairs_; }
    /// The pair with the fewest digits of agreement.
    [[nodiscard]] const Pair& worst() const;
    /// The number of other samples, at which the formulas agree to a few digits.
    [[nodiscard]] std::size_t screened() const noexcept { return screened_; }
    /// Confirmed if the balls prove D - 5 digits at every pair; refuted if they prove that the
    /// formulas differ at one. The note has the number of samples enclosed, and the greatest
    /// difference that is proved; or why the balls do not decide. Adds the evidence `enclosures`.
    [[nodiscard]] Decision decide(Outcome& outcome) const;
    /// The same. Underspecified: the printed formula has no value at some sample, and differs at
    /// none. Only for a printed formula whose decimals are exact.
    [[nodiscard]] Judgement judge(Outcome& outcome) const;

private:
    [[nodiscard]] std::string without_value() const;
    [[nodiscard]] Evidence evidence(const Pair& pair) const;
    const ClaimSamples& samples_;
    unsigned digits_;
    std::vector<Pair> pairs_;
    std::size_t screened_ = 0;
};

/// True if a formula that the program made is proved to differ at one of these samples, by balls of
/// twice the digits: it is then no correction, however well it agrees.
[[nodiscard]] bool provably_different(const Expr& made, SampledComparison with);

/// Returns the evidence on two numbers that are equal according to a claim: their enclosures at a
/// sample, and whether these are disjoint.
[[nodiscard]] Evidence pair_evidence(const std::string& at, std::string_view first_name,
                                     const Ball& first, std::string_view second_name,
                                     const Ball& second, unsigned digits);
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

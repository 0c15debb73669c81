// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace edgeproof::audit {

/// Returns the family and the text of a scene or of a sample: "hertz: a = 3/2, m = 1".
[[nodiscard]] inline std::string full_text(const SceneSpec& scene) {
    return scene.family + ": " + scene.text();
}
[[nodiscard]] inline std::string full_text(const Sample& sample) {
    return sample.scene.family + ": " + sample.text();
}

/// Returns the reason why a formula is proved to have no value at a sample, if it is one of these:
/// a division by an expression that is zero (by symbols), or its logarithm or negative power; a
/// root, a logarithm or an inverse function of a number outside its domain; pressure or full-stick
/// traction at a place outside the contact; the law of a contact (b, its inverse, P, P') at a size
/// that is not positive; an integrand that is not integrable at an end. Integrals are checked at
/// some places within their limits, too. Returns nothing where balls do not prove it.
[[nodiscard]] std::optional<std::string> no_value_of(const Expr& e, const Sample& sample,
                                                     long bits);

/// The samples of a claim that its `where` certainly admits. Keeps their enclosures. Not
/// thread-safe: one thread may use an object at a time.
class ClaimSamples {
public:
    ClaimSamples(const Claim& claim, const AuditContext& context);

    [[nodiscard]] const std::vector<Sample>& all() const noexcept { return samples_; }
    /// The number of samples that `where` does not certainly admit.
    [[nodiscard]] std::size_t left_out() const noexcept { return left_out_; }
    [[nodiscard]] std::size_t scenes() const;
    /// `integral_digits`: as in EnclosedSample.
    [[nodiscard]] const EnclosedSample& enclosed(std::size_t sample, long bits,
                                                 unsigned integral_digits) const;

private:
    std::vector<Sample> samples_;
    mutable std::map<std::tuple<std::size_t, long, unsigned>, EnclosedSample> enclosed_;
    std::size_t left_out_ = 0;
};

/// True if `where` of the claim (if it has one) certainly holds at a sample.
[[nodiscard]] bool is_admitted(const Claim& claim, const Sample& sample);

/// Returns a text such as "17.3" for digits in evidence, limited to a useful maximum.
[[nodiscard]] std::string digits_text(double digits);
/// Returns a value rounded for evidence.
[[nodiscard]] std::string value_text(const Real& value, unsigned digits);

/// The values that a printed formula is compared with at the samples of a claim. Differences are
/// compared with `scale`; if there is none, with the exact value; if that is zero, with the sum of
/// the sizes of the terms.
struct SampledComparison {
    const ClaimSamples& samples;
    Expr exact;
    std::optional<Expr> scale;
    unsigned digits = 0;
    bool identical = false; ///< proved in symbols: no difference is looked for
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
    /// difference that is proved; or why the balls do not decide. If parts of the formulas are too
    /// small for these balls, such as 1e-300, balls of more bits look for a difference. Adds the
    /// evidence `enclosures`.
    [[nodiscard]] Decision decide(Outcome& outcome) const;
    /// The same. Underspecified: the printed formula has no value at some sample, and differs at
    /// none. Only for a printed formula whose decimals are exact.
    [[nodiscard]] Judgement judge(Outcome& outcome) const;

private:
    [[nodiscard]] std::string without_value() const;
    [[nodiscard]] Evidence evidence(const Pair& pair) const;
    Expr printed_;
    SampledComparison with_;
    std::vector<Pair> pairs_;
    std::size_t screened_ = 0;
};

/// Returns the number of bits between the least and the greatest of 1 and the parts of a formula
/// without functions of the contact: of constants such as 1e-300 or exp(-700), of products and
/// powers such as u^9, and of last terms; at most 50,000.
[[nodiscard]] long spread_of_parts(const Expr& e, const EnclosedSample& at);

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

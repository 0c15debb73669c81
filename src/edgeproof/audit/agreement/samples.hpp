// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"
#include "edgeproof/audit/sample/evaluated_scene.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace edgeproof::audit {

/// Returns the family and the text of a scene or of a sample: "hertz: a = 3/2, m = 1".
[[nodiscard]] inline std::string full_text(const SceneSpec& scene) {
    return scene.family + ": " + scene.text();
}
[[nodiscard]] inline std::string full_text(const Sample& sample) {
    return sample.scene.family + ": " + sample.text();
}

/// One sample of a claim in numbers.
struct EvaluatedSample {
    const EvaluatedScene* scene_values;
    std::optional<Place> place;
    Variables variables;
    std::string text;
    Sample sample; ///< the exact sample from which it was made

    [[nodiscard]] FormulaValue evaluate(const Expr& e, IntegralCache* cache = nullptr) const {
        return scene_values->evaluate(e, place ? &*place : nullptr, variables, cache);
    }
};

/// Returns the reason why a formula has no value at a sample, if it is one of these: a division by
/// an expression that is zero (by symbols), or its logarithm or negative power; a root, a logarithm
/// or an inverse function of a number outside its domain; pressure or full-stick traction at a
/// place outside the contact; the law of a contact (b, its inverse, P, P') at a size that is not
/// positive. A number must be beyond its domain by more than 1e-20 of its terms, while some hundred
/// digits are used. Integrals are checked at some places within their limits. `proved`: by symbols
/// or by a ball. Returns nothing if roundoff may be the cause.
[[nodiscard]] std::optional<NoValue> no_value_of(const Expr& e, const EvaluatedSample& sample_at);

/// The values of two formulas at one sample: finite, with convergence of every integral.
struct ValuePair {
    Real printed;
    Real exact;
    double digits = 0; ///< digits of agreement
    Real error;        ///< an estimated error bound of their difference, with a margin
};

/// The comparison of two formulas at one sample: both values; or the printed one has no value; or
/// the program found no value.
class SampleAgreement {
public:
    SampleAgreement(ValuePair values) : found_(std::move(values)) {} // NOLINT: converts on purpose
    SampleAgreement(NoValue no_value) : found_(std::move(no_value)) {} // NOLINT
    SampleAgreement(OurLimit limit) : found_(std::move(limit)) {}      // NOLINT

    /// Returns nullptr if there are no values.
    [[nodiscard]] const ValuePair* values() const { return std::get_if<ValuePair>(&found_); }
    [[nodiscard]] const NoValue* no_value() const { return std::get_if<NoValue>(&found_); }
    [[nodiscard]] const OurLimit* limit() const { return std::get_if<OurLimit>(&found_); }
    /// The digits of agreement; a large negative number if there are no values.
    [[nodiscard]] double digits() const;
    /// The reason why there are no values; empty if there are.
    [[nodiscard]] std::string problem() const;

private:
    std::variant<ValuePair, NoValue, OurLimit> found_;
};

/// The comparison of two formulas at all samples.
struct Agreement {
    std::vector<SampleAgreement> samples_at;
    std::size_t worst = 0; ///< index of the sample with the fewest digits of agreement
    [[nodiscard]] double digits() const {
        return samples_at.empty() ? 0 : samples_at[worst].digits();
    }
    /// True if the formulas agree to this number of digits at every sample.
    [[nodiscard]] bool to(double digits) const;
    /// The number of samples at which the printed formula has no value.
    [[nodiscard]] std::size_t without_value() const;
    /// True if the program found no value at some sample.
    [[nodiscard]] bool limited() const;
    /// Returns how the verdict depends on the samples.
    [[nodiscard]] SampleUse use(double digits_needed) const;
    /// Explains why the values do not give a verdict.
    [[nodiscard]] std::string obstacle(double digits_needed) const;
};

/// The samples of a claim, at a given number of digits, that its `where` admits; or `most` of them,
/// spread evenly, or (for screening) those farthest from an edge. Stores the values of formulas
/// used in comparisons, and of integrals. Not thread-safe: one thread may use an object at a time.
class EvaluatedSamples {
public:
    /// Returns samples, shared by claims with the same sampling; made once for each run and thread.
    [[nodiscard]] static std::shared_ptr<EvaluatedSamples> of(const Claim& claim,
                                                              const AuditContext& context,
                                                              unsigned digits, std::size_t most = 0,
                                                              Effort effort = Effort::full);
    EvaluatedSamples(const Claim& claim, const AuditContext& context, unsigned digits,
                     std::size_t most = 0, Effort effort = Effort::full);

    [[nodiscard]] const std::vector<EvaluatedSample>& all() const noexcept { return samples_at_; }
    /// The number of samples that `where` leaves out.
    [[nodiscard]] std::size_t left_out() const noexcept { return left_out_; }
    [[nodiscard]] std::size_t scenes() const noexcept { return scene_values_.size(); }
    /// Compares two formulas. `scale`: the reference for a difference if the exact value is zero.
    /// Throws Interrupted.
    [[nodiscard]] Agreement compare(const Expr& printed, const Expr& exact,
                                    const std::optional<Expr>& scale = std::nullopt);
    /// Returns the value, at a sample, of a formula that is compared with many others.
    [[nodiscard]] FormulaValue known(const Expr& e, std::size_t sample_at);
    [[nodiscard]] const EnclosedSample& enclosed(std::size_t sample_at, long bits,
                                                 unsigned integral_digits) const;
    [[nodiscard]] FormulaValue value(const Expr& e, std::size_t sample_at) {
        return samples_at_[sample_at].evaluate(e, &caches_[sample_at]);
    }

private:
    [[nodiscard]] SampleAgreement compare_at(std::size_t i, const Expr& printed, const Expr& exact,
                                             const std::optional<Expr>& scale);
    std::vector<std::unique_ptr<EvaluatedScene>> scene_values_;
    std::vector<EvaluatedSample> samples_at_;
    std::vector<IntegralCache> caches_;
    mutable std::map<std::tuple<std::size_t, long, unsigned>, EnclosedSample> enclosed_;
    std::size_t left_out_ = 0;
    unsigned digits_;
    const AuditContext& context_;
};

/// Returns a text such as "17.3" for digits in evidence, limited to a useful maximum.
[[nodiscard]] std::string digits_text(double digits);
/// Returns a value rounded for evidence.
[[nodiscard]] std::string value_text(const Real& value, unsigned digits);

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/outcome.hpp"
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

/// One sample of a claim in numbers.
struct EvaluatedSample {
    const EvaluatedScene* scene_values;
    std::optional<Place> place;
    Variables variables;
    std::string text;
    Sample sample; ///< what it was made from: exact

    [[nodiscard]] FormulaValue evaluate(const formula::Expr& e,
                                        IntegralCache* cache = nullptr) const {
        return scene_values->evaluate(e, place ? &*place : nullptr, variables, cache);
    }
};

/// The values of two formulas at one sample: finite, and every integral in them converged.
struct ValuePair {
    Real printed;
    Real exact;
    double digits = 0; ///< to which they agree
    Real error;        ///< an estimate of what their difference may be off by, with a margin
};

/// Two formulas at one sample: both values, or that the printed one has none, or that we found
/// none.
class SampleAgreement {
public:
    SampleAgreement(ValuePair values) : found_(std::move(values)) {} // NOLINT: converts on purpose
    SampleAgreement(NoValue no_value) : found_(std::move(no_value)) {} // NOLINT
    SampleAgreement(OurLimit limit) : found_(std::move(limit)) {}      // NOLINT

    /// nullptr where there are none.
    [[nodiscard]] const ValuePair* values() const { return std::get_if<ValuePair>(&found_); }
    [[nodiscard]] const NoValue* no_value() const { return std::get_if<NoValue>(&found_); }
    [[nodiscard]] const OurLimit* limit() const { return std::get_if<OurLimit>(&found_); }
    /// To which they agree; far below zero where there are no values.
    [[nodiscard]] double digits() const;
    /// Why there are no values; empty where there are.
    [[nodiscard]] std::string problem() const;

private:
    std::variant<ValuePair, NoValue, OurLimit> found_;
};

/// Two formulas at all samples.
struct Agreement {
    std::vector<SampleAgreement> samples_at;
    std::size_t worst = 0; ///< index of the sample with the fewest digits in common
    [[nodiscard]] double digits() const {
        return samples_at.empty() ? 0 : samples_at[worst].digits();
    }
    /// At every sample.
    [[nodiscard]] bool to(double digits) const;
    /// EvaluatedSamples where the printed formula has no value, and why at the first of them.
    [[nodiscard]] std::size_t without_value() const;
    /// At some sample we found no value.
    [[nodiscard]] bool limited() const;
    /// Which samples decide.
    [[nodiscard]] SampleUse use(double digits_needed) const;
    /// For a reader: what keeps the formula from a verdict by its values.
    [[nodiscard]] std::string obstacle(double digits_needed) const;
};

/// All samples of a claim at so many digits, those that its `where` admits; or `most` of them,
/// spread evenly over all, or for screening those farthest from an edge. It keeps the values of
/// what it was compared with, and of integrals; one object belongs to one thread.
class EvaluatedSamples {
public:
    /// Of a claim, or of another that is sampled alike: made once a run and thread.
    [[nodiscard]] static std::shared_ptr<EvaluatedSamples> of(const Claim& claim,
                                                              const AuditContext& context,
                                                              unsigned digits, std::size_t most = 0,
                                                              Effort effort = Effort::full);
    EvaluatedSamples(const Claim& claim, const AuditContext& context, unsigned digits,
                     std::size_t most = 0, Effort effort = Effort::full);

    [[nodiscard]] const std::vector<EvaluatedSample>& all() const noexcept { return samples_at_; }
    /// Samples that `where` leaves out.
    [[nodiscard]] std::size_t left_out() const noexcept { return left_out_; }
    [[nodiscard]] std::size_t scenes() const noexcept { return scene_values_.size(); }
    /// `scale`: what a difference is held against where the exact value is zero.
    /// Throws Interrupted.
    [[nodiscard]] Agreement compare(const formula::Expr& printed, const formula::Expr& exact,
                                    const std::optional<formula::Expr>& scale = std::nullopt);
    /// The value of a formula that many others are compared with, at a sample.
    [[nodiscard]] FormulaValue known(const formula::Expr& e, std::size_t sample_at);
    /// A sample in balls.
    [[nodiscard]] const EnclosedSample& enclosed(std::size_t sample_at, long bits,
                                                 unsigned integral_digits) const;
    /// The value of a formula at a sample.
    [[nodiscard]] FormulaValue value(const formula::Expr& e, std::size_t sample_at) {
        return samples_at_[sample_at].evaluate(e, &caches_[sample_at]);
    }

private:
    [[nodiscard]] SampleAgreement compare_at(std::size_t i, const formula::Expr& printed,
                                             const formula::Expr& exact,
                                             const std::optional<formula::Expr>& scale);
    std::vector<std::unique_ptr<EvaluatedScene>> scene_values_;
    std::vector<EvaluatedSample> samples_at_;
    std::vector<IntegralCache> caches_;
    mutable std::map<std::tuple<std::size_t, long, unsigned>, EnclosedSample> enclosed_;
    std::size_t left_out_ = 0;
    unsigned digits_;
    const AuditContext& context_;
};

/// "17.3": digits in evidence, capped at what is worth saying.
[[nodiscard]] std::string digits_text(double digits);
/// A value rounded for evidence.
[[nodiscard]] std::string value_text(const Real& value, unsigned digits);

} // namespace edgeproof::audit

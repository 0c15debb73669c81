// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/check.hpp"
#include "edgeproof/audit/judgement.hpp"
#include "edgeproof/audit/setting.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace edgeproof {

/// One sample of a claim in numbers.
struct Spot {
    const Setting* setting;
    std::optional<Place> place;
    Variables variables;
    std::string text;
    Sample sample; ///< what it was made from: exact

    [[nodiscard]] FormulaValue evaluate(const Expr& e, IntegralCache* cache = nullptr) const {
        return setting->evaluate(e, place ? &*place : nullptr, variables, cache);
    }
};

/// The values of two formulas at one spot: finite, and every integral in them converged.
struct ValuePair {
    Real printed;
    Real exact;
    double digits = 0; ///< to which they agree
    Real error;        ///< an estimate of what their difference may be off by, with a margin
};

/// Two formulas at one spot: both values, or that the printed one has none, or that we found none.
class SpotAgreement {
public:
    SpotAgreement(ValuePair values) : found_(std::move(values)) {}   // NOLINT: converts on purpose
    SpotAgreement(NoValue no_value) : found_(std::move(no_value)) {} // NOLINT
    SpotAgreement(OurLimit limit) : found_(std::move(limit)) {}      // NOLINT

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

/// Two formulas at all spots.
struct Agreement {
    std::vector<SpotAgreement> spots;
    std::size_t worst = 0; ///< index of the spot with the fewest digits in common
    [[nodiscard]] double digits() const { return spots.empty() ? 0 : spots[worst].digits(); }
    /// At every spot.
    [[nodiscard]] bool to(double digits) const;
    /// At some spot they differ by more than their errors allow for.
    [[nodiscard]] std::optional<Difference> difference(double digits_needed) const;
    /// Spots where the printed formula has no value, and why at the first of them.
    [[nodiscard]] std::size_t without_value() const;
    /// For a reader: what keeps the formula from a verdict by its values.
    [[nodiscard]] std::string obstacle(double digits_needed) const;
};

/// All samples of a claim at so many digits, those that its `where` admits; or `most` of them,
/// spread evenly over all, or for screening those farthest from an edge. It keeps the values of
/// what it was compared with, and of integrals; one object belongs to one thread.
class Spots {
public:
    /// Of a claim, or of another that is sampled alike: made once a run and thread.
    [[nodiscard]] static std::shared_ptr<Spots> of(const Claim& claim, const AuditContext& context,
                                                   unsigned digits, std::size_t most = 0,
                                                   Effort effort = Effort::full);
    Spots(const Claim& claim, const AuditContext& context, unsigned digits, std::size_t most = 0,
          Effort effort = Effort::full);

    [[nodiscard]] const std::vector<Spot>& all() const noexcept { return spots_; }
    /// Samples that `where` leaves out.
    [[nodiscard]] std::size_t left_out() const noexcept { return left_out_; }
    [[nodiscard]] std::size_t scenes() const noexcept { return settings_.size(); }
    /// `scale`: what a difference is held against where the exact value is zero.
    /// Throws Interrupted.
    [[nodiscard]] Agreement compare(const Expr& printed, const Expr& exact,
                                    const std::optional<Expr>& scale = std::nullopt);
    /// The value of a formula that many others are compared with, at a spot.
    [[nodiscard]] FormulaValue known(const Expr& e, std::size_t spot);
    /// The value of a formula at a spot.
    [[nodiscard]] FormulaValue value(const Expr& e, std::size_t spot) {
        return spots_[spot].evaluate(e, &caches_[spot]);
    }

private:
    [[nodiscard]] SpotAgreement compare_at(std::size_t i, const Expr& printed, const Expr& exact,
                                           const std::optional<Expr>& scale);
    std::vector<std::unique_ptr<Setting>> settings_;
    std::vector<Spot> spots_;
    std::vector<IntegralCache> caches_;
    std::size_t left_out_ = 0;
    unsigned digits_;
    const AuditContext& context_;
};

/// "17.3": digits in evidence, capped at what is worth saying.
[[nodiscard]] std::string digits_text(double digits);
/// A value rounded for evidence.
[[nodiscard]] std::string value_text(const Real& value, unsigned digits);

} // namespace edgeproof

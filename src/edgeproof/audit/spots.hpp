// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/check.hpp"
#include "edgeproof/audit/setting.hpp"

#include <memory>
#include <optional>
#include <string>
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

/// Why a formula has no value, as far as that can be told from the numbers.
enum class Undefined {
    unknown,        ///< for none of the reasons below
    by_roundoff,    ///< the number there is negative by no more than roundoff: it may be zero
    beyond_roundoff ///< negative by more
};

/// Two formulas at one spot.
struct SpotAgreement {
    Real printed;
    Real exact;
    double digits = 0;      ///< to which they agree
    double good_digits = 0; ///< to which both are good
    std::string problem;    ///< why there is no value, if there is none
    bool undefined = false; ///< the exact formula has a value here, the printed one has none
    Undefined why = Undefined::unknown;
};

/// Two formulas at all spots.
struct Agreement {
    std::vector<SpotAgreement> spots;
    std::size_t worst = 0; ///< index of the spot with the fewest digits in common
    [[nodiscard]] double digits() const { return spots.empty() ? 0 : spots[worst].digits; }
    /// At every spot.
    [[nodiscard]] bool to(double digits) const;
    /// The printed formula has no value at some spot where the exact one has, by more than
    /// roundoff; or for reasons that are not roundoff's and nowhere, not even by an integral that
    /// did not settle, one that is anything like it.
    [[nodiscard]] bool undefined() const;
    /// At some spot they differ by more than their errors allow for.
    [[nodiscard]] bool differ(double digits_needed) const;
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

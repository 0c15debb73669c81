// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::audit {

/// Numbers in place of the decimals of a printed formula, in balls.
using Decimals = std::vector<Ball>;

/// One comparison that a printed formula with decimals must pass.
struct DecimalEquation {
    /// Returns the printed value for these decimals. Throws Error if it has no enclosure.
    std::function<Ball(const Decimals&)> printed;
    Ball exact;
    Ball scale; ///< positive; differences are compared with it
};

/// Decimals for which the printed formula agrees with the exact values.
struct FittedDecimals {
    std::vector<Real> numbers;
    Confirmation agrees;
};

/// Finds numbers that can replace the decimals of a printed formula. Every decimal represents the
/// interval of half a unit in its last place.
class DecimalFit {
public:
    /// `digits`: the digits to which the formula must agree with the exact values.
    DecimalFit(std::vector<PrintedDecimal> decimals, std::vector<DecimalEquation> equations,
               unsigned digits, long bits);

    /// Finds numbers, at most `units` units of the last place from the printed ones (without a
    /// limit: any numbers), for which all equations are proved to hold. They are searched by the
    /// Levenberg-Marquardt iteration in Real; only the enclosures at its result decide. Returns
    /// nothing if no such numbers are found.
    [[nodiscard]] std::optional<FittedDecimals> find(const std::optional<Rational>& units) const;
    /// Proves that no numbers at most half a unit away satisfy all equations: the enclosure of one
    /// equation over all of them excludes its exact value, or each part of a subdivision is
    /// excluded by an equation.
    [[nodiscard]] std::optional<Refutation> exclude() const;

private:
    [[nodiscard]] std::optional<std::vector<Real>>
    search(const std::optional<Rational>& units,
           const std::vector<std::optional<Real>>& fixed) const;
    [[nodiscard]] std::optional<Confirmation> agrees(const std::vector<Real>& numbers) const;
    [[nodiscard]] std::optional<std::vector<Real>>
    residuals(const std::vector<Real>& numbers) const;
    /// A proof that one equation excludes all numbers in the box.
    [[nodiscard]] std::optional<Refutation> excluded(const Decimals& box, std::size_t& first) const;

    std::vector<PrintedDecimal> decimals_;
    std::vector<DecimalEquation> equations_;
    unsigned digits_;
    long bits_;
};

/// Judges a formula with decimals: confirmed if numbers that round to all of them fit; refuted if
/// it is proved that no such numbers fit; imprecise if numbers at most one and a half units away
/// fit. `text_with` writes the formula with other numbers. Adds `rounded` to the evidence.
[[nodiscard]] Judgement
judge_decimals(const std::vector<PrintedDecimal>& decimals, const DecimalFit& fit,
               const std::function<std::string(const std::vector<Real>&)>& text_with,
               std::size_t comparisons, unsigned digits, Outcome& outcome);

} // namespace edgeproof::audit

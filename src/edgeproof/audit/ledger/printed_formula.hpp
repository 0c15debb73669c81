// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// The greatest distance, in units of the last place, of a number that rounds to the printed one.
[[nodiscard]] inline Rational rounding_units() { return {1, 2}; }
/// The same for a number that rounds to the printed one or to its neighbour.
[[nodiscard]] inline Rational neighbour_units() { return {3, 2}; }

/// A decimal printed in a formula: "0.418". It represents every number that rounds to it:
/// value - unit/2 ... value + unit/2.
struct PrintedDecimal {
    std::string text;
    std::size_t offset = 0; ///< in the text
    Rational value;
    Rational unit; ///< one unit of its last place

    /// Returns the interval value +- `units` units of the last place.
    [[nodiscard]] Ball interval(const Rational& units, long bits) const;
    /// The number of digits of the printed number, without its leading zeros.
    [[nodiscard]] std::size_t significant_digits() const;
    /// Returns another number in the same notation, rounded to the printed place.
    [[nodiscard]] std::string in_its_place(const Real& number) const;
};

/// Returns the name that stands for the decimal of this index in PrintedFormula::named.
[[nodiscard]] std::string name_of_decimal(std::size_t k);

/// Returns a formula, which was read from `text`, with a name in place of each number with a
/// decimal point (except zero), and adds these numbers to `decimals`, in the order of the text.
[[nodiscard]] Expr with_names(Expr e, std::string_view text, std::vector<PrintedDecimal>& decimals);

/// A printed formula as a function of its decimals. A comparison with the decimals taken as exact
/// may find where to look and may confirm the formula, but cannot refute it.
struct PrintedFormula {
    std::string text;
    Expr as_printed; ///< with definitions put in
    Expr named;      ///< the same with a name for each decimal
    std::vector<PrintedDecimal> decimals;

    [[nodiscard]] bool is_exact() const { return decimals.empty(); }
    /// Returns the printed text with other numbers for the decimals, rounded to the printed places.
    [[nodiscard]] std::string text_with(const std::vector<Real>& numbers) const;
};
/// Returns `says` of a claim. With `decimals = "exact"` all its numbers are exact.
[[nodiscard]] PrintedFormula printed_formula(const Claim& claim);

/// The same for a condition.
struct PrintedCondition {
    Condition as_printed;
    Condition named;
    std::vector<PrintedDecimal> decimals;
};
[[nodiscard]] PrintedCondition printed_condition(const Claim& claim);

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <string>
#include <string_view>
#include <variant>
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
    std::size_t offset = 0; ///< in the formula's text
    Rational value;
    Rational unit; ///< one unit of its last place

    /// Returns the interval value +- `units` units of the last place.
    [[nodiscard]] Ball interval(const Rational& units, long bits) const;
    /// The number of digits of the printed number, without its leading zeros.
    [[nodiscard]] std::size_t significant_digits() const;
    /// Returns another number in the same notation, rounded to the printed place.
    [[nodiscard]] std::string in_its_place(const Real& number) const;
};

/// Returns the numbers with a decimal point, in the order of the text: "0.418*sqrt(2*x)" has one.
[[nodiscard]] std::vector<PrintedDecimal> printed_decimals(std::string_view formula);

/// A printed formula in which every number is exact.
class ExactFormula {
public:
    [[nodiscard]] const Expr& expr() const { return expr_; }
    /// Makes one from a formula of the program, such as a correction, with definitions put in.
    [[nodiscard]] static ExactFormula made(Expr e) { return ExactFormula(std::move(e)); }

private:
    friend class DecimalFormula;
    explicit ExactFormula(Expr e) : expr_(std::move(e)) {}
    Expr expr_;
};

/// A printed formula with decimals, as a function of them. It cannot be converted to an
/// ExactFormula: a comparison with the decimals taken as exact may find where to look and may
/// confirm the formula, but cannot refute it.
class DecimalFormula {
public:
    /// Returns the formula with definitions put in and with a name for each decimal.
    [[nodiscard]] const Expr& expr() const { return expr_; }
    /// Returns the same formula with the printed decimals.
    [[nodiscard]] const Expr& as_printed() const { return as_printed_; }
    [[nodiscard]] const std::vector<PrintedDecimal>& decimals() const { return decimals_; }
    [[nodiscard]] static std::string name_of_decimal(std::size_t k);
    /// Returns the printed text with other numbers for the decimals, rounded to the printed places.
    [[nodiscard]] std::string text_with(const std::vector<Real>& numbers) const;

    /// Reads a text of a claim in the claim's vocabulary.
    [[nodiscard]] static std::variant<ExactFormula, DecimalFormula> read(const Claim& claim,
                                                                         const std::string& text);

private:
    DecimalFormula() = default;
    std::string text_;
    Expr expr_;
    Expr as_printed_;
    std::vector<PrintedDecimal> decimals_;
};

using PrintedFormula = std::variant<ExactFormula, DecimalFormula>;

/// Returns the printed formula of a field. With `decimals = "exact"` all numbers are exact.
[[nodiscard]] PrintedFormula printed_formula(const Claim& claim, std::string_view key = "says");

/// A printed condition and its decimals, which represent intervals.
struct PrintedCondition {
    Condition as_printed;
    Condition named; ///< with a name for each decimal (DecimalFormula::name_of_decimal)
    std::vector<PrintedDecimal> decimals;
};
[[nodiscard]] PrintedCondition printed_condition(const Claim& claim, std::string_view key = "says");

} // namespace edgeproof::audit

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

/// Units of the last place: a number rounds to a printed one if it is at most so many away ...
[[nodiscard]] inline Rational rounding_units() { return {1, 2}; }
/// ... and to a neighbour of the printed one if it is at most so many away.
[[nodiscard]] inline Rational neighbour_units() { return {3, 2}; }

/// A decimal as it is printed in a formula: "0.418". It stands for every number that is rounded to
/// it: value - unit/2 ... value + unit/2.
struct PrintedDecimal {
    std::string text;
    std::size_t offset = 0; ///< in the formula's text
    Rational value;
    Rational unit; ///< of its last place

    /// All numbers that are at most so many units of the last place away.
    [[nodiscard]] Ball interval(const Rational& units, long bits) const;
    /// The number of digits of the printed number, without its leading zeros.
    [[nodiscard]] std::size_t significant_digits() const;
    /// Another number in the same notation, rounded to the printed place.
    [[nodiscard]] std::string in_its_place(const Real& number) const;
};

/// The numbers with a decimal point, in the order in which they stand: "0.418*sqrt(2*x)" has one.
[[nodiscard]] std::vector<PrintedDecimal> printed_decimals(std::string_view formula);

/// A printed formula every number of which stands for itself.
class ExactFormula {
public:
    [[nodiscard]] const formula::Expr& expr() const { return expr_; }
    /// A formula that the program made, such as a correction, with definitions put in.
    [[nodiscard]] static ExactFormula made(formula::Expr e) { return ExactFormula(std::move(e)); }

private:
    friend class DecimalFormula;
    explicit ExactFormula(formula::Expr e) : expr_(std::move(e)) {}
    formula::Expr expr_;
};

/// A printed formula with decimals, as a function of them. There is no way from here to an
/// ExactFormula: a comparison with the decimals taken exactly may find where to look, and may
/// confirm the formula, but it cannot refute it.
class DecimalFormula {
public:
    /// The formula with definitions put in, and with a name for each decimal.
    [[nodiscard]] const formula::Expr& expr() const { return expr_; }
    /// The same with the printed decimals.
    [[nodiscard]] const formula::Expr& as_printed() const { return as_printed_; }
    [[nodiscard]] const std::vector<PrintedDecimal>& decimals() const { return decimals_; }
    [[nodiscard]] static std::string name_of_decimal(std::size_t k);
    /// The printed text, with other numbers for the decimals, rounded to the printed places.
    [[nodiscard]] std::string text_with(const std::vector<Real>& numbers) const;

    /// Of a text of a claim, in the claim's vocabulary.
    [[nodiscard]] static std::variant<ExactFormula, DecimalFormula> read(const Claim& claim,
                                                                         const std::string& text);

private:
    DecimalFormula() = default;
    std::string text_;
    formula::Expr expr_;
    formula::Expr as_printed_;
    std::vector<PrintedDecimal> decimals_;
};

using PrintedFormula = std::variant<ExactFormula, DecimalFormula>;

/// What a field of a claim prints. All numbers are exact in a claim with `decimals = "exact"`.
[[nodiscard]] PrintedFormula printed_formula(const Claim& claim, std::string_view key = "says");

/// A printed condition, with the decimals in it, which stand for intervals.
struct PrintedCondition {
    Condition as_printed;
    Condition named; ///< with a name for each decimal (DecimalFormula::name_of_decimal)
    std::vector<PrintedDecimal> decimals;
};
[[nodiscard]] PrintedCondition printed_condition(const Claim& claim, std::string_view key = "says");

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <string>
#include <utility>

namespace edgeproof::audit {

/// Decides if a number is in the interval lower <= x < upper.
[[nodiscard]] Decision decide_within(const Ball& x, const std::pair<Rational, Rational>& interval);

/// A figure as it is quoted: "6.4 %", "0.03", "17". Its unit is one unit of the last place.
class QuotedFigure {
public:
    /// Reads the field `quoted` of a claim. Throws InputError for anything except a decimal, with
    /// or without a per cent sign.
    [[nodiscard]] static QuotedFigure of(const Claim& claim);

    /// The value as a pure number: 2 % is 1/50.
    [[nodiscard]] const Rational& value() const noexcept { return value_; }
    /// True if the computed value lies half-way between two numbers with the quoted places, up to
    /// the error of the working digits.
    [[nodiscard]] bool half_way(const Real& computed) const;
    /// Rounds the computed value to the quoted place and returns the difference from the quoted
    /// figure, in units of that place. A half is rounded up.
    [[nodiscard]] long units_off(const Real& computed) const;
    /// Confirmed if all numbers in the ball round to the figure, imprecise if all are one unit off,
    /// refuted if all are farther off, else undecided.
    [[nodiscard]] Judgement verdict(const Ball& computed) const;
    /// Judges a constant that is proved by exact algebra to lie half-way between two numbers with
    /// the quoted places; undecided for other constants.
    [[nodiscard]] Judgement verdict_half_way(const Exact& computed) const;
    /// The number of decimal digits of the figure, counted from the first nonzero digit.
    [[nodiscard]] unsigned digits() const;
    /// Returns the interval value -+ `units` units of the last quoted place; for 1/2, the numbers
    /// that round to the figure.
    [[nodiscard]] std::pair<Rational, Rational> within_units(const Rational& units) const {
        return {value_ - units * unit_, value_ + units * unit_};
    }
    /// Returns the computed value in the quoted notation, rounded to the quoted place.
    [[nodiscard]] std::string rounded(const Real& computed) const;
    /// Returns the computed value in the quoted notation with `digits` significant digits.
    [[nodiscard]] std::string text(const Real& computed, unsigned digits = 5) const;
    /// Returns a note such as "rounds to 49 %: 3 units of the last quoted place above".
    [[nodiscard]] std::string note(const Real& computed) const;

private:
    Rational value_;
    Rational unit_;
    unsigned decimals_ = 0;
    bool percent_ = false;
};

} // namespace edgeproof::audit

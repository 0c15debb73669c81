// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/real.hpp"

#include <string>
#include <utility>

namespace edgeproof::audit {

/// A figure as it is quoted: "6.4 %", "0.03", "17". The last place written is its unit.
class QuotedFigure {
public:
    /// The field `quoted` of a claim. Throws InputError for anything but a decimal, with or without
    /// a sign of per cent.
    [[nodiscard]] static QuotedFigure of(const Claim& claim);

    /// As a pure number: 2 % is 1/50.
    [[nodiscard]] const Rational& value() const noexcept { return value_; }
    /// Whether the computed value lies half-way between two numbers of so many places, as far as
    /// the working digits tell.
    [[nodiscard]] bool half_way(const Real& computed) const;
    /// How many units of the last quoted place the computed value, rounded to it, is above. A half
    /// is rounded up.
    [[nodiscard]] long units_off(const Real& computed) const;
    /// All numbers in the ball round to it: confirmed. All are one unit off: imprecise. All are
    /// farther off: refuted. Else undecided.
    [[nodiscard]] Judgement verdict(const Ball& computed) const;
    /// The same of a constant that exact algebra proves to lie half-way between two numbers of so
    /// many places; undecided for others.
    [[nodiscard]] Judgement verdict_half_way(const formula::Exact& computed) const;
    /// Decimal digits of the figure, counted from the first one that is not zero.
    [[nodiscard]] unsigned digits() const;
    /// The numbers from so many units of the last quoted place below to so many above: with 1/2
    /// those that round to it.
    [[nodiscard]] std::pair<Rational, Rational> within_units(const Rational& units) const {
        return {value_ - units * unit_, value_ + units * unit_};
    }
    /// The computed value in the quoted notation: rounded to the quoted place.
    [[nodiscard]] std::string rounded(const Real& computed) const;
    /// The same with so many significant digits.
    [[nodiscard]] std::string text(const Real& computed, unsigned digits = 5) const;
    /// "rounds to 49 %: 3 units of the last quoted place above".
    [[nodiscard]] std::string note(const Real& computed) const;

private:
    Rational value_;
    Rational unit_;
    unsigned decimals_ = 0;
    bool percent_ = false;
};

} // namespace edgeproof::audit

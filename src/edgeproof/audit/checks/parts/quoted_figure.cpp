// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/quoted_figure.hpp"

#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/precision/arithmetic.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <cstdlib>

namespace edgeproof::audit {
namespace {

/// Computed figures are assumed to be right to all working digits except these last ones.
constexpr int lost_digits = 25;

} // namespace

Decision decide_within(const Ball& x, const std::pair<Rational, Rational>& interval) {
    const auto& [lower, upper] = interval;
    const auto below = Refutation::less(x, Ball(lower, x.bits()));
    return decision(below ? below : Refutation::less(Ball(upper, x.bits()), x),
                    Confirmation::within(x, lower, upper));
}

QuotedFigure QuotedFigure::of(const Claim& claim) {
    std::string number = claim.text("quoted");
    QuotedFigure figure;
    if (number.ends_with('%')) {
        figure.percent_ = true;
        number.pop_back();
        while (number.ends_with(' ')) {
            number.pop_back();
        }
    }
    const auto plain = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
    if (number.empty() || !std::ranges::all_of(number, plain)) {
        claim.reject("quoted", "the figure '" + claim.text("quoted") + "' is not a decimal number",
                     "write it as quoted, such as \"6.4 %\" or \"0.03\"");
    }
    try {
        figure.value_ = parse_decimal(number);
    } catch (const InputError& error) {
        claim.reject("quoted", error.problem(), error.instead());
    }
    const std::size_t point = number.find('.');
    if (point != std::string::npos) {
        figure.decimals_ = static_cast<unsigned>(number.size() - point - 1);
    }
    figure.unit_ =
        Rational(Integer(1), Integer(boost::multiprecision::pow(Integer(10), figure.decimals_)));
    if (figure.percent_) {
        figure.value_ /= 100;
        figure.unit_ /= 100;
    }
    return figure;
}

bool QuotedFigure::half_way(const Real& computed) const {
    const Real steps = computed / Real(unit_);
    const Real from_half = abs(Real(steps - floor(steps) - Real(1) / 2));
    return from_half <=
           (abs(steps) + 1) * pow(Real(10), lost_digits - static_cast<int>(working_digits()));
}

long QuotedFigure::units_off(const Real& computed) const {
    const Real steps = computed / Real(unit_);
    const Real quoted(Rational(value_ / unit_));
    // A half is rounded up, even if roundoff has moved the value slightly to either side of it.
    const Real rounded =
        half_way(computed) ? Real(floor(steps) + 1) : Real(floor(Real(steps + Real(1) / 2)));
    const Real off = rounded - quoted;
    constexpr long most = 1000000000;
    return abs(off) > most ? (off > 0 ? most : -most) : off.convert_to<long>();
}

Judgement QuotedFigure::verdict(const Ball& computed) const {
    const Decision rounds = decide_within(computed, within_units(rounding_units()));
    const Decision near = decide_within(computed, within_units(neighbour_units()));
    if (confirms(rounds) || !confirms(near)) {
        return Judgement(confirms(rounds) ? rounds : near);
    }
    return refutes(rounds) ? Judgement::imprecise(std::get<Confirmation>(near)) : Judgement();
}

Judgement QuotedFigure::verdict_half_way(const Exact& computed) const {
    const PrecisionScope scope(digits() + 40);
    const Rational steps = Rational(
        floor(Real(computed.to<Real>() / from_rational<Real>(unit_))).convert_to<Integer>());
    for (const int offset : {-1, 0, 1}) {
        const Rational middle = (steps + offset + rounding_units()) * unit_;
        if (algebra::proved_zero(computed.expr() - Expr::number(middle))) {
            return verdict(Ball(Rational(middle + rounding_units() * unit_), 64 + 4 * digits()));
        }
    }
    return {};
}

unsigned QuotedFigure::digits() const {
    Rational steps = abs(Rational(value_ / unit_));
    unsigned count = 1;
    for (; steps >= 10; steps /= 10) {
        ++count;
    }
    return count;
}

std::string QuotedFigure::rounded(const Real& computed) const {
    Real shown = percent_ ? Real(computed * 100) : computed;
    if (half_way(computed)) {
        shown = (floor(Real(computed / Real(unit_))) + 1) * Real(unit_) * (percent_ ? 100 : 1);
    }
    return shown.str(decimals_, std::ios_base::fixed) + (percent_ ? " %" : "");
}

std::string QuotedFigure::text(const Real& computed, unsigned digits) const {
    return to_decimal(percent_ ? Real(computed * 100) : computed, digits) + (percent_ ? " %" : "");
}

std::string QuotedFigure::note(const Real& computed) const {
    const long off = units_off(computed);
    const std::string between =
        half_way(computed) ? " (half-way between two, to the digits computed: rounded up)" : "";
    if (off == 0) {
        return "rounds to it" + between;
    }
    const long size = std::labs(off);
    return "rounds to " + rounded(computed) + ": " + std::to_string(size) +
           (size == 1 ? " unit" : " units") + " of the last quoted place " +
           (off > 0 ? "above" : "below") + between;
}

} // namespace edgeproof::audit

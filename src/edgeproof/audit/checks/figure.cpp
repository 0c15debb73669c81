// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/audit/checks/kinds.hpp"
#include "edgeproof/audit/enclosure/sample_in_balls.hpp"
#include "edgeproof/audit/ledger/printed_formula.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace edgeproof::audit {
namespace {

/// Computed figures are assumed to be right to all working digits except these last ones.
constexpr int lost_digits = 25;

/// A figure as it is quoted: "6.4 %", "-0.03", "1.7e3". Its unit is one unit of the last place.
class QuotedFigure {
public:
    /// Reads a figure of the field `quoted`: a decimal, with or without a per cent sign.
    QuotedFigure(const Claim& claim, std::string number) : written_(number) {
        if (number.ends_with('%')) {
            per_unit_ = 100;
            number.pop_back();
            while (number.ends_with(' ')) {
                number.pop_back();
            }
        }
        if (number.empty() || number.find_first_not_of("0123456789.+-eE") != std::string::npos) {
            claim.reject("quoted", "the figure '" + written_ + "' is not a decimal number",
                         "write it as quoted, such as \"6.4 %\" or \"0.03\"");
        }
        try {
            value_ = parse_decimal(number) / per_unit_;
        } catch (const InputError& error) {
            claim.reject("quoted", error.problem(), error.instead());
        }
        const std::size_t power = std::min(number.find_first_of("eE"), number.size());
        const std::size_t point = std::min(number.find('.') + 1, power);
        decimals_ = (point == 0 ? 0 : static_cast<long>(power - point)) -
                    (power == number.size() ? 0 : std::stol(number.substr(power + 1)));
        unit_ = parse_decimal("1e" + std::to_string(-decimals_)) / per_unit_;
    }

    /// As it is quoted.
    [[nodiscard]] const std::string& written() const { return written_; }
    /// Rounds the computed value to the quoted place and returns the difference from the quoted
    /// figure, in units of that place. A half is rounded away from zero.
    [[nodiscard]] long units_off(const Real& computed) const {
        const Real off = nearest_steps(computed) - Real(Rational(value_ / unit_));
        return abs(off) > most_units ? (off > 0 ? most_units : -most_units)
                                     : off.convert_to<long>();
    }
    /// Confirmed if all numbers in the ball round to the figure, imprecise if all are one unit off,
    /// refuted if all are farther off, else undecided.
    [[nodiscard]] Judgement verdict(const Ball& computed) const {
        const Decision rounds = within(computed, rounding_units());
        const Decision near = within(computed, neighbour_units());
        if (confirms(rounds) || !confirms(near)) {
            return Judgement(confirms(rounds) ? rounds : near);
        }
        return refutes(rounds) ? Judgement::imprecise(std::get<Confirmation>(near)) : Judgement();
    }
    /// Judges a constant that is proved by exact algebra to lie half-way between two numbers with
    /// the quoted places; undecided for other constants.
    [[nodiscard]] Judgement verdict_half_way(const Exact& computed) const {
        const PrecisionScope scope(digits() + 40);
        const auto steps = floor(steps_of(computed.to<Real>())).convert_to<Integer>();
        for (const int offset : {-1, 0, 1}) {
            const Rational middle = (Rational(steps + offset) + rounding_units()) * unit_;
            if (algebra::proved_zero(computed.expr() - Expr::number(middle))) {
                const Rational away = middle + (middle < 0 ? -1 : 1) * rounding_units() * unit_;
                return verdict(Ball(away, 64 + 4 * digits()));
            }
        }
        return {};
    }
    /// The number of decimal digits of the figure, counted from the first nonzero digit.
    [[nodiscard]] unsigned digits() const {
        unsigned count = 1;
        for (Rational steps = abs(Rational(value_ / unit_)); steps >= 10; steps /= 10) {
            ++count;
        }
        return count;
    }
    /// Returns the computed value in the quoted notation, rounded to the quoted place.
    [[nodiscard]] std::string rounded(const Real& computed) const {
        return Real(nearest_steps(computed) * Real(Rational(unit_ * per_unit_)))
                   .str(std::max(decimals_, 0L), std::ios_base::fixed) +
               sign();
    }
    /// Returns the computed value in the quoted notation with `digits` significant digits.
    [[nodiscard]] std::string text(const Real& computed, unsigned digits = 5) const {
        return to_decimal(Real(computed * per_unit_), digits) + sign();
    }
    /// Returns a note such as "rounds to 49 %: 3 units of the last quoted place above".
    [[nodiscard]] std::string note(const Real& computed) const {
        const long off = units_off(computed);
        const std::string between =
            half_way(computed)
                ? " (half-way between two, to the digits computed: rounded away from zero)"
                : "";
        if (off == 0) {
            return "rounds to it" + between;
        }
        const long size = std::labs(off);
        return "rounds to " + rounded(computed) + ": " + (size == most_units ? "at least " : "") +
               std::to_string(size) + (size == 1 ? " unit" : " units") +
               " of the last quoted place " + (off > 0 ? "above" : "below") + between;
    }

private:
    static constexpr long most_units = 1000000000;

    [[nodiscard]] std::string sign() const { return per_unit_ == 100 ? " %" : ""; }
    [[nodiscard]] Real steps_of(const Real& computed) const {
        return computed / from_rational<Real>(unit_);
    }
    /// True if the computed value lies half-way between two numbers with the quoted places, up to
    /// the error of the working digits.
    [[nodiscard]] bool half_way(const Real& computed) const {
        const Real steps = steps_of(computed);
        const Real from_half = abs(Real(steps - floor(steps) - Real(1) / 2));
        return from_half <=
               (abs(steps) + 1) * pow(Real(10), lost_digits - static_cast<int>(working_digits()));
    }
    /// The whole number of units nearest to the computed value. A half is rounded away from zero,
    /// even if roundoff has moved the value slightly to either side of it.
    [[nodiscard]] Real nearest_steps(const Real& computed) const {
        const Real steps = steps_of(computed);
        const Real up = floor(steps) + 1;
        return !half_way(computed) ? Real(floor(Real(steps + Real(1) / 2)))
               : computed < 0      ? Real(up - 1)
                                   : up;
    }
    /// Decides if a number is within `units` units of the last quoted place of the figure.
    [[nodiscard]] Decision within(const Ball& x, const Rational& units) const {
        const Ball size = value_ < 0 ? -x : x; // a half belongs to the figure farther from zero
        const Rational lower = abs(value_) - units * unit_;
        const Rational upper = abs(value_) + units * unit_;
        const auto below = Refutation::less(size, Ball(lower, x.bits()));
        return decision(below ? below : Refutation::less(Ball(upper, x.bits()), size),
                        Confirmation::within(size, lower, upper));
    }

    std::string written_;
    Rational value_;
    Rational unit_;
    long decimals_ = 0; ///< negative for 17e3
    int per_unit_ = 1;  ///< 100 for a figure in per cent
};

/// Returns the rank of a verdict on a figure, from good to bad.
int badness(Verdict v) {
    return v == Verdict::confirmed   ? 0
           : v == Verdict::imprecise ? 1
           : v == Verdict::refuted   ? 3
                                     : 2;
}

struct FigureAt {
    Judgement verdict;
    std::optional<Ball> value;
    std::string problem;

    [[nodiscard]] std::string note(const QuotedFigure& figure) const {
        return verdict == Verdict::undecided ? "the enclosure does not decide how it is rounded"
                                             : figure.note(value->midpoint());
    }
    [[nodiscard]] Evidence evidence(const QuotedFigure& figure, const std::string& at,
                                    unsigned digits) const {
        const Real& middle = value->midpoint();
        return {{"at", at},
                {"value", value_text(middle, digits)},
                {"rounds_to", figure.rounded(middle)},
                {"units_off", figure.units_off(middle)},
                {"enclosure", ball_text(*value, digits)}};
    }
};

/// Uses an exact number, or an enclosure with enough bits to round it and to show `digits`.
FigureAt figure_at(const Sample& sample, const Expr& of, const QuotedFigure& figure,
                   unsigned digits) {
    FigureAt found;
    SampleInBalls in_balls(sample, digits);
    const bool decided = in_balls.until([&](const EnclosedSample& at) {
        const Ball x = at.evaluate(of);
        if (!x.is_finite()) {
            return false;
        }
        found.value = x;
        found.verdict = figure.verdict(x);
        return found.verdict != Verdict::undecided &&
               x.relative_accuracy_bits() >= formula::bits_for(digits);
    });
    if (found.verdict == Verdict::undecided) {
        if (const auto exact = exact_value(of, sample)) {
            found.verdict = figure.verdict_half_way(*exact);
        }
    }
    if (!decided) {
        found.problem = in_balls.problem();
    }
    return found;
}

} // namespace

/// The verdict is that of the worst sample, or of the worst row of a table, whose note names the
/// rows that do not hold.
Outcome compare_figure(const Claim& claim, const AuditContext& context) {
    std::vector<std::string> texts;
    boost::algorithm::split(texts, claim.text("quoted"), [](char c) { return c == ','; });
    std::vector<QuotedFigure> figures;
    unsigned digits = context.digits();
    for (const std::string& text : texts) {
        figures.emplace_back(claim, boost::algorithm::trim_copy(text));
        digits = std::max(digits, figures.back().digits() + 10);
    }
    const PrecisionScope scope(digits + 20);
    const bool table = figures.size() > 1;
    if (table && claim.has("where")) {
        claim.reject("where", "a table of figures has no `where`", "leave rows out of the lists");
    }
    const std::vector<Sample> samples =
        table ? rows_of(claim, context, figures.size()) : ClaimSamples(claim, context).all();
    Outcome outcome;
    outcome.evidence.update({{"of", claim.text("of")}, {"samples", samples.size()}});
    if (samples.empty()) {
        outcome.note = "no sample fulfils the condition";
        return outcome;
    }
    std::vector<Real> values;
    std::vector<std::string> computed;
    std::string others;
    std::size_t good = 0;
    int worst = -1;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const QuotedFigure& figure = figures[table ? i : 0];
        const FigureAt found = figure_at(samples[i], claim.formula("of"), figure, digits);
        if (!found.value && !table) {
            outcome.verdict = {};
            outcome.note = found.problem + ", at " + full_text(samples[i]);
            return outcome;
        }
        Evidence row;
        if (found.value) {
            values.push_back(found.value->midpoint());
            row = found.evidence(figure, full_text(samples[i]), context.digits());
        }
        computed.push_back(found.value ? figure.text(values.back()) : "none");
        const std::string note = found.value ? found.note(figure) : "no value: " + found.problem;
        const bool worse = badness(found.verdict) > worst;
        if (worse) {
            worst = badness(found.verdict);
            outcome.verdict = found.verdict;
        }
        if (table) {
            row.update({{"quoted", figure.written()}, {"verdict", name_of(found.verdict)}});
            outcome.evidence["rows"].push_back(std::move(row));
        } else if (worse) {
            outcome.evidence.update(row);
            outcome.computed = computed.back();
            outcome.note = note;
        }
        good += holds(found.verdict) ? 1 : 0;
        others += holds(found.verdict)
                      ? ""
                      : "; row " + std::to_string(i + 1) + " (" + samples[i].text() +
                            "): " + figure.written() + " " + note;
    }
    if (table) {
        outcome.computed = boost::algorithm::join(computed, ", ");
        outcome.note = std::to_string(good) + " of " + std::to_string(samples.size()) +
                       " rows round to their figures" + others;
        return outcome;
    }
    const auto [least, most] = std::ranges::minmax(values);
    outcome.evidence["range"] =
        std::vector<std::string>{figures.front().text(least, 12), figures.front().text(most, 12)};
    return outcome;
}

} // namespace edgeproof::audit

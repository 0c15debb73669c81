// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/conformance/causes/readings.hpp"
#include "edgeproof/io/foreign_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace edgeproof::conformance {

std::vector<Convention> infer_precision_loss(const Answers& answers, const Agreements& agreements) {
    std::map<std::string, std::vector<std::size_t>> families; // wrong answers
    for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
        if (answers.given[i].state == Answer::State::number && !agreements.cases[i].pass &&
            agreements.cases[i].no_reference.empty()) {
            families[family_of(answers.questions.list[i])].push_back(i);
        }
    }
    std::vector<Convention> found;
    for (const auto& [family, rows] : families) {
        std::vector<diagnose::Written> numbers;
        for (const std::size_t i : rows) {
            const Real ours = agreements.references[i].value.value.midpoint();
            const Real error = Ball(answers.given[i].value, 256).midpoint() - ours;
            numbers.push_back({answers.given[i].text, answers.given[i].value.convert_to<double>(),
                               error.convert_to<double>(), 0,
                               Real(abs(ours)).convert_to<double>()});
        }
        const auto few = few_digits(numbers);
        if (!few) {
            continue;
        }
        Convention& c = found.emplace_back();
        c.of = family;
        c.name = few->name;
        c.relation = few->digits.empty() ? "in single precision (binary32)"
                                         : "right, and cut to " + few->digits + " when written";
        c.hint = few->digits.empty()
                     ? "compute and write in double precision"
                     : "write all 17 digits of a double (%.17g), or state what you write with "
                       "--digits";
        c.failing = rows.size();
        c.rows = few->rows.size();
        c.digits = agreements.cases[rows[few->rows.front()]].digits;
        for (const std::size_t k : few->rows) {
            c.which.push_back(rows[k]);
            c.digits = std::min(c.digits, agreements.cases[rows[k]].digits);
        }
        c.held = c.digits;
    }
    return found;
}

namespace {

/// An answer at a place that may lose digits there.
struct LossRow {
    std::size_t question;
    double place;  ///< log10 of a distance over a + b
    double digits; ///< digits of the answer
};

/// A distance whose decrease may cost digits.
struct LossPlace {
    double Nearness::*distance;
    const char* name;
    const char* remedy;
};
constexpr LossPlace loss_places[] = {
    {&Nearness::edge, "u",
     "x = a - u (or b - u) formed first, in floating point? u is given exactly: compute from u, "
     "such as a^2 - x^2 = u (2 a - u)"},
    {&Nearness::other_edge, "the distance from the other edge",
     "a difference of nearly equal lengths near the other edge? compute from the distance to it"},
    {&Nearness::knot, "the distance from the nearest knot or apex",
     "a difference of nearly equal lengths near a knot? compute from the distance to it"},
    {&Nearness::edge_to_knot, "the distance between the edge and the nearest knot",
     "a difference of nearly equal lengths, such as a - t? compute from this distance"},
};

/// The digits of a format in which the difference is computed: those left of a distance a + b.
struct LossFormat {
    double least;
    double most;
    double full; ///< digits of a number
    const char* name;
};
constexpr LossFormat loss_formats[] = {{14.5, 17.8, 15.95, "binary64"}, {5.7, 9, 7.2, "binary32"}};

constexpr std::size_t least_lossy_rows = 4;
constexpr double least_decades = 2;
constexpr double least_rate = 0.7; // digits per decade; rounding to a multiple of an ulp costs one
constexpr double most_rate = 3.3;
constexpr double most_digits_kept = 40;
constexpr double near_line = 1; // digits: an error of rounding may be ten times smaller than usual
constexpr double lucky_share = 0.25; // errors of rounding may vanish
constexpr double no_digits = 0.3;
constexpr double full_double = 15;

double median_of(std::vector<double> list) { return diagnose::sorted_at(std::move(list), 0.5); }

/// Digits that decrease linearly with log10 of a distance, below a level.
struct LossLine {
    double rate = 0;    ///< digits per decade
    double at_one = 0;  ///< digits at the distance a + b
    double plateau = 0; ///< digits where none are lost
    [[nodiscard]] double digits(double place) const {
        return std::clamp(at_one + rate * place, 0.0, plateau);
    }
};

/// Fits a line to the rows that have fewer digits than those at the greatest distances, by the
/// median of slopes (Theil and Sen), which single rows do not disturb.
std::optional<LossLine> fitted_loss(std::vector<LossRow>& rows) {
    if (rows.size() < least_lossy_rows) {
        return {};
    }
    std::ranges::sort(rows, std::greater(), &LossRow::place);
    std::vector<double> far;
    for (std::size_t i = 0; i < rows.size() / 4; ++i) {
        far.push_back(rows[i].digits);
    }
    LossLine line;
    line.plateau = std::min(median_of(std::move(far)), full_double + 1);
    std::vector<LossRow> lossy;
    std::ranges::copy_if(rows, std::back_inserter(lossy), [&](const LossRow& row) {
        return row.digits < line.plateau - near_line && row.digits > no_digits;
    });
    if (lossy.size() < least_lossy_rows ||
        lossy.front().place - lossy.back().place < least_decades) {
        return {};
    }
    std::vector<double> rates;
    for (const LossRow& farther : lossy) {
        for (const LossRow& row : lossy) {
            if (const double apart = farther.place - row.place; apart >= 1) {
                rates.push_back((farther.digits - row.digits) / apart);
            }
        }
    }
    if (rates.empty()) {
        return {};
    }
    line.rate = median_of(std::move(rates));
    std::vector<double> levels;
    for (const LossRow& row : lossy) {
        levels.push_back(row.digits - line.rate * row.place);
    }
    line.at_one = median_of(std::move(levels));
    return line;
}

/// True if no more than one row in ten has fewer digits than the line allows, and only some have
/// more.
bool follows(const std::vector<LossRow>& rows, const LossLine& line) {
    std::size_t fewer = 0;
    std::size_t more = 0;
    std::size_t lossy = 0;
    for (const LossRow& row : rows) {
        const double expected = line.digits(row.place);
        const bool loses = expected < line.plateau - near_line;
        lossy += loses ? 1 : 0;
        fewer += row.digits < expected - (loses ? near_line : 2 * near_line) ? 1 : 0;
        more += loses && row.digits > expected + near_line ? 1 : 0;
    }
    const auto share = [](std::size_t part, std::size_t all) {
        return static_cast<double>(part) / static_cast<double>(all);
    };
    return lossy >= least_lossy_rows && share(fewer, rows.size()) <= 1 - diagnose::least_share &&
           share(more, lossy) <= lucky_share;
}

/// True if the errors are those of a displaced edge, not of rounding: at most edges of the contacts
/// they have one sign, and one size after division by the line.
bool is_smooth(const std::vector<LossRow>& rows, const LossLine& line, const Answers& answers,
               const Agreements& agreements) {
    std::map<std::pair<std::size_t, contact::Edge>, std::vector<double>> edges;
    for (const LossRow& row : rows) {
        if (row.digits > no_digits + 1 && line.digits(row.place) < line.plateau - near_line) {
            const Question& q = answers.questions.list[row.question];
            const Real exact = agreements.references[row.question].value.value.midpoint();
            const Real off = Ball(answers.given[row.question].value, 256).midpoint() / exact - 1;
            edges[{q.contact, q.edge}].push_back(off.convert_to<double>() *
                                                 std::pow(10, line.at_one + line.rate * row.place));
        }
    }
    std::size_t scattered = 0;
    std::size_t smooth = 0;
    for (auto& [edge, sizes] : edges) {
        const double middle = median_of(sizes);
        for (double& size : sizes) {
            size = std::abs(size - middle);
        }
        constexpr double of_one_size = 0.1;
        (median_of(sizes) < of_one_size * std::abs(middle) ? smooth : scattered) +=
            sizes.size() > 2 ? 1 : 0;
    }
    return smooth > scattered;
}

std::optional<Convention> loss_of(const std::string& of, std::vector<LossRow> rows,
                                  const LossPlace& place, const Answers& answers,
                                  const Agreements& agreements) {
    const auto line = fitted_loss(rows);
    if (!line || line->rate < least_rate || line->rate > most_rate || !follows(rows, *line)) {
        return {};
    }
    const auto* const format = std::ranges::find_if(loss_formats, [&](const LossFormat& f) {
        return line->at_one >= f.least && line->at_one <= f.most;
    });
    if (format == std::end(loss_formats) || is_smooth(rows, *line, answers, agreements)) {
        return {};
    }
    const auto distance = [&](double digits) {
        return std::min(1.0, std::pow(10, (digits - line->at_one) / line->rate));
    };
    // If all rows fail, those without a loss may have been left out (most_failing).
    const bool all_fail = std::ranges::none_of(
        rows, [&](const LossRow& row) { return agreements.cases[row.question].pass; });
    const double full = all_fail ? format->full : std::min(line->plateau, format->full);
    Convention c;
    c.of = of;
    c.name = "cancellation";
    c.held = line->plateau; // of rows that lose no digits
    c.digits = most_digits_kept;
    c.without_digits = true;
    for (const LossRow& row : rows) {
        if (!agreements.cases[row.question].pass) {
            ++c.failing;
            c.which.push_back(row.question);
            c.digits = std::min(c.digits, row.digits);
        }
    }
    c.rows = c.which.size();
    if (c.rows == 0) {
        return {};
    }
    c.relation = fmt::format(
        "right, but lose {:.1f} digits for each decade by which {} decreases: the loss begins at "
        "{:.1g} (a + b), and no digit is left at {:.1g} (a + b), as in {}",
        line->rate, place.name, distance(full), distance(0), format->name);
    c.hint = place.remedy;
    return c;
}

} // namespace

std::vector<Convention> infer_cancellation(const Answers& answers, const Agreements& agreements) {
    std::vector<Convention> found;
    std::set<std::size_t> explained;
    for (const LossPlace& place : loss_places) {
        std::map<std::string, std::vector<LossRow>> groups;
        for (std::size_t i = 0; i < agreements.cases.size(); ++i) {
            const CaseAgreement& held = agreements.cases[i];
            const double distance = held.nearness.*place.distance;
            if (distance > 0 && !explained.contains(i) && has_value(answers, agreements, i)) {
                groups[family_of(answers.questions.list[i])].push_back(
                    {i, std::log10(distance), held.digits});
            }
        }
        for (auto& [family, rows] : groups) {
            if (auto c = loss_of(family, std::move(rows), place, answers, agreements)) {
                explained.insert(c->which.begin(), c->which.end());
                found.push_back(std::move(*c));
            }
        }
    }
    return found;
}

} // namespace edgeproof::conformance

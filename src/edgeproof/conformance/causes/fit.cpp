// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace edgeproof::conformance {
namespace {

/// A row follows a cause that nine of ten follow to `held` if it does so to three times that.
constexpr double of_held = 3;
constexpr double deviations_of_median = 4;
constexpr double deviations_of_change = 3; ///< the least change of an answer by a cause
constexpr std::size_t rows_for_scatter = 6;
constexpr double rows_for_less_gain = 6;  // with this number of rows, twice the gain is needed
constexpr double rows_for_less_error = 4; // the scatter of few rows is not well known
constexpr double of_a_median = 1.25;      // the standard error of a median, over that of a mean
constexpr double of_a_deviation = 1.483;  // a standard deviation over the median of absolute values
constexpr std::size_t least_neighbours = 6;
/// Half the mean square of the differences of neighbours, over the variance, is 1 for noise, with a
/// standard deviation of 1 over the root of their number.
constexpr double like_noise = 0.4;
constexpr double deviations_of_noise = 3.5;
constexpr double rounding = 1e-7; // smaller scatter is not used to distinguish causes

double sorted_at(std::vector<double> list, double share) {
    const auto at =
        list.begin() + static_cast<long>(share * static_cast<double>(list.size() - 1) + 0.5);
    std::nth_element(list.begin(), at, list.end());
    return *at;
}

std::vector<double> absolute(std::vector<double> list) {
    for (double& x : list) {
        x = std::abs(x);
    }
    return list;
}

double root(std::size_t n) { return std::sqrt(static_cast<double>(std::max<std::size_t>(n, 1))); }

/// Half the mean square of the differences of neighbours, over the mean square about the median.
std::optional<bool> is_noise_like(const WrongRows& rows, const std::vector<double>& off,
                                  double held) {
    if (rows.neighbours.size() < least_neighbours) {
        return {};
    }
    const double middle = sorted_at(off, 0.5);
    const double most = of_held * held;
    const auto limited = [&](std::size_t i) { return std::clamp(off[i] - middle, -most, most); };
    double differences = 0;
    double all = 0;
    for (const auto& [i, k] : rows.neighbours) {
        const double apart = limited(i) - limited(k);
        differences += apart * apart / 2;
        all += (limited(i) * limited(i) + limited(k) * limited(k)) / 2;
    }
    const double least =
        std::max(like_noise, 1 - deviations_of_noise / root(rows.neighbours.size()));
    // Roundoff of a constant remainder need not look like noise.
    const double roundoff = rounding * rounding * static_cast<double>(rows.neighbours.size());
    return all <= roundoff || differences > least * all;
}

} // namespace

bool enough(std::size_t rows, std::size_t failing) {
    return rows >= least_rows &&
           static_cast<double>(rows) >= least_share * static_cast<double>(failing);
}

WrongRows wrong_rows(const Answers& answers, const Agreements& agreements,
                     std::vector<std::size_t> questions) {
    WrongRows rows;
    rows.questions = std::move(questions);
    struct Point {
        std::size_t contact;
        std::string symbol;
        double x;
        std::size_t row;
    };
    std::vector<Point> points;
    for (std::size_t k = 0; k < rows.questions.size(); ++k) {
        const std::size_t i = rows.questions[k];
        rows.answers.push_back(Ball(answers.given[i].value, 256).midpoint());
        rows.ours.push_back(agreements.references[i].value.value.midpoint());
        const Question& q = answers.questions.list[i];
        if (q.at_point()) {
            const double u = agreements.cases[i].nearness.edge;
            points.push_back({q.contact, symbol_of(q) + scene::edge_name(q.edge), u, k});
        }
    }
    std::ranges::sort(points, {},
                      [](const Point& p) { return std::tuple(p.contact, p.symbol, p.x); });
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (points[k].contact == points[k - 1].contact &&
            points[k].symbol == points[k - 1].symbol) {
            rows.neighbours.emplace_back(points[k - 1].row, points[k].row);
        }
    }
    return rows;
}

double uncertainty_of_scatter(std::size_t rows) {
    return 1 + rows_for_less_error / static_cast<double>(rows);
}

Fit remainder_of(const WrongRows& rows, const std::vector<std::optional<Real>>& values) {
    Fit fit;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Real& value = values[k] ? *values[k] : rows.ours[k];
        const auto relative = [](const Real& x, const Real& y) {
            return std::clamp(Real(x / y - 1).convert_to<double>(), -1e300, 1e300);
        };
        fit.off.push_back(relative(rows.answers[k], value));
        fit.before.push_back(std::abs(relative(rows.answers[k], rows.ours[k])));
        fit.change.push_back(values[k] ? std::abs(relative(value, rows.ours[k])) : 0);
    }
    fit.held = sorted_at(absolute(fit.off), least_share);
    fit.scatter = of_a_deviation * sorted_at(absolute(fit.off), 0.5);
    fit.noise_like = is_noise_like(rows, fit.off, fit.held);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const bool changes =
            fit.change[k] > std::max(same_value, deviations_of_change * fit.scatter);
        const bool follows = std::abs(fit.off[k]) <= std::max(same_value, of_held * fit.held);
        fit.changes.push_back(changes);
        if (changes && follows) {
            ++fit.rows;
            fit.worst = std::max(fit.worst, std::abs(fit.off[k]));
        }
    }
    return fit;
}

std::optional<Fit> fit_of(const WrongRows& rows, const std::vector<std::optional<Real>>& values,
                          double noise) {
    if (rows.size() < least_rows) {
        return {};
    }
    Fit fit = remainder_of(rows, values);
    // A few rows of much scatter agree with some named factor by chance.
    if (!(fit.held <= (rows.size() < rows_for_scatter ? most_remainder : most_scatter))) {
        return {};
    }
    std::vector<double> left;
    std::vector<double> left_before;
    std::vector<double> of_ratio; // as large for 1/2 as for 2
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (fit.changes[k]) {
            left.push_back(fit.off[k]);
            left_before.push_back(fit.before[k]);
            const Real inverse = rows.ours[k] / rows.answers[k] - 1;
            of_ratio.push_back(
                std::max(fit.before[k], std::min(std::abs(inverse.convert_to<double>()), 1e300)));
        }
    }
    if (!enough(fit.rows, left.size())) {
        return {};
    }
    const double few = 1 / static_cast<double>(left.size());
    const double before_half = sorted_at(left_before, 0.5);
    const double left_half = sorted_at(absolute(left), 0.5);
    const double gain = least_gain * (1 + rows_for_less_gain * few);
    const bool dominates = sorted_at(std::move(of_ratio), 0.5) >= dominant_gain * left_half;
    fit.dominates = dominates;
    if (before_half < gain * left_half || (fit.held > std::max(most_remainder, of_held * noise) &&
                                           !dominates && !fit.noise_like.value_or(false))) {
        return {};
    }
    const double middle = sorted_at(left, 0.5);
    std::vector<double> about = left;
    for (double& x : about) {
        x = std::abs(x - middle);
    }
    const double deviation = std::max(of_a_deviation * sorted_at(std::move(about), 0.5), noise);
    const double error =
        of_a_median * deviation * uncertainty_of_scatter(left.size()) / root(left.size());
    const double smooth = fit.noise_like.value_or(!dominates) ? 0 : fit.held / (dominates ? 1 : 2);
    return std::abs(middle) <= std::max({same_value, deviations_of_median * error, smooth})
               ? std::optional(std::move(fit))
               : std::nullopt;
}

double misfit(const Fit& fit, double scatter) {
    const double unit = std::max(scatter, rounding);
    constexpr double most = 5;
    double sum = 0;
    for (const double off : fit.off) {
        const double deviations = std::min(std::abs(off) / unit, most);
        sum += deviations * deviations;
    }
    return sum;
}

double indistinguishable_misfit(const Fit& best) {
    constexpr double of_noise = 20;
    constexpr double independent_values = 5;
    return best.noise_like.value_or(true)
               ? of_noise
               : of_noise *
                     std::max(1.0, static_cast<double>(best.off.size()) / independent_values);
}

std::string CommonRatio::text() const {
    constexpr double most_printed = 1e-10;
    const double digits = -std::log10(error + most_printed);
    return fmt::format("{:.{}g}", value.convert_to<double>(),
                       static_cast<int>(std::max(2.0, std::round(digits))));
}

std::optional<CommonRatio> common_ratio(const WrongRows& rows,
                                        const std::vector<std::optional<Real>>& values) {
    std::vector<Real> ratios;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (values[k]) {
            ratios.emplace_back(rows.answers[k] / *values[k]);
        }
    }
    if (!enough(ratios.size(), rows.size())) {
        return {};
    }
    const auto middle = ratios.begin() + static_cast<long>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    CommonRatio common{*middle};
    if (common.value == 0) {
        return {};
    }
    std::vector<double> about;
    for (const Real& ratio : ratios) {
        about.push_back(std::abs(Real(ratio / common.value - 1).convert_to<double>()));
    }
    common.error =
        of_a_median * of_a_deviation * sorted_at(std::move(about), 0.5) / root(ratios.size());
    return common;
}

} // namespace edgeproof::conformance

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/wrong_rows.hpp"
#include "edgeproof/diagnose/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

namespace edgeproof::conformance {
namespace {

/// x/y - 1
double relative(const Real& x, const Real& y) {
    return std::clamp(Real(x / y - 1).convert_to<double>(), -1e300, 1e300);
}

} // namespace

Values times(Values values, const Real& factor) {
    for (auto& value : values) {
        if (value) {
            *value *= factor;
        }
    }
    return values;
}

bool has_value(const Answers& answers, const Agreements& agreements, std::size_t i) {
    return answers.given[i].state == Answer::State::number &&
           agreements.cases[i].no_reference.empty() &&
           !contains_zero(agreements.references[i].value.value);
}

std::vector<std::size_t> evenly(const std::vector<std::size_t>& rows, std::size_t most) {
    std::vector<std::size_t> some;
    const std::size_t n = std::min(rows.size(), most);
    for (std::size_t k = 0; k < n; ++k) {
        some.push_back(rows[k * rows.size() / n]);
    }
    return some;
}

WrongRows wrong_rows(const Answers& answers, const Agreements& agreements,
                     std::vector<std::size_t> questions) {
    WrongRows rows;
    rows.questions = std::move(questions);
    std::vector<std::tuple<std::size_t, std::string, double, std::size_t>> points;
    for (std::size_t k = 0; k < rows.questions.size(); ++k) {
        const std::size_t i = rows.questions[k];
        rows.answers.push_back(Ball(answers.given[i].value, 256).midpoint());
        rows.ours.emplace_back(agreements.references[i].value.value.midpoint());
        const Question& q = answers.questions.list[i];
        if (q.at_point()) {
            points.emplace_back(q.contact, symbol_of(q) + scene::edge_name(q.edge),
                                agreements.cases[i].nearness.edge, k);
        }
    }
    std::ranges::sort(points);
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (std::get<0>(points[k]) == std::get<0>(points[k - 1]) &&
            std::get<1>(points[k]) == std::get<1>(points[k - 1])) {
            rows.neighbours.emplace_back(std::get<3>(points[k - 1]), std::get<3>(points[k]));
        }
    }
    return rows;
}

diagnose::Remainders remainders(const WrongRows& rows, const Values& values) {
    diagnose::Remainders all;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Real& answer = rows.answers[k];
        const Real& ours = *rows.ours[k];
        all.off.push_back(relative(answer, values[k] ? *values[k] : ours));
        all.before.push_back(std::abs(relative(answer, ours)));
        all.ratio.push_back(std::max(all.before[k], std::abs(relative(ours, answer))));
        all.change.push_back(values[k] ? std::abs(relative(*values[k], ours)) : 0);
    }
    all.neighbours = rows.neighbours;
    return all;
}

double CommonRatio::off(const Real& of) const { return std::abs(relative(value, of)); }

std::string CommonRatio::text() const {
    constexpr double most_printed = 1e-10;
    const double digits = -std::log10(error + most_printed);
    return fmt::format("{:.{}g}", value.convert_to<double>(),
                       static_cast<int>(std::max(2.0, std::round(digits))));
}

std::optional<CommonRatio> common_ratio(const WrongRows& rows, const Values& values) {
    std::vector<Real> ratios;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (values[k]) {
            ratios.emplace_back(rows.answers[k] / *values[k]);
        }
    }
    if (!diagnose::enough(ratios.size(), rows.size())) {
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
        about.push_back(std::abs(relative(ratio, common.value)));
    }
    common.error = diagnose::error_of_median(std::move(about));
    return common;
}

/// Groups the rows by quantity (c_k and s_k together, and separately), at both edges and at each
/// edge. The largest group comes first; among groups of the same rows, the most specific name.
std::vector<Group> groups_of(const Questions& questions, const std::vector<std::size_t>& rows) {
    std::vector<Group> groups;
    for (const std::size_t row : rows) {
        const Question& q = questions.list[row];
        const std::string family = family_of(q);
        const auto add = [&](const std::string& name) {
            auto known = std::ranges::find(groups, name, &Group::name);
            if (known == groups.end()) {
                known = groups.insert(known, {name, family, {}});
            }
            known->rows.push_back(row);
        };
        add(family);
        if (q.at_edge()) {
            add(family + ", " + scene::edge_name(q.edge) + " edge");
        }
        if (symbol_of(q) != family) {
            add(symbol_of(q));
        }
    }
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) {
        return std::pair(g.rows.size(), g.name.size() + (g.name.ends_with("_k") ? 0 : 1));
    });
    return groups;
}

// Factors with a name that are near answers which have another cause as well.

namespace {

using diagnose::least_gain;
using diagnose::NamedFactor;

constexpr double most_rest = 0.105;      ///< that a factor with a name may leave
constexpr std::size_t part_outside = 20; ///< one row of this number lies outside, on each side
/// Relative standard deviations that an interval exceeds: noise of 12 answers has a range of more
/// than 6 in one case of a thousand.
constexpr double noise_in_interval = 6;
/// If a factor is named, so are those whose rest, over the limits of a rest, is that much larger.
constexpr double similar_rest = 1.25;

} // namespace

double cause_digits(double off) {
    return off == 0 ? most_cause_digits
                    : std::clamp(-std::log10(off), 0.0, double(most_cause_digits));
}

void add_near_factors(Convention& of, double least, double most) {
    const std::vector<NamedFactor> factors = diagnose::named_factors();
    const auto rest = [](const Real& ratio) {
        return std::abs(Real(ratio - 1).convert_to<double>());
    };
    const double wide = most - least;
    const auto rest_left = [&](const Real& k) {
        return std::max(rest(Real(least / k)), rest(Real(most / k)));
    };
    const auto of_limits = [&](const NamedFactor& factor) {
        const Real& k = factor.value;
        const bool apart = wide > 0 && (k < least - wide || k > most + wide);
        const double error = std::max(rest(k), rest(Real(1 / k)));
        return apart || !factor.possible("")
                   ? std::numeric_limits<double>::max()
                   : rest_left(k) * std::max(1 / most_rest, least_gain / error);
    };
    const double nearest = of_limits(*std::ranges::min_element(factors, {}, of_limits));
    for (const NamedFactor& factor : factors) {
        const bool known =
            std::ranges::find(of.equally_likely, factor.name) != of.equally_likely.end();
        if (nearest > 1 || known || of_limits(factor) > std::max(1.0, similar_rest * nearest)) {
            continue;
        }
        of.also.push_back(
            wide > 0 ? fmt::format("{}ours, and up to {:.2g} % that have another cause",
                                   factor.words, 100 * rest_left(factor.value))
                     : fmt::format("{}ours, and {:+.2g} % that have another cause", factor.words,
                                   100 * Real(least / factor.value - 1).convert_to<double>()));
        of.equally_likely.emplace_back(factor.name);
    }
}

std::pair<double, double> interval_of(const WrongRows& all) {
    std::vector<double> ratios = remainders(all, all.ours).off;
    std::ranges::sort(ratios);
    const std::size_t outside = ratios.size() / part_outside;
    return {1 + ratios[outside], 1 + ratios[ratios.size() - 1 - outside]};
}

std::optional<Convention> varying_factor(const WrongRows& all, double noise) {
    const auto [least, most] = interval_of(all);
    const double wide = noise_in_interval * noise * std::abs(most + least) / 2;
    Convention c;
    if (!remainder_of(remainders(all, all.ours)).noise_like.value_or(most - least < wide)) {
        add_near_factors(c, least, most);
    }
    if (c.also.empty()) {
        return {};
    }
    c.relation = fmt::format("{:.3g} to {:.3g} times ours", least, most);
    c.hint = "a factor that is no constant";
    c.name = "varying-factor";
    c.factor = (least + most) / 2;
    c.failing = all.size();
    c.rows = c.failing - 2 * (c.failing / part_outside);
    c.held = cause_digits(most / least - 1);
    c.without_digits = true;
    return c;
}

} // namespace edgeproof::conformance

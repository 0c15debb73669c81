// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/wrong_rows.hpp"
#include "edgeproof/diagnose/factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace edgeproof::conformance {

double relative(const Real& x, const Real& y) {
    return std::clamp(Real(x / y - 1).convert_to<double>(), -1e300, 1e300);
}

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

std::vector<Group> groups_of(const Answers& answers, const Agreements& agreements,
                             const std::vector<std::size_t>& failing) {
    std::vector<Group> groups;
    for (const std::size_t row : failing) {
        const Question& q = answers.questions.list[row];
        const std::string family = family_of(q);
        const auto add = [&](const std::string& name) {
            auto known = std::ranges::find(groups, name, &Group::name);
            if (known == groups.end()) {
                known = groups.insert(known, {name, family, {}});
            }
            known->rows.questions.push_back(row);
        };
        add(family);
        if (q.at_edge()) {
            add(family + ", " + scene::edge_name(q.edge) + " edge");
        }
        if (symbol_of(q) != family) {
            add(symbol_of(q));
        }
    }
    for (Group& group : groups) {
        const Group& all = *std::ranges::find(groups, group.family, &Group::name);
        group.whole = group.rows.size() == all.rows.size();
    }
    for (Group& group : groups) {
        group.rows = wrong_rows(answers, agreements, std::move(group.rows.questions));
    }
    std::ranges::stable_sort(groups, std::greater(), [](const Group& g) {
        return std::pair(g.rows.size(), g.name.size() + (g.name.ends_with("_k") ? 0 : 1));
    });
    return groups;
}

namespace {

constexpr double most_cause_digits = 40;
constexpr std::size_t part_outside = 20; ///< one row of this number lies outside, on each side
/// Relative standard deviations that an interval exceeds: noise of 12 answers has a range of more
/// than 6 in one case of a thousand.
constexpr double noise_in_interval = 6;

} // namespace

double cause_digits(double off) {
    return off == 0 ? most_cause_digits : std::clamp(-std::log10(off), 0.0, most_cause_digits);
}

void add_near_factors(Convention& of, double least, double most) {
    for (const auto& [factor, rest] : diagnose::near_factors(least, most)) {
        if (std::ranges::find(of.equally_likely, factor.name) == of.equally_likely.end()) {
            of.also.push_back(
                most > least
                    ? fmt::format("{}ours, and up to {:.2g} % that have another cause",
                                  factor.words, 100 * rest)
                    : fmt::format("{}ours, and {:+.2g} % that have another cause", factor.words,
                                  100 * Real(least / factor.value - 1).convert_to<double>()));
            of.equally_likely.emplace_back(factor.name);
        }
    }
}

std::pair<double, double> interval_of(const WrongRows& all) {
    std::vector<double> ratios = remainders(all, all.ours).off;
    std::ranges::sort(ratios);
    const std::size_t outside = ratios.size() / part_outside;
    return {1 + ratios[outside], 1 + ratios[ratios.size() - 1 - outside]};
}

std::optional<Convention> varying_factor(const Group& group, double noise) {
    const WrongRows& all = group.rows;
    const auto [least, most] = interval_of(all);
    const double wide = noise_in_interval * noise * std::abs(most + least) / 2;
    Convention c;
    if (!remainder_of(remainders(all, all.ours)).noise_like.value_or(most - least < wide)) {
        add_near_factors(c, least, most);
    }
    if (c.also.empty()) {
        return {};
    }
    c.of = group.family;
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

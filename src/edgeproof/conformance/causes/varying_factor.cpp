// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/varying_factor.hpp"

#include "edgeproof/diagnose/factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgeproof::conformance {
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

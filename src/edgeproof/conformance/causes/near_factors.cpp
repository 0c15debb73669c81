// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/wrong_rows.hpp"
#include "edgeproof/diagnose/mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Factors with a name that are near answers which have another cause as well.
namespace edgeproof::conformance {
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

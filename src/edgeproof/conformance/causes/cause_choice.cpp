// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/cause_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr double most_rest = 0.105;      ///< that a factor with a name may leave
constexpr std::size_t part_outside = 20; ///< one row of this number lies outside, on each side
/// Answers with fewer digits scatter by percents: a factor with a name and another cause may have
/// the effect of a third one.
constexpr double digits_of_percents = 1.5;
/// Relative standard deviations that an interval exceeds: noise of 12 answers has a range of more
/// than 6 in one case of a thousand.
constexpr double noise_in_interval = 6;
/// Many causes are tried, and a constant is fitted to the answers: chance may favour it by more.
constexpr double favour_of_constant = 2;
/// If a factor is named, so are those whose rest, over the limits of a rest, is that much larger.
constexpr double similar_rest = 1.25;

} // namespace

void CauseSearch::explain_by_others() {
    std::vector<Explained> more;
    for (const Group& group : groups_) {
        if (is_done(group) || !is_whole(group)) {
            continue;
        }
        const WrongRows rows = wrong_rows(answers_, agreements_, group.rows);
        const double before = remainder_of(rows, all_of(rows)).scatter;
        Explained explained{group, {}};
        for (const Explained& other : explained_) {
            for (Likely cause : other.likely) {
                cause.fit = remainder_of(rows, values_of(cause, rows));
                if (cause.fit.noise_like.value_or(false) &&
                    least_gain * cause.fit.scatter < before) {
                    explained.likely.push_back(std::move(cause));
                }
            }
        }
        if (!explained.likely.empty()) {
            done_.insert(group.rows.begin(), group.rows.end());
            more.push_back(std::move(explained));
        }
    }
    std::ranges::move(more, std::back_inserter(explained_));
}

void CauseSearch::add_causes_of_others() {
    const std::vector<Explained> before = explained_;
    for (Explained& group : explained_) {
        const WrongRows rows = wrong_rows(answers_, agreements_, group.group.rows);
        for (const Explained& other : before) {
            for (Likely cause : other.likely) {
                // The text of a constant without a name may be that of a named factor.
                const bool known = std::ranges::any_of(group.likely, [&](const Likely& l) {
                    return l.name == cause.name && l.relation == cause.relation;
                });
                if (!known) {
                    cause.fit = remainder_of(rows, values_of(cause, rows));
                    group.likely.push_back(std::move(cause));
                }
            }
        }
        keep_best(group);
    }
}

void CauseSearch::add_doubt(const WrongRows& rows, Explained& to) {
    const auto ratio = common_ratio(rows, all_of(rows));
    if (to.likely.empty() || !ratio || 4 * ratio->error < unlikely_by_chance) {
        return;
    }
    constexpr double two_deviations = 4;
    auto fit = fit_of(rows, times(all_of(rows), ratio->value), noise_);
    const bool as_well = fit && std::ranges::all_of(to.likely, [&](const Likely& l) {
                             const double unit = std::max(fit->scatter, noise_);
                             const double allowed = l.rank == 0 ? -two_deviations : two_deviations;
                             return misfit(*fit, unit) <= misfit(l.fit, unit) + allowed;
                         });
    const double unscattered = std::max(same_value, 3 * noise_);
    if (as_well && fit->noise_like.value_or(fit->held <= unscattered)) {
        noise_ = std::max(noise_, fit->scatter);
        to.likely.push_back(constant(*ratio, std::move(*fit)));
    }
}

double CauseSearch::unit_of(const Explained& explained) const {
    double least = std::numeric_limits<double>::max();
    for (const Likely& l : explained.likely) {
        least = std::min(least, l.fit.scatter);
    }
    return std::max(least * uncertainty_of_scatter(explained.group.rows.size()), noise_);
}

void CauseSearch::keep_best(Explained& explained) {
    auto& likely = explained.likely;
    if (std::ranges::any_of(likely, [](const Likely& l) { return !l.contradicted; })) {
        std::erase_if(likely, [](const Likely& l) { return l.contradicted; });
    }
    if (likely.empty()) {
        return;
    }
    const double unit = unit_of(explained);
    const auto misfit_in_units = [&](const Likely& l) { return misfit(l.fit, unit); };
    const Likely& best = *std::ranges::min_element(likely, {}, misfit_in_units);
    const double favour = best.rank == rank_of_constant ? favour_of_constant : 1;
    const double most = misfit_in_units(best) + favour * indistinguishable_misfit(best.fit);
    if (best.fit.noise_like.value_or(false)) {
        noise_ = std::max(noise_, best.fit.scatter);
    }
    // The rest after a common factor may nearly be a constant.
    const bool may_vary =
        best.rank == rank_of_constant && !best.fit.noise_like.value_or(best.fit.held <= same_value);
    std::erase_if(likely, [&](const Likely& l) {
        return misfit_in_units(l) > most && !(may_vary && l.rank == 0 && l.fit.dominates);
    });
    std::ranges::stable_sort(likely, {}, [&](const Likely& l) {
        return std::pair(l.rank, l.rank == 1 ? 0 : misfit_in_units(l));
    });
}

std::size_t CauseSearch::rows_of(const Likely& cause) const {
    std::size_t rows = 0;
    for (const Explained& explained : explained_) {
        std::size_t most = 0;
        for (const Likely& l : explained.likely) {
            if (l.name == cause.name && l.relation == cause.relation) {
                most = std::max(most, l.fit.rows);
            }
        }
        rows += most;
    }
    return rows;
}

Convention CauseSearch::convention(const Explained& explained) const {
    const auto& likely = explained.likely;
    const Likely& first = *std::ranges::max_element(likely, {}, [&](const Likely& l) {
        return (l.rank == rank_of_constant ? 1 : 2) * rows_of(l);
    });
    Convention c;
    c.of = first.of_family ? explained.group.family : explained.group.name;
    c.relation = first.relation;
    c.hint = first.hint;
    c.name = first.name;
    c.factor = first.factor;
    c.rows = first.fit.rows;
    c.failing = explained.group.rows.size();
    c.digits = digits_of(first.fit.worst);
    c.held = digits_of(first.fit.held);
    c.remains = first.fit.noise_like.value_or(true) ? 0 : first.fit.held;
    for (const Likely& l : likely) {
        const bool new_words =
            l.relation != c.relation && std::ranges::find(c.also, l.relation) == c.also.end();
        if (new_words) {
            c.also.push_back(l.relation);
            c.equally_likely.push_back(l.name);
        }
    }
    if (first.rank == 2 && std::max(first.doubtful, c.remains) > unlikely_by_chance) {
        c.also.emplace_back(c.remains == 0 ? "a constant without a name"
                                           : "a factor that varies, near that number by chance");
        c.equally_likely.emplace_back("factor");
    }
    // A mistake that leaves a smooth remainder may have nearly the effect of a factor by chance.
    if (first.rank == 1 && c.remains > unlikely_by_chance) {
        const auto [least, most] = interval_of(explained.group);
        add_near_factors(c, least, most);
    }
    if (first.rank == rank_of_constant) {
        add_near_factors(c, c.factor, c.factor);
    } else if (c.held < digits_of_percents) {
        const auto [least, most] = interval_of(explained.group);
        add_near_factors(c, (least + most) / 2, (least + most) / 2);
    }
    return c;
}

void CauseSearch::add_near_factors(Convention& of, double least, double most) const {
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
        return apart || !possible(factor, "")
                   ? std::numeric_limits<double>::max()
                   : rest_left(k) * std::max(1 / most_rest, least_gain / error);
    };
    const double nearest = of_limits(*std::ranges::min_element(factors_, {}, of_limits));
    if (nearest > 1) {
        return;
    }
    for (const NamedFactor& factor : factors_) {
        const bool known =
            std::ranges::find(of.equally_likely, factor.name) != of.equally_likely.end();
        if (known || of_limits(factor) > std::max(1.0, similar_rest * nearest)) {
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

std::pair<double, double> CauseSearch::interval_of(const Group& group) const {
    const WrongRows all = wrong_rows(answers_, agreements_, group.rows);
    std::vector<double> ratios = remainder_of(all, all_of(all)).off;
    std::ranges::sort(ratios);
    const std::size_t outside = ratios.size() / part_outside;
    return {1 + ratios[outside], 1 + ratios[ratios.size() - 1 - outside]};
}

std::optional<Convention> CauseSearch::varying_factor(const Group& group) const {
    if (!is_whole(group) || group.rows.size() < least_rows_of_constant) {
        return {};
    }
    const auto [least, most] = interval_of(group);
    const WrongRows all = wrong_rows(answers_, agreements_, group.rows);
    if (remainder_of(all, all_of(all))
            .noise_like.value_or(most - least <
                                 noise_in_interval * noise_ * std::abs(most + least) / 2)) {
        return {};
    }
    Convention c;
    add_near_factors(c, least, most);
    if (c.also.empty()) {
        return {};
    }
    c.of = group.family;
    c.relation = fmt::format("{:.3g} to {:.3g} times ours", least, most);
    c.hint = "a factor that is no constant";
    c.name = "varying-factor";
    c.factor = (least + most) / 2;
    c.failing = group.rows.size();
    c.rows = c.failing - 2 * (c.failing / part_outside);
    c.held = digits_of(most / least - 1);
    c.without_digits = true;
    return c;
}

double CauseSearch::digits_of(double off) {
    return off == 0 ? most_cause_digits
                    : std::clamp(-std::log10(off), 0.0, double(most_cause_digits));
}

} // namespace edgeproof::conformance

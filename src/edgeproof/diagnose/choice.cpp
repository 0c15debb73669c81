// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/diagnose/choice.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace edgeproof::diagnose {
namespace {

/// Many causes are tried, and a constant is fitted to the numbers: chance may favour it by more.
constexpr double favour_of_constant = 2;

} // namespace

double unit_of(const std::vector<Candidate>& candidates, double noise) {
    double least = std::numeric_limits<double>::max();
    for (const Candidate& c : candidates) {
        least = std::min(least, c.fit.scatter);
    }
    return std::max(least * uncertainty_of_scatter(candidates.front().fit.off.size()), noise);
}

double most_misfit(const std::vector<Candidate>& candidates, double unit, std::size_t rows,
                   const std::function<Fit(const Candidate&)>& fit_of) {
    double least = std::numeric_limits<double>::max();
    for (const Candidate& c : candidates) {
        least = std::min(least, misfit(fit_of(c), unit));
    }
    return least + indistinguishable_misfit(candidates.front().fit, rows);
}

void keep_best(std::vector<Candidate>& candidates, double& noise) {
    if (!std::ranges::all_of(candidates, &Candidate::contradicted)) {
        std::erase_if(candidates, &Candidate::contradicted);
    }
    if (candidates.empty()) {
        return;
    }
    const double unit = unit_of(candidates, noise);
    const auto misfit_in_units = [&](const Candidate& c) { return misfit(c.fit, unit); };
    const Candidate& best = *std::ranges::min_element(candidates, {}, misfit_in_units);
    const bool constant = best.rank == Candidate::constant;
    const double most =
        misfit_in_units(best) + (constant ? favour_of_constant : 1) *
                                    indistinguishable_misfit(best.fit, best.fit.off.size());
    if (best.fit.noise_like.value_or(false)) {
        noise = std::max(noise, best.fit.scatter);
    }
    // The rest after a common factor may nearly be a constant.
    const bool may_vary = constant && !best.fit.noise_like.value_or(best.fit.held <= same_value);
    std::erase_if(candidates, [&](const Candidate& c) {
        return misfit_in_units(c) > most &&
               !(may_vary && c.rank == Candidate::common_factor && c.fit.dominates);
    });
    std::ranges::stable_sort(candidates, {}, [&](const Candidate& c) {
        return std::pair(c.rank, c.rank == Candidate::mistake ? 0 : misfit_in_units(c));
    });
}

bool constant_is_better(const Fit& constant, const std::vector<Candidate>& named, double noise) {
    const double unit = std::max(constant.scatter, noise);
    const bool is_constant = constant.noise_like.value_or(constant.held <= same_value);
    return std::ranges::all_of(named, [&](const Candidate& c) {
        return !c.fit.noise_like.value_or(false) && (is_constant || !c.fit.dominates) &&
               misfit(c.fit, unit) >
                   misfit(constant, unit) + indistinguishable_misfit(c.fit, c.fit.off.size());
    });
}

bool constant_is_possible(const Fit& constant, const std::vector<Candidate>& named, double noise) {
    const double two_deviations = 4 / static_cast<double>(constant.off.size());
    const double unit = std::max(constant.scatter, noise);
    const double unscattered = std::max(same_value, 3 * noise);
    return constant.noise_like.value_or(constant.held <= unscattered) &&
           std::ranges::all_of(named, [&](const Candidate& c) {
               const bool common = c.rank == Candidate::common_factor;
               return misfit(constant, unit) <=
                      misfit(c.fit, unit) + (common ? -two_deviations : two_deviations);
           });
}

} // namespace edgeproof::diagnose

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/diagnose/diagnose.hpp"
#include "edgeproof/roots/roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace edgeproof::diagnose {

std::string FittedFactor::text() const {
    constexpr double most_printed = 1e-10;
    const double digits = -std::log10(error / std::abs(value) + most_printed);
    return fmt::format("{:.{}g}", value, static_cast<int>(std::max(2.0, std::round(digits))));
}

std::optional<FittedFactor> fitted_factor(const Residuals& of_some, const Residuals& of_all) {
    constexpr double widest = std::numbers::ln10;
    constexpr double nearest = 0.01; // to the logarithm of 1, of the factors tried
    constexpr int steps = 12;        // to a thousandth of the best of them
    constexpr int corrections = 3;
    constexpr double apart = 1e-6;
    constexpr double of_values = 1e-9; // the error of estimates of the exact pressure
    constexpr double without_value = 100;
    const auto sizes_at = [&](double logarithm) {
        std::vector<double> sizes = of_some(std::exp(logarithm));
        for (double& off : sizes) {
            off = std::isfinite(off) ? std::abs(off) : without_value;
        }
        return sizes;
    };
    const auto sum_at = [&](double logarithm) {
        const std::vector<double> sizes = sizes_at(logarithm);
        return std::accumulate(sizes.begin(), sizes.end(), 0.0);
    };
    // Several factors may have a locally least sum: p may be the same at two places.
    double best = 0;
    double least = sum_at(best);
    for (double size = widest; size > nearest; size /= std::numbers::sqrt2) {
        for (const double other : {size, -size}) {
            if (const double sum = sum_at(other); sum < least) {
                least = sum;
                best = other;
            }
        }
    }
    const double reach = std::max(std::abs(best), nearest) * (std::numbers::sqrt2 - 1);
    double logarithm = roots::place_of_minimum(sum_at, best - reach, best + reach, steps);
    if (sorted_at(sizes_at(logarithm), 0.5) > most_scatter) {
        return {};
    }
    double error = 0;
    for (int k = 0; k < corrections; ++k) {
        const std::vector<double> off = of_all(std::exp(logarithm));
        const std::vector<double> moved = of_all(std::exp(logarithm + apart));
        std::vector<std::pair<double, double>> zeros; // the step to that of a difference, its slope
        std::vector<double> sizes;
        double slopes = 0;
        double squares = 0;
        for (std::size_t i = 0; i < off.size(); ++i) {
            const double slope = std::abs(moved[i] - off[i]) / apart;
            if (std::isfinite(slope) && slope != 0) {
                zeros.emplace_back(off[i] * apart / (off[i] - moved[i]), slope);
                sizes.push_back(std::abs(off[i]));
                slopes += slope;
                squares += slope * slope;
            }
        }
        if (zeros.empty()) {
            return {};
        }
        std::ranges::sort(zeros);
        const auto median = std::ranges::find_if(zeros, [&, below = 0.0](const auto& zero) mutable {
            return 2 * (below += zero.second) >= slopes;
        });
        logarithm = std::clamp(logarithm + median->first, -widest, widest);
        error = std::sqrt(static_cast<double>(zeros.size()) / squares) *
                error_of_median(std::move(sizes));
    }
    if (std::abs(logarithm) < 3 * error) {
        return {}; // 1, as far as the data show
    }
    const double factor = std::exp(logarithm);
    return FittedFactor{factor, factor * (error + of_values)};
}

} // namespace edgeproof::diagnose

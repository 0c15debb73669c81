// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance::convention_rule {

struct Held {
    std::size_t rows = 0;
    double worst = 0; ///< in digits, of the rows that follow the factor
    double most = 0;  ///< digits that nine of ten have
};

/// Ratios of the answers to the references, or to those at the other edge; rows without a ratio do
/// not follow any factor.
class Ratios {
public:
    Ratios(std::vector<Real> ratios, std::size_t rows) : ratios_(std::move(ratios)), rows_(rows) {
        if (!enough(ratios_.size(), rows_)) {
            return;
        }
        std::vector<Real> sorted = ratios_;
        const auto middle = sorted.begin() + static_cast<long>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        median_ = *middle;
        spread_ = median_ == 0 ? 0 : held_to(median_).most;
    }
    [[nodiscard]] bool one_number() const { return spread_ >= least_digits; }
    [[nodiscard]] const Real& median() const { return median_; }
    /// True if the median is compatible with the factor: within four of its standard errors, or
    /// half the scatter, since errors need not be independent.
    [[nodiscard]] bool allow(const Real& factor) const {
        const double off = std::pow(10, -digits_between(median_, factor));
        return off <= std::max({std::pow(10, -same_digits), 4 * standard_error(), scatter() / 2});
    }
    /// Returns the median with its significant digits.
    [[nodiscard]] std::string median_text() const {
        constexpr double most_printed = 10;
        const double digits = -std::log10(standard_error() + std::pow(10, -most_printed));
        return fmt::format("{:.{}g}", median_.convert_to<double>(),
                           static_cast<int>(std::max(2.0, std::round(digits))));
    }
    [[nodiscard]] Held held_to(const Real& factor) const {
        std::vector<double> digits;
        for (const Real& ratio : ratios_) {
            digits.push_back(digits_between(ratio, factor));
        }
        digits.resize(rows_, 0.0);
        Held held{0, most_digits, held_by_most(digits)};
        for (const double d : digits) {
            if (d >= follows_from(held.most)) {
                ++held.rows;
                held.worst = std::min(held.worst, d);
            }
        }
        return held;
    }

private:
    [[nodiscard]] double scatter() const { return std::pow(10, -spread_); }
    /// The relative standard error of the median, assuming independent errors.
    [[nodiscard]] double standard_error() const {
        constexpr double deviations_in_the_spread = 1.645; // nine of ten are within
        constexpr double of_a_median = 1.25;
        return of_a_median * scatter() / deviations_in_the_spread /
               std::sqrt(static_cast<double>(ratios_.size()));
    }

    std::vector<Real> ratios_;
    std::size_t rows_;
    Real median_ = 0;
    double spread_ = 0;
};

} // namespace edgeproof::conformance::convention_rule

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/causes/convention.hpp"
#include "edgeproof/precision/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::conformance {

/// Another interpretation of questions.
struct Reading {
    std::string name; ///< of the cause (scene_mistakes.hpp)
    std::string relation;
    std::string hint;
    /// Changes the contact to that interpretation; false if this does not change it. Null: the
    /// contact is as in the question.
    std::function<bool(scene::Scene&)> contact = {};
    /// Changes the place of a question of that contact. Null: places are as in the question.
    std::function<bool(Question&, const scene::Scene&)> place = {};
    int length_power = 0; ///< the value is multiplied by this power of a + b
};

/// Returns the references of the questions listed (by index) in that interpretation; nothing for
/// those that it does not change or that have no value other than 0.
[[nodiscard]] std::vector<std::optional<Real>>
values_read_otherwise(const Answers& answers, const Agreements& agreements, const Reading& reading,
                      const std::vector<std::size_t>& which, const ReferenceOptions& options);

/// Checks if the answers listed (by index) would be right with another interpretation of the
/// numbers in their questions: degrees for radians, a width for a half-width, a diameter for a
/// radius, x for u, the modulus of one body for the composite one, the constant of the gap for that
/// of the slope, the sign of a force; or a mean pressure given instead of a force. Each quantity is
/// checked separately.
[[nodiscard]] std::vector<Convention> infer_readings(const Answers& answers,
                                                     const Agreements& agreements,
                                                     const std::vector<std::size_t>& failing,
                                                     ReferenceOptions options);

/// Checks if answers that miss the target are in single precision, or were written with few digits.
/// Each quantity is checked separately.
[[nodiscard]] std::vector<Convention> infer_precision_loss(const Answers& answers,
                                                           const Agreements& agreements);

/// Checks if answers lose digits as a distance decreases: u, the distance from the other edge, from
/// a knot, or of an edge from a knot. The digits of nearly all rows of a quantity must follow a
/// line whose value at the distance a + b is the number of digits of binary64 or binary32, and the
/// errors must scatter as those of rounding do. The rows explained are in `which`.
[[nodiscard]] std::vector<Convention> infer_cancellation(const Answers& answers,
                                                         const Agreements& agreements);

/// A failing row: the ratio of the answer to the reference, and to the reference at the other edge.
struct FailingRow {
    std::size_t question;
    Real ratio;
    std::optional<Real> mirrored;
};

/// Checks if the answers are the references, at the same or at the other edge, times one number
/// other than 1. The number is the median ratio; its scatter determines which named factors are
/// possible. The nearest of these is reported, and the others are listed. `named`: only a factor
/// with a name; else any.
[[nodiscard]] std::optional<Convention>
infer_factor(const std::string& of, const std::vector<FailingRow>& rows, bool named);

} // namespace edgeproof::conformance

/// The rules for accepting a convention (convention.hpp) of any kind. The agreement of answers with
/// a convention is measured in digits. The scatter of the answers determines the digits required:
/// answers of three digits need to agree to three.
namespace edgeproof::conformance::convention_rule {

inline constexpr std::size_t least_rows = 3;
inline constexpr double least_share = 0.9;
inline constexpr unsigned most_digits = 40;
/// Values that agree to this number of digits are regarded as equal.
inline constexpr double same_digits = 6;
/// Nine rows of ten must agree to 3 %: larger scatter would hide the cause.
inline constexpr double least_digits = 1.5;
/// A convention must leave less than a quarter of the error without it.
inline constexpr double least_gain = 0.6;
/// Conventions whose errors are within a quarter of the best are not distinguished.
inline constexpr double as_good = 0.1;
/// A constant factor, which is fitted, always agrees as well as a reading that it includes. It is
/// listed next to the reading if it agrees better by 5 %.
inline constexpr double barely_better = 0.02;

/// True if this number of rows suffices to explain the failing ones.
[[nodiscard]] inline bool enough(std::size_t rows, std::size_t failing) {
    return rows >= least_rows &&
           static_cast<double>(rows) >= least_share * static_cast<double>(failing);
}

/// The number of digits to which the two agree, at most `most_digits`.
[[nodiscard]] inline double digits_between(const Real& value, const Real& other) {
    const Real off = abs(Real(value / other - 1));
    return off == 0 ? most_digits
                    : std::clamp(-Real(log10(off)).convert_to<double>(), 0.0,
                                 static_cast<double>(most_digits));
}

/// The digits that at least nine of ten rows have; 0 without rows.
[[nodiscard]] inline double held_by_most(std::vector<double> digits) {
    if (digits.empty()) {
        return 0;
    }
    std::sort(digits.begin(), digits.end());
    return digits[static_cast<std::size_t>((1 - least_share) * static_cast<double>(digits.size()))];
}

/// The digits required of a single row for a convention that most rows follow to `held` digits: one
/// row in ten may scatter up to three times as much as the others.
[[nodiscard]] inline double follows_from(double held) {
    constexpr double three_times = 0.5;
    return std::min(same_digits, held - three_times);
}

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

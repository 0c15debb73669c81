// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

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

} // namespace edgeproof::conformance::convention_rule

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// When a convention counts (convention.hpp), whatever kind it is of. What answers and a convention
/// agree to is measured in digits, and the scatter of the answers themselves sets how many are
/// asked for: an answer of three digits is held to three.
namespace edgeproof::conformance::convention_rule {

inline constexpr std::size_t least_rows = 3;
inline constexpr double least_share = 0.9;
inline constexpr unsigned most_digits = 40;
/// What agrees to so many digits is the same.
inline constexpr double same_digits = 6;
/// Nine rows of ten agree to 3 %: scatter beyond that hides what is behind it.
inline constexpr double least_digits = 1.5;
/// A convention leaves less than a quarter of what is off without it.
inline constexpr double least_gain = 0.6;
/// Conventions that leave as little as the best, to a quarter, are not told apart.
inline constexpr double as_good = 0.1;

/// So many rows of so many that fail.
[[nodiscard]] inline bool enough(std::size_t rows, std::size_t failing) {
    return rows >= least_rows &&
           static_cast<double>(rows) >= least_share * static_cast<double>(failing);
}

/// To which the two agree, at most `most_digits`.
[[nodiscard]] inline double digits_between(const Real& value, const Real& other) {
    const Real off = abs(Real(value / other - 1));
    return off == 0 ? most_digits
                    : std::clamp(-Real(log10(off)).convert_to<double>(), 0.0,
                                 static_cast<double>(most_digits));
}

/// The digits that all rows but a tenth of them have; 0 for none.
[[nodiscard]] inline double held_by_most(std::vector<double> digits) {
    if (digits.empty()) {
        return 0;
    }
    std::sort(digits.begin(), digits.end());
    return digits[static_cast<std::size_t>((1 - least_share) * static_cast<double>(digits.size()))];
}

/// The digits at which a single row follows a convention that most rows hold to `held` digits: of
/// scatter, one row in ten has up to three times what the others have.
[[nodiscard]] inline double follows_from(double held) {
    constexpr double three_times = 0.5;
    return std::min(same_digits, held - three_times);
}

} // namespace edgeproof::conformance::convention_rule

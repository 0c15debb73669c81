// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <cstddef>

/// When a convention counts (convention.hpp), whatever kind it is of.
namespace edgeproof::conformance::convention_rule {

inline constexpr std::size_t least_rows = 3;
inline constexpr double least_share = 0.9;
inline constexpr double least_digits = 6;
inline constexpr unsigned most_digits = 40;

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

} // namespace edgeproof::conformance::convention_rule

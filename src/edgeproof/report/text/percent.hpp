// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <string>

namespace edgeproof::report {

/// Returns a tolerance as a reader writes it: "1 %" for 1/100 and 0.01. Exact: a number that is not
/// rational, or has no short decimal, is returned as it was given.
[[nodiscard]] inline std::string in_percent(const formula::Exact& tolerance) {
    constexpr std::size_t longest = 12;
    if (!tolerance.is_rational()) {
        return tolerance.text();
    }
    const std::string percent = exact_text(Rational(tolerance.rational() * 100));
    return percent.size() > longest || percent.find_first_of("/e") != std::string::npos
               ? tolerance.text()
               : percent + " %";
}

} // namespace edgeproof::report

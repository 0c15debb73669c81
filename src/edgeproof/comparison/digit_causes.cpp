// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/digit_causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::comparison {
namespace {

constexpr int most_rounded_digits = 9;
constexpr double half_unit = 0.51; ///< of the last digit: what binary64 adds is little
constexpr double beside_edge = 0.02;
constexpr double units_of_binary32 = 16;

/// All errors that count are within `allowed` of a node.
template <class Allowed>
bool explains(const AlignedResult& data, const ExactContact& exact, const Allowed& allowed) {
    return std::ranges::all_of(data.nodes, [&](const Node& node) {
        const bool counts = node.exact.p && node.exact.u() > beside_edge * exact.length();
        return !counts || std::abs(node.error) <= std::max(allowed(node), node.rounding);
    });
}

} // namespace

std::optional<Cause> cause_in_digits(const ResultTable& table, const AlignedResult& data,
                                     const ExactContact& exact) {
    const CarriedDigits& digits = table.p_digits;
    const double factor = table.p_factor;
    const auto significant_unit = [&](const Node& node) {
        const double p = std::abs(node.p / factor);
        const double leading = p > 0 ? std::floor(std::log10(p * (1 + 1e-15))) : -300;
        return half_unit * factor * std::pow(10.0, leading - digits.significant + 1);
    };
    const auto decimal_unit = [&](const Node&) {
        return half_unit * factor * std::pow(10.0, -digits.decimals);
    };
    if (digits.significant <= most_rounded_digits && explains(data, exact, significant_unit)) {
        return Cause{"rounded-digits",
                     fmt::format("p is rounded to {} digits", digits.significant),
                     1,
                     0,
                     {}};
    }
    if (!digits.exponents && digits.significant <= most_rounded_digits &&
        explains(data, exact, decimal_unit)) {
        return Cause{"rounded-digits",
                     fmt::format("p is rounded to {} decimals", digits.decimals),
                     1,
                     0,
                     {}};
    }
    const double single = units_of_binary32 * std::ldexp(exact.scale().value, -24);
    if (digits.binary32 && explains(data, exact, [single](const Node&) { return single; })) {
        return Cause{"binary32", "p is of binary32 numbers, about 7 digits", 1, 0, {}};
    }
    return {};
}

} // namespace edgeproof::comparison

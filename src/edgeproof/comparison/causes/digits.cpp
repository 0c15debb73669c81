// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::comparison {
namespace {

constexpr int most_rounded_digits = 9;
constexpr double half_unit = 0.51; ///< of the last digit, with a little for binary64
constexpr double near_edge_share = 0.02;
constexpr double units_of_binary32 = 16;
/// Rounding errors are uniformly distributed, with an rms of 1/sqrt(3) of the largest; the data's
/// own noise, which is smaller, adds to them.
constexpr double rms_with_noise = 0.65;
constexpr double largest_with_noise = 2;

/// True if rounding by `allowed` at each node explains all errors that count, those of pressures
/// outside the contact, too.
template <class Allowed>
bool rounding_explains(const AlignedResult& data, const ExactContact& exact,
                       const Allowed& allowed) {
    double largest = 0;
    double squares = 0;
    std::size_t n = 0;
    for (const Node& node : data.nodes) {
        if (node.p.exact && std::abs(node.place.u()) > near_edge_share * exact.length()) {
            const double part = std::abs(node.p.error) / std::max(allowed(node), node.p.rounding);
            largest = std::max(largest, part);
            squares += part * part;
            ++n;
        }
    }
    return largest <= 1 || (largest <= largest_with_noise &&
                            squares <= rms_with_noise * rms_with_noise * static_cast<double>(n));
}

} // namespace

std::optional<Cause> cause_in_digits(const ResultTable& table, const AlignedResult& data,
                                     const ExactContact& exact) {
    const CarriedDigits& digits = table.p_digits;
    const double factor = table.p_factor;
    const auto significant_unit = [&](const Node& node) {
        const double p = std::abs(node.p.data / factor);
        const double leading = p > 0 ? std::floor(std::log10(p * (1 + 1e-15))) : -300;
        return half_unit * factor * std::pow(10.0, leading - digits.significant + 1);
    };
    const auto decimal_unit = [&](const Node&) {
        return half_unit * factor * std::pow(10.0, -digits.decimals);
    };
    const bool few = digits.significant <= most_rounded_digits;
    if (few && rounding_explains(data, exact, significant_unit)) {
        return Cause{fmt::format("rounded-to-{}", digits.significant),
                     fmt::format("p is rounded to {} digits", digits.significant)};
    }
    if (few && !digits.exponents && rounding_explains(data, exact, decimal_unit)) {
        return Cause{fmt::format("rounded-to-{}-decimals", digits.decimals),
                     fmt::format("p is rounded to {} decimals", digits.decimals)};
    }
    const double single = units_of_binary32 * std::ldexp(exact.scale().value, -24);
    if (digits.binary32 &&
        rounding_explains(data, exact, [single](const Node&) { return single; })) {
        return Cause{"binary32", "p consists of binary32 numbers, about 7 digits"};
    }
    return {};
}

} // namespace edgeproof::comparison

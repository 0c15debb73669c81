// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/double_word/double_word.hpp"

#include <array>
#include <bit>
#include <cstdint>

namespace edgeproof {

/// Logarithms of 128 numbers c, each of 11 bits, so that c m is within 2^-7 of 1 for an m whose
/// first 7 bits are the number's index; and ln 2. Enclosed by Arb.
struct LogarithmTable {
    struct Entry {
        double reciprocal;    ///< c
        DoubleWord logarithm; ///< -ln c
    };
    std::array<Entry, 128> entries;
    DoubleWord ln2;
    DoubleWord third;

    [[nodiscard]] static const LogarithmTable& get();
};

namespace double_word {

/// 2 artanh(s) for |s| <= 2^-7: 2 s (1 + s^2/3 + s^4/5 + ...), of which s^14/15 and on are below
/// s^12/10 * 2^-14 in sum.
[[nodiscard]] inline DoubleWord twice_artanh(const DoubleWord& s, const DoubleWord& third) {
    const DoubleWord q = s * s;
    const double h = q.high;
    // What follows s^2/3, in binary64: 9 roundings, each of 2^-53, and the part of q beyond h.
    const double tail =
        h * h * (1.0 / 5 + h * (1.0 / 7 + h * (1.0 / 9 + h * (1.0 / 11 + h * (1.0 / 13)))));
    const double h2 = h * h;
    // (Where these underflow, the slack of the sum with 1 is larger by far.)
    const double error = 0x1p-48 * tail + h2 * h2 * h2 * h * (1.0 / 14) + q.radius * (h + q.radius);
    const DoubleWord sum = (q * third + DoubleWord{tail, 0, error}) + DoubleWord{1, 0, 0};
    return scaled(s * sum, 2);
}

} // namespace double_word

/// ln(1 + y) for y > 0 between 2^-520 and 2^520, well known; its radius is 2^-78 of it, or less,
/// and what that of y adds.
[[nodiscard]] inline DoubleWord log1p(const DoubleWord& y, const LogarithmTable& table) {
    if (y.high < 0x1p-6) {
        return double_word::twice_artanh(y / (y + DoubleWord{2, 0, 0}), table.third);
    }
    DoubleWord z = y + DoubleWord{1, 0, 0};
    const auto bits = std::bit_cast<std::uint64_t>(z.high);
    const int exponent = static_cast<int>(bits >> 52U) - 1023;
    z = scaled(z, std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52U));
    const auto& entry = table.entries[(bits >> 45U) & 127U];
    // c z - 1: the product's high part is beside 1, so that the difference is exact. What is
    // rounded is below 2^-52 in size, twice.
    const double product = z.high * entry.reciprocal;
    const double error = std::fma(z.high, entry.reciprocal, -product);
    const auto rest = double_word::exact_sum(product - 1, std::fma(z.low, entry.reciprocal, error));
    const DoubleWord r{rest.sum, rest.error, entry.reciprocal * z.radius + 4 * double_word::unit};
    const DoubleWord series = double_word::twice_artanh(r / (r + DoubleWord{2, 0, 0}), table.third);
    const DoubleWord power = DoubleWord{static_cast<double>(exponent), 0, 0} * table.ln2;
    return (power + entry.logarithm) + series;
}

} // namespace edgeproof

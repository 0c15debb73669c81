// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgeproof {

/// Logarithms of 128 numbers c of 11 bits, such that c m is within 2^-7 of 1 for every m whose
/// first 7 bits are the index of c, and ln 2 (docs/double-words.md, lemma 4). Enclosed by Arb.
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

/// Returns 2 artanh(s) = 2 s (1 + s^2/3 + s^4/5 + ...) (DLMF 4.38.5) for |s| <= 2^-7; the terms
/// from s^14/15 on are below s^14/14 in sum (docs/double-words.md, lemma 4).
[[nodiscard]] inline DoubleWord twice_artanh(const DoubleWord& s, const DoubleWord& third) {
    const DoubleWord q = s * s;
    const double h = q.high;
    // The terms after s^2/3 in binary64: 9 roundings, each of 2^-53, and the part of q that is not
    // in h.
    const double tail =
        h * h * (1.0 / 5 + h * (1.0 / 7 + h * (1.0 / 9 + h * (1.0 / 11 + h * (1.0 / 13)))));
    const double h2 = h * h;
    // (Where these underflow, the slack of the sum with 1 is much larger.)
    const double error = 0x1p-48 * tail + h2 * h2 * h2 * h * (1.0 / 14) + q.radius * (h + q.radius);
    const DoubleWord sum = (q * third + DoubleWord{tail, 0, error}) + DoubleWord{1, 0, 0};
    return scaled(s * sum, 2);
}

} // namespace double_word

/// Returns ln(1 + y) for y between 2^-520 and 2^520 with a radius of at most 2^-10 of y. The radius
/// of the result is at most 2^-78 of it, plus the effect of the radius of y (docs/double-words.md,
/// lemma 4).
[[nodiscard]] inline DoubleWord log1p(const DoubleWord& y, const LogarithmTable& table) {
    if (y.high < 0x1p-6) {
        return double_word::twice_artanh(y / (y + DoubleWord{2, 0, 0}), table.third);
    }
    DoubleWord z = y + DoubleWord{1, 0, 0};
    const auto bits = std::bit_cast<std::uint64_t>(z.high);
    const int exponent = static_cast<int>(bits >> 52U) - 1023;
    z = scaled(z, std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52U));
    const auto& entry = table.entries[(bits >> 45U) & 127U];
    // c z - 1: the high part of the product is close to 1, so that the difference is exact. Two
    // numbers below 2^-52 in size are rounded.
    const double product = z.high * entry.reciprocal;
    const double error = std::fma(z.high, entry.reciprocal, -product);
    const auto rest = double_word::exact_sum(product - 1, std::fma(z.low, entry.reciprocal, error));
    const DoubleWord r{rest.sum, rest.error, entry.reciprocal * z.radius + 4 * double_word::unit};
    const DoubleWord series = double_word::twice_artanh(r / (r + DoubleWord{2, 0, 0}), table.third);
    const DoubleWord power = DoubleWord{static_cast<double>(exponent), 0, 0} * table.ln2;
    return (power + entry.logarithm) + series;
}

/// A power series, the sum of a_k x^k with |a_k| <= M for all k, over 0 <= x <= 1/2 in double
/// words, by Taylor polynomials about 17 centres, of which the nearest is at most 2^-6 away
/// (docs/double-words.md, lemma 7). The first coefficients of each are double words, the others
/// binary64.
class PiecewiseSeries {
public:
    /// @param a at least 400 coefficients
    /// @param most M, valid for all coefficients, including those not given
    PiecewiseSeries(const std::vector<Ball>& a, long most);

    /// Returns the sum for 0 <= x <= 1/2; unknown elsewhere, and where the radius of x is 2^-60 or
    /// more.
    [[nodiscard]] DoubleWord operator()(const DoubleWord& x) const {
        if (!(x.high >= 0 && x.high <= 0.5 && x.radius < 0x1p-60)) {
            return double_word::unknown();
        }
        // The sum may round up to the next cell: the coefficients allow for it (`reach`).
        const auto i =
            static_cast<std::size_t>(x.high * cells + 0.5); // NOLINT(bugprone-incorrect-roundings)
        const Cell& cell = cells_[i];
        const DoubleWord t = x - DoubleWord{static_cast<double>(i) / cells, 0, 0};
        double tail = cell.others[terms - long_terms - 1];
        for (std::size_t k = terms - long_terms - 1; k-- > 0;) {
            tail = tail * t.high + cell.others[k];
        }
        DoubleWord sum{tail, 0, cell.error};
        for (std::size_t k = long_terms; k-- > 0;) {
            sum = sum * t + cell.first[k];
        }
        return sum;
    }

private:
    static constexpr int cells = 32; ///< for a unit of x
    static constexpr std::size_t long_terms = 10;
    static constexpr std::size_t terms = 22;
    struct Cell {
        std::array<DoubleWord, long_terms> first;
        std::array<double, terms - long_terms> others;
        double error; ///< of the sum of the others: roundoff and remainder
    };
    std::array<Cell, cells / 2 + 1> cells_;
};

} // namespace edgeproof

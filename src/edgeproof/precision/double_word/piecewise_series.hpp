// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/double_word/double_word.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace edgeproof {

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

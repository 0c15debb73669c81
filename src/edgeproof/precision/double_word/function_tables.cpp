// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/double_word/function_tables.hpp"

#include "edgeproof/precision/double_word/double_word.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace edgeproof {

namespace {

/// f^(j)(c)/j!, the sum of binomial(k, j) a_k c^(k-j) (docs/double-words.md, lemma 7).
Ball taylor_coefficient(const std::vector<Ball>& a, long most, long c, long cells, long j) {
    const long bits = a.front().bits();
    Ball weight(1, bits);
    Ball sum = a[static_cast<std::size_t>(j)];
    for (long k = j + 1; k < static_cast<long>(a.size()); ++k) {
        weight = weight * (c * k) / (cells * (k - j));
        sum += weight * a[static_cast<std::size_t>(k)];
    }
    // The next weight, and those after it, which decrease at least as fast as a geometric series.
    const long n = static_cast<long>(a.size());
    const Ball ratio = Ball(c * n, bits) / (cells * (n - j));
    const Ball rest = weight * ratio * most / (1 - ratio);
    arb_add_error(sum.data(), rest.data());
    return sum;
}

double above(const Ball& x) {
    return std::nextafter(abs(x).upper().convert_to<double>(),
                          std::numeric_limits<double>::infinity());
}

} // namespace

// docs/double-words.md, lemma 4.
const LogarithmTable& LogarithmTable::get() {
    static const LogarithmTable table = [] {
        constexpr long bits = 256;
        LogarithmTable t{};
        for (int i = 0; i < 128; ++i) {
            const double middle = 1 + (i + 0.5) / 128;
            auto& entry = t.entries[static_cast<std::size_t>(i)];
            const long whole = std::lround(1024 / middle);
            entry.reciprocal = static_cast<double>(whole) / 1024;
            entry.logarithm = to_double_word(-log(Ball(Rational(whole, 1024), bits)));
        }
        t.ln2 = to_double_word(log(Ball(2, bits)));
        t.third = to_double_word(Ball(Rational(1, 3), bits));
        return t;
    }();
    return table;
}

PiecewiseSeries::PiecewiseSeries(const std::vector<Ball>& a, long most) {
    const long bits = a.front().bits();
    constexpr std::int64_t one = std::int64_t{1} << 40;
    // The range of t, including the rounding of x to a cell.
    const Ball reach = Ball(Rational(one + 1, one), bits) / (2L * cells);
    for (long c = 0; c <= cells / 2; ++c) {
        Cell& cell = cells_[static_cast<std::size_t>(c)];
        Ball power(1, bits);
        Ball size(0, bits); // of the others, at the reach
        for (std::size_t j = 0; j < terms; ++j) {
            const Ball f = taylor_coefficient(a, most, c, cells, static_cast<long>(j));
            if (j < long_terms) {
                cell.first[j] = to_double_word(f);
                continue;
            }
            cell.others[j - long_terms] = f.midpoint().convert_to<double>();
            size += abs(f) * power;
            power *= reach;
        }
        // |f^(j)(c)/j!| <= M/(1 - c)^(j+1): the remainder is a geometric series.
        const Ball inverse = Ball(cells, bits) / (cells - c);
        const Ball q = inverse * reach;
        const Ball cut = most * pow_int(inverse, static_cast<long>(long_terms) + 1) *
                         pow_int(q, static_cast<long>(terms - long_terms)) / (1 - q);
        // 2^-46 covers 3 roundings for each term, the low part and radius of t, and the rounding of
        // the coefficients.
        cell.error = 2 * above(size) * 0x1p-47 + above(cut);
    }
}

} // namespace edgeproof

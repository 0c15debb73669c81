// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace edgeproof {

/// A number in double-word arithmetic with its bound: the number differs from high + low by at most
/// `radius`, where high is the binary64 nearest to high + low. If the radius is not finite, nothing
/// is known. An operation takes about 20 binary64 operations, where a ball of 128 bits takes 100
/// ns.
///
/// The errors of single operations are bounded in joldes2017 (sum, product, quotient) and
/// lefevre2023 (square root), in units of 2^-106 of the result: 3.1, 6, 15.1 and 3.2; each bound
/// used here is larger by a unit or more. The radii of the arguments add their first-order effect,
/// and products of radii (docs/double-words.md, lemma 1). A radius is computed in binary64, and
/// each operation makes it too small by about 2^-50 of itself; nearest_binary64 allows for up to
/// 10^6 operations in sequence (lemma 2).
///
/// This holds if nothing underflows or overflows (callers keep all numbers other than 0 between
/// 2^-900 and 2^900), if numbers are rounded to nearest, and if the compiler does not fuse a
/// product with a sum: edgeproof::precision compiles every source that links it with
/// -ffp-contract=off.
struct DoubleWord {
    double high = 0;
    double low = 0;
    double radius = 0;
};

namespace double_word {

constexpr double unit = 0x1p-106;

/// Returns high + low of a sum of two words, |a| >= |b| or a = 0 (Fast2Sum, joldes2017).
[[nodiscard]] inline DoubleWord ordered_sum(double a, double b, double radius) {
    const double s = a + b;
    return {s, b - (s - a), radius};
}

struct ExactSum {
    double sum;
    double error;
};
/// Returns the sum and its rounding error (2Sum, joldes2017).
[[nodiscard]] inline ExactSum exact_sum(double a, double b) {
    const double s = a + b;
    const double part = s - a;
    return {s, (a - (s - part)) + (b - part)};
}

/// True if the radius is at most 2^-10 of a number that is not zero: then the first-order bounds of
/// a quotient and of a root are valid with a factor of 1.003. False for NaN.
[[nodiscard]] inline bool well_known(const DoubleWord& x) {
    return x.radius <= 0x1p-10 * std::fabs(x.high) && x.high != 0;
}
[[nodiscard]] inline DoubleWord unknown() {
    return {1, 0, std::numeric_limits<double>::infinity()};
}
/// Returns an upper bound of the size of all numbers of x.
[[nodiscard]] inline double most(const DoubleWord& x) {
    return 1.01 * (std::fabs(x.high) + x.radius);
}
/// Returns 0 with a radius that includes all numbers of x and their negatives.
[[nodiscard]] inline DoubleWord about_zero(const DoubleWord& x) { return {0, 0, most(x)}; }

} // namespace double_word

[[nodiscard]] inline DoubleWord operator-(const DoubleWord& x) {
    return {-x.high, -x.low, x.radius};
}
/// AccurateDWPlusDW (joldes2017; docs/double-words.md, lemma 1).
[[nodiscard]] inline DoubleWord operator+(const DoubleWord& x, const DoubleWord& y) {
    const auto high = double_word::exact_sum(x.high, y.high);
    const auto low = double_word::exact_sum(x.low, y.low);
    const DoubleWord v = double_word::ordered_sum(high.sum, high.error + low.sum, 0);
    DoubleWord z = double_word::ordered_sum(v.high, low.error + v.low, 0);
    z.radius = x.radius + y.radius + 5 * double_word::unit * std::fabs(z.high);
    return z;
}
[[nodiscard]] inline DoubleWord operator-(const DoubleWord& x, const DoubleWord& y) {
    return x + (-y);
}
/// DWTimesDW2 (joldes2017).
[[nodiscard]] inline DoubleWord operator*(const DoubleWord& x, const DoubleWord& y) {
    const double product = x.high * y.high;
    const double error = std::fma(x.high, y.high, -product);
    const double cross = std::fma(x.low, y.high, x.high * y.low);
    DoubleWord z = double_word::ordered_sum(product, error + cross, 0);
    z.radius = std::fabs(x.high) * y.radius + std::fabs(y.high) * x.radius + x.radius * y.radius +
               8 * double_word::unit * std::fabs(z.high);
    return z;
}
/// DWDivDW2 (joldes2017). Unknown where the divisor may be zero.
[[nodiscard]] inline DoubleWord operator/(const DoubleWord& x, const DoubleWord& y) {
    if (!double_word::well_known(y)) {
        return double_word::unknown();
    }
    const double high = x.high / y.high;
    // r = y times high by DWTimesFP.
    const double product = y.high * high;
    const double error = std::fma(y.high, high, -product);
    const DoubleWord r = double_word::ordered_sum(product, std::fma(y.low, high, error), 0);
    const double rest = (x.high - r.high) + (x.low - r.low);
    DoubleWord z = double_word::ordered_sum(high, rest / y.high, 0);
    const double size = std::fabs(z.high);
    z.radius =
        1.003 * ((x.radius + size * y.radius) / std::fabs(y.high)) + 18 * double_word::unit * size;
    return z;
}
/// SQRTDWtoDW (lefevre2023). Unknown where x may be zero or negative.
[[nodiscard]] inline DoubleWord sqrt(const DoubleWord& x) {
    if (!double_word::well_known(x) || !(x.high > 0)) {
        return double_word::unknown();
    }
    const double high = std::sqrt(x.high);
    const double rest = x.low + std::fma(-high, high, x.high);
    DoubleWord z = double_word::ordered_sum(high, rest / (2 * high), 0);
    z.radius = 0.502 * (x.radius / high) + 5 * double_word::unit * high;
    return z;
}
[[nodiscard]] inline DoubleWord abs(const DoubleWord& x) { return x.high < 0 ? -x : x; }
/// Returns x 2^k; `power` is 2^k.
[[nodiscard]] inline DoubleWord scaled(const DoubleWord& x, double power) {
    return {x.high * power, x.low * power, x.radius * power};
}

/// Returns the binary64 to which all numbers of x round (ties to even); nothing if there are
/// several (docs/double-words.md, lemma 3).
[[nodiscard]] inline std::optional<double> nearest_binary64(const DoubleWord& x) {
    if (std::isinf(x.high) && x.radius == 0) {
        return x.high; // exactly infinite
    }
    // 1 % covers the roundoff of the radii, 2^-105 that of the two sums below.
    const double radius = 1.01 * x.radius + 2 * double_word::unit * std::fabs(x.high);
    const double above = x.high + (x.low + radius);
    const double below = x.high + (x.low - radius);
    return above == below ? std::optional<double>(above) : std::nullopt;
}

/// Returns a double word that includes all numbers of the ball; unknown if the ball is not finite,
/// or if its midpoint is not 0 and its size is not between 2^-900 and 2^900.
[[nodiscard]] DoubleWord to_double_word(const Ball& x);
/// Returns a number as a double word; the radius is the remainder after two words.
[[nodiscard]] DoubleWord to_double_word(const Real& x);

/// A number in two parts, so that a difference with a number close to it is accurate
/// (docs/double-words.md, lemma 5).
struct PreciseWord {
    DoubleWord first; ///< without a radius, if known
    DoubleWord rest;  ///< below 2^-106 of `first`
};
/// For a ball with more bits than one double word; unknown as above.
[[nodiscard]] PreciseWord to_precise_word(const Ball& x);

[[nodiscard]] inline DoubleWord operator-(const DoubleWord& x, const PreciseWord& y) {
    return (x - y.first) - y.rest;
}
[[nodiscard]] inline DoubleWord operator-(const PreciseWord& x, const DoubleWord& y) {
    return -(y - x);
}

} // namespace edgeproof

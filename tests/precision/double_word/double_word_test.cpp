// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/double_word/double_word.hpp"
#include "edgeproof/precision/double_word/function_tables.hpp"
#include "edgeproof/precision/split_mix.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace edgeproof;

namespace {

constexpr long word_bits = 400;

Ball exactly(const DoubleWord& x) {
    return Ball(Rational(x.high), word_bits) + Ball(Rational(x.low), word_bits);
}
/// Returns an exact number in the word: its middle plus `side` times its radius.
Ball inside(const DoubleWord& x, int side) {
    return exactly(x) + Ball(Rational(x.radius), word_bits) * Ball(Rational(side, 1), word_bits);
}
/// True if the word contains the number; its radius may be too small by a relative 2^-50 for each
/// operation.
bool holds(const DoubleWord& x, const Ball& number) {
    const Rational radius = Rational(x.radius) * (1 + Rational(1, 1ULL << 47U));
    const Ball distance = abs(exactly(x) - number);
    return !certainly_positive(distance - Ball(radius, word_bits));
}

struct Drawn {
    SplitMix64 dice{20'261'123};
    double number(int exponents) {
        const double m = 1 + static_cast<double>(dice.next() >> 12U) * 0x1p-52;
        const int e =
            static_cast<int>(dice.below(2 * static_cast<std::size_t>(exponents) + 1)) - exponents;
        return std::ldexp(dice.below(2) == 0 ? m : -m, e);
    }
    /// Returns a word with a low part of any size, and a zero, small or large radius.
    DoubleWord word(int exponents) {
        const double high = number(exponents);
        const double low =
            dice.below(8) == 0
                ? 0
                : high * number(0) * std::ldexp(0.24, -52 - static_cast<int>(dice.below(60)));
        const double radius =
            dice.below(3) == 0
                ? 0
                : std::fabs(high) * std::ldexp(1, -60 - static_cast<int>(dice.below(60)));
        return double_word::ordered_sum(high, low, radius);
    }
};

constexpr int drawn = 20'000;

/// Returns x x minus the binary64 nearest to it: 0, unless the compiler joins the product and the
/// difference in one instruction.
#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("fma")]]
#endif
double
rest_of_square(double x, double rounded) {
    return x * x - rounded;
}

} // namespace

TEST_CASE("products and sums are not fused, on a processor that could do so") {
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("fma") == 0) {
        return;
    }
#endif
    // The square has 61 bits. (Volatile, so that the compiler does not compute it.)
    const volatile double x = 1 + 0x1p-30;
    CHECK(rest_of_square(x, 1 + 0x1p-29) == 0);
    CHECK(std::fma(x, x, -(1 + 0x1p-29)) == 0x1p-60);
}

TEST_CASE("sums, products, quotients and roots of double words hold those of all their numbers") {
    Drawn draw;
    for (int i = 0; i < drawn; ++i) {
        const DoubleWord x = draw.word(60);
        // In every fourth pair the leading bits cancel.
        const DoubleWord y =
            i % 4 != 0
                ? draw.word(60)
                : double_word::ordered_sum(-x.high * (1 + 0x1p-52 * static_cast<double>(i % 7)),
                                           x.low * 0.37, x.radius);
        CAPTURE(i);
        for (const int side : {-1, 0, 1}) {
            const Ball p = inside(x, side);
            for (const int other : {-1, 1}) {
                const Ball q = inside(y, other);
                REQUIRE(holds(x + y, p + q));
                REQUIRE(holds(x - y, p - q));
                REQUIRE(holds(x * y, p * q));
                REQUIRE(holds(x / y, p / q));
            }
            const DoubleWord size = abs(x);
            REQUIRE(holds(sqrt(size), sqrt(abs(p))));
        }
        // The radii are not much larger than those of the arguments require.
        const double rel = x.radius / std::fabs(x.high) + y.radius / std::fabs(y.high) + 0x1p-100;
        const double product = std::fabs((x * y).high);
        REQUIRE((x * y).radius <= 1.1 * rel * product);
        REQUIRE((x / y).radius <= 1.1 * rel * std::fabs((x / y).high));
        REQUIRE(sqrt(abs(x)).radius <= rel * sqrt(abs(x)).high);
    }
}

TEST_CASE("ln(1 + y) of a double word holds that of all its numbers") {
    Drawn draw;
    const LogarithmTable& table = LogarithmTable::get();
    const auto check = [&](const DoubleWord& y) {
        const DoubleWord G = log1p(y, table);
        for (const int side : {-1, 0, 1}) {
            REQUIRE(holds(G, log1p(inside(y, side))));
        }
        const double added = y.radius / (1 + y.high);
        REQUIRE(G.radius <= 1.1 * added + 0x1p-78 * G.high);
        REQUIRE(G.radius >= 0.9 * added);
    };
    for (int i = 0; i < drawn; ++i) {
        CAPTURE(i);
        check(abs(draw.word(i % 2 == 0 ? 510 : 8)));
    }
    // Both sides of the change from one series to the other, and of the table's ends.
    for (const double y : {0x1p-6, 1.0, 3.0, 0x1p-510, 0x1p510}) {
        for (const double low : {-0x1p-60, 0.0, 0x1p-60}) {
            CAPTURE(y);
            check({y, y * low, 0});
            check({std::nextafter(y, 0.0), 0, 0});
        }
    }
    for (int i = 1; i < 256; ++i) {
        CAPTURE(i);
        check({i / 128.0, 0, 0});
        check({std::nextafter(i / 128.0, 0.0), 0, 0});
    }
}

TEST_CASE("the nearest binary64 of a double word: one, or none where there are several") {
    CHECK(nearest_binary64(DoubleWord{1, 0x1p-60, 0x1p-70}) == 1.0);
    CHECK(nearest_binary64(DoubleWord{1, 0x1p-53 - 0x1p-80, 0x1p-82}) == 1.0);
    CHECK_FALSE(nearest_binary64(DoubleWord{1, 0x1p-53 - 0x1p-80, 0x1p-79}));
    CHECK_FALSE(nearest_binary64(DoubleWord{1, 0x1p-53, 0})); // ties are decided elsewhere
    CHECK_FALSE(nearest_binary64(double_word::unknown()));
    CHECK_FALSE(nearest_binary64(DoubleWord{1, 0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST_CASE("the quotient by a double word that may be zero is unknown, and so is its root") {
    const DoubleWord zero{0x1p-30, 0, 0x1p-30};
    CHECK(std::isinf((DoubleWord{1, 0, 0} / zero).radius));
    CHECK(std::isinf(sqrt(zero).radius));
    CHECK(std::isinf(sqrt(DoubleWord{-1, 0, 0}).radius));
    CHECK_FALSE((DoubleWord{1, 0, 0} / DoubleWord{0, 0, 0}).radius < 1);
}

TEST_CASE("a ball as a double word") {
    const Ball third(Rational(1, 3), 128);
    const DoubleWord word = to_double_word(third);
    CHECK(holds(word, Ball(Rational(1, 3), word_bits)));
    CHECK(word.radius < 0x1p-105);
    CHECK(to_double_word(Ball(Rational(3, 4), 64)).radius == 0);
    CHECK(std::isinf(to_double_word(Ball(1, 64) / Ball(0, 64)).radius));
    CHECK(std::isinf(to_double_word(Ball(Rational(1), 64) / pow(Ball(10, 64), 400)).radius));
}

TEST_CASE("a number in two parts keeps the digits of a difference with a number close to it") {
    Drawn draw;
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(i);
        // A number of 180 bits, and the nearest binary64.
        const Ball number = sqrt(Ball(Rational(std::fabs(draw.number(90))), 180));
        const PreciseWord parts = to_precise_word(number);
        REQUIRE(std::fabs(parts.rest.high) <= 0x1p-106 * parts.first.high);
        double nearby = parts.first.high;
        for (int steps = i % 3; steps > 0; --steps) {
            nearby = std::nextafter(nearby, i % 2 == 0 ? 0 : 1e300);
        }
        const DoubleWord difference = DoubleWord{nearby, 0, 0} - parts;
        const Ball exact = Ball(Rational(nearby), word_bits) - number.with_bits(word_bits);
        // The word's radius includes that of the ball.
        REQUIRE(certainly_less(abs(exactly(difference) - exact) * Ball(Rational(99, 100), 64),
                               Ball(Rational(difference.radius), word_bits)));
        REQUIRE(difference.radius <= 0x1p-70 * std::fabs(difference.high));
        REQUIRE((parts - DoubleWord{nearby, 0, 0}).high == -difference.high);
    }
    const PreciseWord exact = to_precise_word(Ball(Rational(3, 8), 192));
    CHECK((DoubleWord{0.375, 0, 0} - exact).high == 0);
    CHECK((DoubleWord{0.375, 0, 0} - exact).radius == 0);
}

TEST_CASE("a power series in double words holds its sum: the geometric one, and the logarithm's") {
    std::vector<Ball> ones;
    std::vector<Ball> harmonic; // -ln(1 - x)/x
    for (long k = 0; k < 400; ++k) {
        ones.emplace_back(1, 256);
        harmonic.emplace_back(Rational(1, k + 1), 256);
    }
    const PiecewiseSeries geometric(ones, 1);
    const PiecewiseSeries logarithm(harmonic, 1);
    Drawn draw;
    for (int i = 0; i < drawn / 4; ++i) {
        CAPTURE(i);
        DoubleWord x = abs(draw.word(0));
        x = scaled(x, i % 8 == 0 ? 0x1p-30 : 0.25);
        if (x.radius >= 0x1p-61) {
            continue;
        }
        const DoubleWord f = geometric(x);
        for (const int side : {-1, 0, 1}) {
            const Ball at = inside(x, side);
            REQUIRE(holds(f, 1 / (1 - at)));
            REQUIRE(holds(logarithm(x), -log1p(-at) / at));
        }
        REQUIRE(f.radius <= 4.1 * x.radius + 0x1p-90);
    }
    for (const double x : {0.0, 0x1p-6, 0x1p-5, 3 * 0x1p-6, 0.484375, 0.5}) {
        CAPTURE(x);
        for (const double at : {x, std::nextafter(x, 0.0), std::nextafter(x, 0.5)}) {
            REQUIRE(holds(geometric({at, 0, 0}), 1 / (1 - Ball(Rational(at), word_bits))));
        }
    }
    CHECK(std::isinf(geometric({0.51, 0, 0}).radius));
    CHECK(std::isinf(geometric({-0.01, 0, 0}).radius));
    CHECK(std::isinf(geometric({0.1, 0, 0x1p-50}).radius));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/double_word/double_word_pressure.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/precision/split_mix.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

using namespace edgeproof::scenes;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

BallContact balls_of(const Contact& c, long bits = DoubleWordPressure::contact_bits) {
    return {c.profile, c.modulus, c.load, bits};
}
DoubleWordPressure words_of(const std::string& words) {
    const Contact c = contact_of(words);
    return {c.profile, balls_of(c)};
}

const std::vector<std::string> pressed{"power-law m=1 C=1/3 a=2",
                                       "power-law m=0 C=0.1 P=7",
                                       "flat-and-rounded t=1/2 R=30 P=1e-3",
                                       "tilted-wedge phi=1/10 alpha=1/11 a=1e9",
                                       "tilted-flat-and-rounded alpha=1/100 t=2/5 R=1 P=1/5",
                                       "power-law m=1/2 C=1/3 P=3",
                                       "power-law m=3/2 C=2 a=1/7",
                                       "power-law m=2 C=1 a=1",
                                       "power-law m=3 C=1e-5 P=1e3",
                                       "power-law m=9/2 C=0.2 a=5",
                                       "power-law m=10 C=0.2 P=1e-6",
                                       "power-law m=63/2 C=3 a=9/8"};

/// Compares drawn places by edges, knots, the apex and in between with balls.
void compare_with_balls(int draws) {
    SplitMix64 dice(41);
    const auto uniform = [&] { return static_cast<double>(dice.next() >> 11U) * 0x1p-53; };
    for (const std::string& words : pressed) {
        CAPTURE(words);
        const DoubleWordPressure pressure = words_of(words);
        const BallContact exact = balls_of(contact_of(words), 400);
        const double length = Ball(exact.a() + exact.b()).midpoint().convert_to<double>();
        std::vector<double> places;
        for (int i = 0; i < draws; ++i) {
            places.push_back(length * uniform());
            places.push_back(length * std::pow(10.0, -85 * uniform()));
        }
        for (const Ball& knot : exact.slope().knots) {
            const double at = Ball(exact.a() - knot).midpoint().convert_to<double>();
            double next = at;
            double last = at;
            for (int i = 0; i < 50; ++i) {
                places.push_back(next = std::nextafter(next, infinity));
                places.push_back(last = std::nextafter(last, 0));
            }
            for (int i = 0; i < 50; ++i) {
                places.push_back(at * (1 + std::pow(10.0, -16 * uniform())));
                places.push_back(at * (1 - std::pow(10.0, -16 * uniform())));
            }
        }
        double end = length;
        for (int i = 0; i < 50; ++i) {
            places.push_back(end = std::nextafter(end, 0));
        }
        std::size_t undecided = 0;
        for (const double u : places) {
            CAPTURE(u);
            if (!(u > 0 && u < length)) {
                continue;
            }
            const Ball p = exact.pressure(Edge::right, Exact::of(Rational(u)));
            const DoubleWord word = pressure.at(Edge::right, {u, 0, 0});
            if (std::isinf(word.high)) {
                CHECK_FALSE(p.is_finite()); // exactly on a corner
                continue;
            }
            if (!std::isfinite(word.radius)) {
                ++undecided;
                continue;
            }
            // The computed bound holds.
            const PrecisionScope scope(150);
            const Real off = abs(p.midpoint() - Real(word.high) - Real(word.low));
            CHECK(off <= Real(word.radius) * 1.01 + Real(word.high) * Real(0x1p-104));
            const auto nearest = nearest_binary64(word);
            undecided += nearest ? 0 : 1;
            CHECK((!nearest || nearest == nearest_binary64(p)));
        }
        CHECK(undecided <= 1);
    }
}

} // namespace

TEST_CASE("in double words: the binary64 of a ball, by edges, knots, the apex and in between") {
    compare_with_balls(150);
}

TEST_SUITE("slow") {
    TEST_CASE("in double words: the binary64 of a ball at 240,000 drawn places") {
        compare_with_balls(10'000);
    }
}

TEST_CASE("in double words: a bound that is made too small is caught by its ball") {
    // The radii are needed: without the uncertainty of the edges, places would be decided wrongly.
    const Contact c = contact_of(pressed[1]);
    const BallContact rough = balls_of(c, 64);
    const DoubleWordPressure pressure(c.profile, rough);
    const BallContact exact = balls_of(c, 400);
    SplitMix64 dice(7);
    std::size_t undecided = 0;
    std::size_t wrong = 0;
    for (int i = 0; i < 3000; ++i) {
        const double u = static_cast<double>(dice.next() >> 11U) * 0x1p-53;
        DoubleWord p = pressure.at(Edge::right, {u, 0, 0});
        const auto right = nearest_binary64(exact.pressure(Edge::right, Ball(Rational(u), 400)));
        const auto nearest = nearest_binary64(p);
        undecided += nearest ? 0 : 1;
        CHECK((!nearest || nearest == right));
        p.radius = 0;
        const auto claimed = nearest_binary64(p);
        wrong += claimed && claimed != right ? 1 : 0;
    }
    CHECK(undecided > 0);
    CHECK(wrong > 0);
}

TEST_CASE("in double words: a thread that rounds upwards uses another route") {
    const DoubleWordPressure hertz = words_of("power-law m=1 C=1 a=1");
    REQUIRE(hertz.nearest(Edge::right, 0.1));
    const int before = std::fegetround();
    REQUIRE(std::fesetround(FE_UPWARD) == 0);
    const auto p = hertz.nearest(Edge::right, 0.1);
    std::fesetround(before);
    CHECK_FALSE(p);
}

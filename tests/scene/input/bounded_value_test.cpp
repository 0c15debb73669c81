// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <sstream>

using namespace edgeproof::scenes;

namespace {

std::string streamed_value(const BoundedValue& x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

} // namespace

TEST_CASE("the bound printed with a value holds, and is as small as two digits allow") {
    std::mt19937_64 seeded(47);
    std::uniform_real_distribution<double> uniform(-60, 60);
    std::size_t complete = 0;
    for (int k = 0; k < 1500; ++k) {
        const PrecisionScope scope(80);
        const unsigned digits = 2 + static_cast<unsigned>(k) % 60;
        const Real middle = exp(Real(uniform(seeded))) * (k % 2 == 0 ? 1 : -1);
        const Ball ball = Ball::around(middle, ldexp(abs(middle), -150 - k % 80), 260);
        for (const Rounding mode : {Rounding::nearest, Rounding::down, Rounding::up}) {
            const scene::BoundedValue value{ball, true, "by hand"};
            const scene::PrintedValue p = printed(value, {digits, mode, true});
            if (!p.complete) {
                continue;
            }
            ++complete;
            const Rational text = parse_decimal(p.text);
            const Rational reach = Rational(ball.radius());
            const Rational off = abs(Rational(Rational(ball.midpoint()) - text)) + reach;
            const Rational bound = parse_decimal(p.bound);
            CAPTURE(p.text);
            CAPTURE(digits);
            CHECK(bound >= off);
            CHECK(bound <= off * Rational(1101, 1000));
        }
    }
    CHECK(complete > 3000);
}

// E* = R = a = 1: p = sqrt(1 - x^2)/2 (johnson1985), 0.3 at x = 4/5, 0.217944947177... at x = 9/10.
TEST_CASE("a value is printed with its bound and its route") {
    const std::string hertz = "power-law m=1 C=1 a=1 u=1/10";
    const SceneResult result = run_scene(made(hertz));
    CHECK(streamed_value(result.points()[0].at(Quantity::p)) ==
          "0.217945 +/- 5.3e-08 (closed-form)");
    CHECK(streamed_value(result.at(Quantity::a)) == "1.00000 +/- 0 (given)");
    CHECK(streamed_value({Ball(Rational(1, 3), 64), true, "given", Rational(1, 3)}) ==
          "0.333333 +/- 3.4e-07 (given)");
    const SceneResult estimate = run_scene(made(hertz + " route=barber-mossakovskii"));
    CHECK(streamed_value(estimate.points()[0].at(Quantity::p)) ==
          "0.217945 +/- 5.3e-08 (barber-mossakovskii (estimate))");
}

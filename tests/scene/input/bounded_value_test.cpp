// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

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
            CHECK(printed_text(value, {digits, mode, false}) == p.text);
        }
    }
    CHECK(complete > 3000);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/power_law_integral.hpp"

#include "edgeproof/precision/rounding/text.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using scenes::exact;

namespace {

constexpr long power_law_bits = 500;

Ball integral(const char* m, const Ball& q) {
    const Exact exponent = exact(m);
    return PowerLawIntegral(exponent, Ball(exponent.rational(), power_law_bits))(q,
                                                                                 (1 - q) * (1 + q));
}
Ball ball(const char* text) { return {parse_decimal(text), power_law_bits}; }

} // namespace

// Values at points are rows of tests/scene/values.txt and tests/oracles/hard-cases.txt.
TEST_CASE("the integral over a wide ball contains the values in it, and is not much wider") {
    for (const char* m : {"1/3", "8/5", "0.62500000000000000001", "51/2", "1001/3"}) {
        for (const char* at : {"0.2", "0.6", "0.95"}) {
            CAPTURE(m);
            CAPTURE(at);
            const Ball width = ball("0.01");
            const Ball low = integral(m, ball(at) - width);
            const Ball high = integral(m, ball(at) + width);
            const Ball over = integral(m, Ball::hull(ball(at) - width, ball(at) + width));
            CHECK(contains(over, low));
            CHECK(contains(over, high));
        }
    }
}

TEST_CASE("a ball around the apex contains the values at the apex and near it") {
    const Ball zero(0, power_law_bits);
    const Ball about = Ball::around(Real(0), pow(Real(10), -100), power_law_bits);
    for (const char* m : {"1/2", "2", "4", "9/2"}) {
        CAPTURE(m);
        CHECK(contains(integral(m, about), integral(m, zero)));
        CHECK(contains(integral(m, about), integral(m, ball("1e-101"))));
    }
    CHECK_FALSE(integral("0", about).is_finite());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/power_law_integral.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
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
bool narrow(const Ball& x) { return x.relative_accuracy_bits() > 400; }

} // namespace

// Integrated by parts by hand for m = 0 ... 4, with s/sqrt(s^2 - q^2) = d sqrt(s^2 - q^2)/ds and
// acosh.
TEST_CASE("the integral for m = 0 ... 4 by hand, from near the apex to near the edge") {
    for (const char* at : {"1e-30", "1/3", "0.49", "0.51", "0.9", "0.999999999999"}) {
        CAPTURE(at);
        const Ball q = ball(at);
        const Ball root = sqrt((1 - q) * (1 + q));
        const Ball zeroth = log((1 + root) / q);
        const Ball second = (root + q * q * zeroth) / 2;
        CHECK(overlaps(integral("0", q), zeroth));
        CHECK(overlaps(integral("1", q), root));
        CHECK(overlaps(integral("2", q), second));
        CHECK(overlaps(integral("3", q), root * (1 + 2 * q * q) / 3));
        CHECK(overlaps(integral("4", q), (root + 3 * q * q * second) / 4));
        for (const char* m : {"0", "1", "2", "3", "4"}) {
            CAPTURE(m);
            CHECK(narrow(integral(m, q)));
        }
    }
}

// The terms of the sum have the midpoint 0 there, whose size is no number.
TEST_CASE("the integral is 0 at the edge") {
    for (const char* m : {"1/3", "5/8", "7/3", "3.9999"}) {
        CAPTURE(m);
        const Ball whole = integral(m, ball("1"));
        CHECK(whole.is_finite());
        CHECK(overlaps(whole, Ball(0, power_law_bits)));
        CHECK(certainly_less(abs(whole), ball("1e-100")));
    }
}

TEST_CASE("the integral is Gauss's 2F1, where Arb's gives a value") {
    for (const char* m : {"1/10", "5/8", "0.62500000000000000001", "7/3", "3.9999", "10", "50"}) {
        for (const char* at : {"0.001", "0.3", "0.7", "0.99"}) {
            CAPTURE(m);
            CAPTURE(at);
            const Ball q = ball(at);
            const Ball y = (1 - q) * (1 + q);
            const Ball gauss =
                sqrt(y) * hypergeometric_2f1((1 - ball(m)) / 2, Ball(1, power_law_bits),
                                             Ball(Rational(3, 2), power_law_bits), y);
            CHECK(overlaps(integral(m, q), gauss));
            CHECK(narrow(integral(m, q)));
        }
    }
}

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

TEST_CASE("at the apex the integral is 1/m, and next to it narrow, for m from 1e-10 to 1e6") {
    const Ball zero(0, power_law_bits);
    for (const char* m :
         {"1e-10", "0.62499999999999999999", "5/8", "2", "3", "101/7", "10000", "1000000"}) {
        CAPTURE(m);
        CHECK(overlaps(integral(m, zero), 1 / ball(m)));
        CHECK(integral(m, zero).relative_accuracy_bits() > 350);
        for (const char* at : {"1e-300", "0.2", "0.9", "0.99999"}) {
            CAPTURE(at);
            const Ball x = integral(m, ball(at));
            CHECK(x.relative_accuracy_bits() > 350);
            CHECK(certainly_positive(x));
        }
    }
    // A ball around the apex contains the values at the apex and near it.
    const Ball about = Ball::around(Real(0), pow(Real(10), -100), power_law_bits);
    for (const char* m : {"1/2", "2", "4", "9/2"}) {
        CAPTURE(m);
        CHECK(contains(integral(m, about), integral(m, zero)));
        CHECK(contains(integral(m, about), integral(m, ball("1e-101"))));
    }
    CHECK_FALSE(integral("0", about).is_finite());
}

TEST_CASE("a power law of m = 1e4 by Barber and Mossakovskii, and by balls at m = 1e-10 ... 1e6") {
    const auto law = [](const char* m) { return Profile::power_law(exact("3"), exact(m)); };
    const Load load = Load::right_edge(exact("7/10"));
    const Witness steep(law("10000"), exact("7/3"), load, 20);
    for (const char* u : {"1e-6", "1e-4", "0.01"}) {
        CAPTURE(u);
        const Ball p =
            enclosed_pressure(law("10000"), exact("7/3"), load, Edge::right, exact(u), 50);
        const Real other = steep.pressure(Edge::right, exact(u), Route::barber_mossakovskii).value;
        const PrecisionScope scope(60);
        CHECK(scenes::common_digits(other, p.midpoint()) >= 20);
    }
    for (const char* m : {"1e-10", "0.62500000000000000001", "10000", "1000000"}) {
        for (const char* u : {"1e-300", "1e-4", "0.2", "0.69999999999", "0.7", "1"}) {
            CAPTURE(m);
            CAPTURE(u);
            const Ball p = enclosed_pressure(law(m), exact("7/3"), load, Edge::right, exact(u), 50);
            CHECK(round_ball(p, 50).complete);
        }
    }
}

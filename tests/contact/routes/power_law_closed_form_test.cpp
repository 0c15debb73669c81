// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/power_law_closed_form.hpp"

#include "edgeproof/contact/enclosure/power_law_integral.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using scenes::exact;

namespace {

/// Returns an upper bound of the relative distance of the value in Real from the ball.
Real distance_from_ball(PowerLawIntegralInReal& in_real, const Exact& m, const Exact& u,
                        unsigned digits, bool at_apex) {
    const long bits = static_cast<long>(3.33 * digits) + 1200;
    const Ball near(u.rational(), bits);
    const Ball q = at_apex ? Ball(0, bits) : 1 - near;
    const Ball y = at_apex ? Ball(1, bits) : near * (2 - near);
    const Ball enclosed = PowerLawIntegral(m, Ball(m.rational(), bits))(q, y);
    REQUIRE(enclosed.relative_accuracy_bits() > static_cast<long>(3.33 * digits));
    const Rational place = at_apex ? Rational(1) : u.rational();
    const auto value = in_real(from_rational<Real>(Rational(1 - place)),
                               from_rational<Real>(Rational(place * (2 - place))));
    REQUIRE(value.converged);
    return abs(Ball(value.value, bits) / enclosed - 1).upper();
}

} // namespace

// The two share no series, no recurrence and no arithmetic.
TEST_CASE("a power law in Real and its enclosure, from m = 1e-30 to 1e6, apex to edge") {
    for (const unsigned digits : {30U, 100U, 300U}) {
        const PrecisionScope scope(digits + 15);
        const Real tolerance = pow(Real(10), -static_cast<int>(digits));
        for (const char* m : {"1e-30", "1/10", "5/8", "2", "2.00000000000000000001", "3", "3.9999",
                              "101/7", "100", "1001", "10000", "1000000"}) {
            CAPTURE(digits);
            CAPTURE(m);
            const Exact exponent = exact(m);
            PowerLawIntegralInReal in_real(exponent, digits + 5);
            for (const char* u : {"1e-300", "1e-30", "1e-5", "0.01", "0.29", "0.3", "0.499999",
                                  "0.5", "0.500001", "0.7", "0.999", "1 - 1e-40", "1 - 1e-300"}) {
                CAPTURE(u);
                CHECK(distance_from_ball(in_real, exponent, exact(u), digits, false) < tolerance);
            }
            CHECK(distance_from_ball(in_real, exponent, exact("1"), digits, true) < tolerance);
        }
    }
}

// Integrated by hand: I_2 = (sqrt(y) + q^2 arcosh(1/q))/2, I_3 = sqrt(y) (1 + 2 q^2)/3.
TEST_CASE("a power law in Real of m = 2 and 3 by hand") {
    const PrecisionScope scope(60);
    for (const char* at : {"1e-9", "0.1", "0.49", "0.51", "0.8", "0.99"}) {
        CAPTURE(at);
        const Real q = exact(at).to<Real>();
        const Real y = (1 - q) * (1 + q);
        const Real second = (sqrt(y) + q * q * acosh(Real(1 / q))) / 2;
        const Real third = sqrt(y) * (1 + 2 * q * q) / 3;
        CHECK(scenes::agree(PowerLawIntegralInReal(exact("2"), 50)(q, y).value, second, 55));
        CHECK(scenes::agree(PowerLawIntegralInReal(exact("3"), 50)(q, y).value, third, 55));
    }
    CHECK_THROWS_AS(PowerLawIntegralInReal(exact("0"), 50), DomainError);
}

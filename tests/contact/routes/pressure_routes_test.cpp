// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contact/route_agreement.hpp"

#include "edgeproof/contact/enclosure/power_law_integral.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

const std::vector<Route> all_routes{Route::singular_integral, Route::barber_mossakovskii,
                                    Route::closed_form};

void expect_agreement(const std::vector<Contact>& contacts, const std::vector<Route>& routes,
                      unsigned digits, int count, std::size_t least_points) {
    const Agreement found = compare_routes(contacts, routes, digits, count);
    MESSAGE(found.points, " points, worst ", found.worst_digits, " digits at ", found.worst_place);
    CHECK(found.points >= least_points);
    CHECK(found.worst_digits >= static_cast<int>(digits));
}

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

TEST_CASE("symmetric contacts: three routes agree to 50 digits at 200 points") {
    expect_agreement(symmetric(), all_routes, 50, 20, 200);
}

TEST_CASE("tilted contacts: three routes agree to 50 digits at both edges") {
    expect_agreement(tilted(), all_routes, 50, 4, 90);
}

TEST_CASE("routes agree to 200 digits as well") {
    const auto few = symmetric();
    expect_agreement({few[2], few[6]}, all_routes, 200, 2, 6);
}

TEST_CASE("Hertz: half an ellipse") {
    // p = E* sqrt(a^2 - x^2)/(2R), P = pi E* a^2/(4R) (Johnson, Contact Mechanics, 4.43 with b).
    const NormalContact contact(Profile::power_law(exact("1/70"), exact("1")), exact("7/3"),
                                Load::right_edge(exact("0.02")), 50);
    const PrecisionScope scope(60);
    const Real E = Real(7) / 3;
    const Real R = 70;
    const Real a = Real(1) / 50;
    CHECK(common_digits(contact.force(), pi<Real>() * E * a * a / (4 * R)) >= 50);
    for (const char* text : {"1e-30", "1e-3", "0.01999"}) {
        const Real u(text);
        const Real p = E / (2 * R) * sqrt(u * (2 * a - u));
        for (const Route route : all_routes) {
            CHECK(common_digits(contact.pressure(Edge::right, u, route).value, p) >= 50);
        }
    }
}

TEST_CASE("an upright wedge: an inverse hyperbolic cosine") {
    // p = (E* C/pi) arcosh(a/x) (Johnson, 5.2(b)).
    const NormalContact contact(Profile::power_law(exact("0.3"), exact("0")), exact("7/3"),
                                Load::right_edge(exact("3/2")), 50);
    const PrecisionScope scope(90);
    for (const char* text : {"1e-20", "1e-3", "1.4999999999999999"}) {
        const Real x = Real(3) / 2 - Real(text);
        const Real p = Real(7) / 3 * Real(3) / 10 / pi<Real>() * acosh(Real(3) / 2 / x);
        for (const Route route : all_routes) {
            CHECK(common_digits(contact.pressure(Edge::right, Real(text), route).value, p) >= 50);
        }
    }
}

TEST_CASE("power law m = 2: integrated by hand") {
    // The integral of s^2/sqrt(s^2 - x^2) from x to a is (a w + x^2 arcosh(a/x))/2. With the factor
    // of moore-hills.tex line 148 at m = 2: P = 2 E* C a^3/3, so that P' = 2 E* C a^2.
    const NormalContact contact(Profile::power_law(exact("3"), exact("2")), exact("5"),
                                Load::right_edge(exact("2")), 50);
    const PrecisionScope scope(70);
    CHECK(common_digits(contact.force(), Real(2) * 5 * 3 * 8 / 3) >= 50);
    const Real x = Real(7) / 4;
    const Real w = sqrt(4 - x * x);
    const Real p = Real(2) * 5 * 3 / pi<Real>() * (2 * w + x * x * acosh(2 / x)) / 2;
    CHECK(common_digits(contact.pressure(Edge::right, exact("1/4")).value, p) >= 50);
}

TEST_CASE("on a knot, on a corner, and outside") {
    const NormalContact flat(Profile::flat_and_rounded(exact("0.4"), exact("3")), exact("2"),
                             Load::right_edge(exact("3/2")), 50);
    const Real on = flat.pressure(Edge::right, exact("1.1")).value;
    const Real nearby = flat.pressure(Edge::right, exact("1.1000000000000000000000001")).value;
    CHECK(abs(on - nearby) < Real("1e-22"));
    CHECK(common_digits(
              on, flat.pressure(Edge::right, exact("1.1"), Route::barber_mossakovskii).value) >=
          50);
    CHECK(common_digits(
              on, flat.pressure(Edge::right, exact("1.1"), Route::singular_integral).value) >= 50);
    CHECK_THROWS_AS((void)flat.pressure(Edge::right, exact("3")), DomainError);
    CHECK_THROWS_AS((void)flat.pressure(Edge::right, exact("0")), DomainError);
    CHECK_THROWS_AS((void)flat.pressure(Edge::left, exact("-1")), DomainError);
    const NormalContact wedge(Profile::power_law(exact("1"), exact("0")), exact("2"),
                              Load::right_edge(exact("3/2")), 50);
    CHECK_THROWS_AS((void)wedge.pressure(Edge::right, exact("3/2")), DomainError);
    // At 1e-300 from the apex it is large, but finite: (2/pi) arcosh(1.5e300).
    const PrecisionScope scope(60);
    const Exact u(Expr::number(Rational(3) / 2) - exact("1e-300").expr());
    CHECK(common_digits(wedge.pressure(Edge::right, u).value,
                        2 / pi<Real>() * log(Real(3) * pow(Real(10), 300))) >= 50);
    const Contact own = own_symmetric();
    const NormalContact bent(own.profile, own.modulus, own.load, 50);
    CHECK_THROWS_AS((void)bent.pressure(Edge::right, exact("1/3"), Route::closed_form),
                    DomainError);
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("symmetric contacts: three routes agree to 50 digits at 1000 points") {
    expect_agreement(symmetric(), all_routes, 50, 100, 1000);
}
TEST_CASE("tilted contacts: 2000 points, both edges, both sides of every knot") {
    expect_agreement(tilted(), all_routes, 50, 145, 2000);
}
TEST_CASE("a profile of one's own: the singular integral and nested Barber-Mossakovskii") {
    expect_agreement({own_symmetric()}, {Route::singular_integral, Route::barber_mossakovskii}, 20,
                     1, 1);
}
TEST_SUITE_END();

TEST_CASE("Barber-Mossakovskii beyond a corner: P' grows like the distance to the power -1/2") {
    // The distance of s from the corner loses all but a few digits, where a few suffice.
    const Symbols x{"x"};
    const Profile profile =
        Profile::piecewise_symmetric({exact("1/4")}, {parse("x/10", x), parse("x/10 + 1/50", x)});
    const auto pressure = [&](auto route, const char* a, const char* u, unsigned digits) {
        const PrecisionScope scope(digits);
        const ContactLaw<Real> law(profile, Real(1));
        const Extent<Real> e = law.extent(exact(a).to<Real>());
        return route(law, e, point_at(e, Edge::right, exact(u).to<Real>())).value;
    };
    const auto by_rates = [](const auto& law, const auto& e, const auto& at) {
        return barber_mossakovskii(law, e, at, 50);
    };
    const auto closed = [](const auto& law, const auto& e, const auto& at) {
        return logarithmic_closed_form(law, e, at);
    };
    const std::pair<const char*, const char*> points[] = {
        {"1", "7/8"}, {"1", "3/4 + 1e-15"}, {"1/4 + 1e-20", "11e-21"}, {"1/4 + 1e-20", "3e-20"}};
    for (const auto& point : points) {
        const char* const a = point.first;
        const char* const u = point.second;
        CAPTURE(a);
        CAPTURE(u);
        CHECK(common_digits(pressure(by_rates, a, u, 90), pressure(closed, a, u, 200)) >= 50);
    }
}

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

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

// Compares values over intervals, by disks and near bends, with the integrals at points in them.
TEST_CASE("a pressure over an interval holds those at its points, and so do its derivatives") {
    const IntegratedContact c(own_tilted().profile, exact("7/3"), Load::right_edge(exact("4/5")),
                              200);
    const auto ball = [](const char* u) { return Ball(exact(u).rational(), 200); };
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const char* u : {"1e-6", "0.01", "0.2", "0.45", "0.5", "0.7"}) {
            CAPTURE(std::string(u));
            const Ball wide = Ball::hull(ball(u), ball(u) * Ball(Rational(1001, 1000), 200));
            const BallSeries over = c.pressure_series(edge, wide, 8);
            const BallSeries at = c.pressure_series(edge, ball(u), 2);
            CHECK(overlaps(over[0], at[0]));
            CHECK(overlaps(over[1], at[1]));
            CHECK(over[0].relative_accuracy_bits() > 5);
            CHECK(over[7].is_finite());
            CHECK(overlaps(c.pressure(edge, wide), c.pressure(edge, ball(u))));
        }
    }
    // The bend at 1/3 is at u = 7/15, the corner at u = 4/5.
    const Ball bend = Ball(Rational(7, 15), 200);
    const Ball near_bend = Ball::hull(bend - ball("1e-5"), bend + ball("1e-5"));
    const Ball p = c.pressure(Edge::right, near_bend);
    CHECK(contains(p, c.pressure(Edge::right, exact("7/15"))));
    CHECK(p.relative_accuracy_bits() > 6);
    const Ball corner = Ball::hull(ball("0.8") - ball("1e-9"), ball("0.8") + ball("1e-9"));
    CHECK_FALSE(c.pressure(Edge::right, corner).is_finite());
    const Ball least = c.least_pressure(Edge::right, corner);
    CHECK(certainly_less(Ball(least.lower(), 200), c.pressure(Edge::right, exact("0.8 + 1e-9"))));
    CHECK(certainly_less(c.pressure(Edge::right, exact("0.801")), Ball(least.lower(), 200)));
}

TEST_CASE("the majorant of a curved slope is above its coefficients") {
    const IntegratedContact c(own_tilted().profile, exact("7/3"), Load::right_edge(exact("4/5")),
                              200);
    for (const Edge edge : {Edge::right, Edge::left}) {
        const Ball rho = c.reach(edge) / 2;
        REQUIRE(certainly_positive(rho));
        const Ball most = c.majorant(edge, rho);
        Ball scale(1, 200);
        for (const Ball& x : c.expansion(edge, 6)) {
            CHECK(certainly_less(abs(x) * scale, most));
            scale *= rho;
        }
        CHECK_FALSE(c.majorant(edge, rho * 3).is_finite());
    }
}

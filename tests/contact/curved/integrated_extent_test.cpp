// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/extents.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

/// Returns the fault of an enclosure compared with another one; empty if there is none.
std::string fault(const Ball& x, const Ball& y) {
    if (!overlaps(x, y)) {
        return "apart";
    }
    // 10 units of the 40th digit.
    return x.relative_accuracy_bits() > 130 ? "" : "wide: " + x.radius().str(3);
}

std::string fault(const EnclosedExtents& x, const EnclosedExtents& y) {
    if (x.crossings.size() != y.crossings.size() || x.leaves != y.leaves) {
        return "other crossings";
    }
    for (std::size_t i = 0; i < x.crossings.size(); ++i) {
        if (!overlaps(x.crossings[i], y.crossings[i])) {
            return "crossing " + std::to_string(i) + " apart";
        }
    }
    return fault(x.first_exit, y.first_exit) + fault(x.measure, y.measure);
}

} // namespace

// Compares integrals and Cauchy's bounds with logarithms and their derivatives.
TEST_CASE("extents by rigorous integrals are those of the closed forms, where there are both") {
    const std::string wedge = "tilted-wedge phi=pi/16 alpha=pi/20 ";
    const std::string pad = "flat-and-rounded R=1 ";
    const std::vector<AskedExtent> all = {
        {contact_of(pad + "t=2/5 a=1"), Edge::right, 2, "1/20"},
        {contact_of(pad + "t=2/5 P=1/5"), Edge::left, 1, "1/100"},
        {contact_of(wedge + "a=1"), Edge::left, 2, "1/100"},
        {contact_of(wedge + "P=1/10"), Edge::right, 3, "1e-9"},
        {contact_of("tilted-flat-and-rounded alpha=pi/16 t=1 R=2 a=3"), Edge::left, 2, "1/20"},
        {contact_of(pad + "t=4/5 a=1"), Edge::right, 1, "1/100", {exact("1/1000"), exact("1/2")}}};
    for (const AskedExtent& asked : all) {
        CAPTURE(asked.contact.name);
        CHECK(fault(enclosed<IntegratedContact>(asked, 262), enclosed<BallContact>(asked, 262)) ==
              "");
    }
}

TEST_CASE("extents of curved slopes, with corners and bends, symmetric or not" *
          doctest::test_suite("slow")) {
    Contact loaded = own_tilted();
    loaded.load = Load::force(exact("1/3"));
    const std::vector<AskedExtent> all = {{own_symmetric(), Edge::right, 1, "1/100"},
                                          {own_symmetric(), Edge::right, 3, "1e-6"},
                                          {own_tilted(), Edge::right, 2, "1/20"},
                                          {own_tilted(), Edge::left, 1, "1/100"},
                                          {loaded, Edge::left, 2, "1/20"}};
    for (const AskedExtent& asked : all) {
        CAPTURE(asked.n);
        CHECK(fault_by_witness(asked, enclosed<IntegratedContact>(asked, 262)) == "");
    }
}

TEST_CASE("an undecided case is not guessed: a crossing on the range's end, b on a knot") {
    const std::string inside = "((1+x)^2-1-x^2)/2";
    const auto integrals = [](const Contact& c) {
        return IntegratedContact(c.profile, c.modulus, c.load, 200);
    };
    // The error of one term of Hertz is 1 at 3/4 of the contact.
    CHECK_THROWS_AS(
        (void)enclosed<IntegratedContact>({contact_of("piecewise symmetric a=1 slopes=" + inside),
                                           Edge::right,
                                           1,
                                           "1",
                                           {exact("0"), exact("3/4")}}),
        BudgetError);
    // b = 1 = a, because g' = x in the contact, with a bend at -1: exact algebra shows this. c_0 of
    // Hertz's sqrt(u (2 - u))/2 is sqrt(2)/2.
    const IntegratedContact odd =
        integrals(contact_of("piecewise knots=-1;0 a=1 E=1 slopes=2*x+1;" + inside + ";" + inside));
    CHECK(odd.known(Edge::left).has_value());
    CHECK(overlaps(odd.expansion(Edge::left, 1)[0], sqrt(Ball(2, 200)) / 2));
    // Exact algebra does not know that sinh is (e^x - e^-x)/2.
    const Contact hidden =
        contact_of("piecewise knots=-1;0 a=1 slopes=sinh(x)+x+1;(exp(x)-exp(-x))/2;sinh(x)");
    const IntegratedContact on_knot = integrals(hidden);
    CHECK(contains(on_knot.b(), Rational(1)));
    CHECK(on_knot.edge_may_be_on_knot());
    CHECK_FALSE(on_knot.expansion(Edge::left, 1)[0].is_finite());
    CHECK_THROWS_AS((void)enclosed<IntegratedContact>({hidden, Edge::left, 1, "1/100"}),
                    BudgetError);
}

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

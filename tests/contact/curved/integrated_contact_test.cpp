// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/integrated_contact.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/by_witness.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

constexpr long integral_bits = 300;

/// Branch points on knots: whole, half and third powers on one or both sides of the knot, which the
/// integrals remove by a change of variable that the witness does not use. Slopes of every kind are
/// compared with mpmath in tests/scene/values.txt.
const std::vector<std::string> slopes_of_roots{
    "piecewise symmetric knots=1/3 slopes=0;(x-1/3)^(3/2) a=1",
    "piecewise knots=0;1/5 slopes=-sqrt(-2*x)/3;0;sqrt(3*(x-1/5)/2)+((x-1/5)/7)^(4/3) a=4/5",
    "piecewise symmetric knots=1/4 slopes=x/3;x/3+sinh((x-1/4)^(5/3)) a=4/5",
};

IntegratedContact integrals_of(const Contact& c, long bits = integral_bits) {
    return {c.profile, c.modulus, c.load, bits};
}

} // namespace

// Compares integrals with logarithms: the two share the arithmetic, but no formula.
TEST_CASE("rigorous integrals overlap the closed forms where there are both") {
    std::vector<Contact> all = tilted();
    for (const std::size_t i : {0U, 1U, 6U, 7U}) {
        all.push_back(symmetric()[i]);
    }
    all.push_back(contact_of("tilted-wedge phi=pi/16 alpha=pi/20 P=1/10"));
    for (const Contact& c : all) {
        CAPTURE(c.name);
        const IntegratedContact integrals = integrals_of(c);
        const BallContact closed(c.profile, c.modulus, c.load, integral_bits);
        const auto meet = [](const Ball& x, const Ball& y) {
            CHECK(overlaps(x, y));
            CHECK(x.relative_accuracy_bits() > 150);
        };
        meet(integrals.a(), closed.a());
        meet(integrals.b(), closed.b());
        meet(integrals.force(), closed.force());
        if (!c.profile.symmetric()) {
            CHECK(overlaps(integrals.moment(), closed.moment()));
        }
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const char* u : {"1e-20", "1e-3", "0.003"}) {
                CAPTURE(u);
                const Exact at = exact(u);
                if (certainly_less(Ball(at.rational(), integral_bits), closed.a() + closed.b())) {
                    meet(integrals.pressure(edge, at), closed.pressure(edge, at));
                }
            }
            // The terms are computed each by its own integral, and all by one disk about the edge.
            for (const std::size_t terms : {4U, 24U}) {
                const auto x = integrals.expansion(edge, terms);
                const auto y = closed.expansion(edge, terms);
                for (std::size_t k = 0; k < terms; ++k) {
                    CAPTURE(k);
                    CHECK(overlaps(x[k], y[k]));
                    CHECK(x[k].relative_accuracy_bits() > 60);
                }
            }
        }
    }
}

TEST_CASE("slopes with roots at knots: rigorous integrals hold what the witness finds") {
    for (const std::string& words : slopes_of_roots) {
        CAPTURE(words);
        const Contact c = contact_of(words + " E=1");
        CHECK(digits_shared(c, 14, Route::singular_integral, {"0.0625"}) >= 14);
        check_coefficients(c, integrals_of(c, 160), Edge::right, 2, 15);
    }
}

// g'' is infinite on the knot, but g' and therefore p are finite.
TEST_CASE("p over a ball that meets a root on a knot") {
    const IntegratedContact balls = integrals_of(
        contact_of("piecewise symmetric knots=1/2 slopes=x/9;x/9+sqrt(x-1/2) a=1 E=1"), 128);
    const Ball wide = Ball::from_interval(Real("0.499999"), Real("0.500002"), 128);
    const Ball p = balls.pressure(Edge::right, wide);
    REQUIRE(p.is_finite());
    CHECK(p.relative_accuracy_bits() >= 3);
    for (const char* u : {"0.499999", "0.5", "0.5000003", "0.500002"}) {
        CHECK(overlaps(p, balls.pressure(Edge::right, exact(u))));
    }
}

// With an edge or the force given, and in a mirror.
TEST_CASE("rigorous integrals hold what the witness finds with corners and bends") {
    for (const Contact& c : {own_symmetric(), own_tilted()}) {
        CAPTURE(c.name);
        REQUIRE_FALSE(c.profile.has_closed_form());
        CHECK(digits_shared(c, 40, Route::singular_integral,
                            {"1e-20", "0.006", "0.18", "0.19", "0.31"}) >= 40);
        for (const Edge edge : {Edge::right, Edge::left}) {
            check_coefficients(c, integrals_of(c, 160), edge, 2, 15);
        }
        Contact loaded = c;
        loaded.load = Load::force(exact("1/3"));
        CHECK(digits_shared(loaded, 20, Route::singular_integral, {"0.006"}) >= 20);
        const IntegratedContact balls = integrals_of(loaded);
        CHECK(overlaps(balls.force(), Ball(Rational(1, 3), integral_bits)));
        CHECK(balls.a().relative_accuracy_bits() > 240);
        CHECK(balls.b().relative_accuracy_bits() > 240);
    }
    const Contact c = own_tilted();
    const IntegratedContact balls = integrals_of(c);
    const IntegratedContact mirrored(c.profile.reflected(), c.modulus,
                                     Load::right_edge(exact(balls.b().midpoint().str(70))),
                                     integral_bits);
    const PrecisionScope scope(60);
    CHECK(agree(mirrored.b().midpoint(), balls.a().midpoint(), 60));
    CHECK(agree(mirrored.force().midpoint(), balls.force().midpoint(), 60));
}

TEST_CASE(
    "on a bend that exact numbers identify, the pressure is enclosed; on a corner it is not") {
    const Contact c = own_tilted();
    const IntegratedContact balls = integrals_of(c);
    const Witness second = witness_of(c, 40);
    const PrecisionScope scope(60);
    const Exact bend = exact("4/5 - 1/3");
    const Real p = second.pressure(Edge::right, bend, Route::singular_integral).value;
    CHECK(overlaps(balls.pressure(Edge::right, bend),
                   Ball::around(p, Real(p * Real("1e-38")), integral_bits)));
    CHECK(balls.pressure(Edge::right, bend).relative_accuracy_bits() > 100);
    CHECK_FALSE(balls.pressure(Edge::right, exact("4/5")).is_finite());
    CHECK_THROWS_AS((void)balls.pressure(Edge::right, exact("7")), DomainError);
}

// Near the edge the angle of a knot has lost digits, which the enclosure must include.
TEST_CASE("a corner just inside the edge: few bits give a wide ball, never a wrong one") {
    for (const std::string gap : {"1e-15", "3e-17", "7e-19", "2e-22"}) {
        CAPTURE(gap);
        const Contact c =
            contact_of("piecewise symmetric knots=1/3 slopes=1/10;3/10+(x-1/3) a=1/3+" + gap);
        const IntegratedContact few = integrals_of(c, 100);
        const BallContact many(c.profile, c.modulus, c.load, 600);
        CHECK(contains(few.force(), many.force()));
        for (const char* u : {"1e-3", "0.1", "0.4"}) {
            const Ball p = few.pressure(Edge::right, exact(u));
            CHECK(contains(p, many.pressure(Edge::right, exact(u))));
            CHECK(p.relative_accuracy_bits() > 20);
        }
    }
}

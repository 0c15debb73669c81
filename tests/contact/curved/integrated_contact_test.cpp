// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/integrated_contact.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

constexpr long integral_bits = 300;

/// A punch curved on both sides, with a bend at 1/3 and a corner at the origin.
Contact own_tilted() {
    const Symbols x{"x"};
    return {"own, not symmetric",
            Profile::piecewise({exact("0"), exact("1/3")},
                               {parse("-1/10 + sinh(x)", x), parse("x^2 + x/7", x),
                                parse("1/9 + 1/21 + tanh(x - 1/3)", x)}),
            exact("7/3"), Load::right_edge(exact("4/5"))};
}

} // namespace

// Compares integrals with logarithms: the two share the arithmetic, but no formula.
TEST_CASE("rigorous integrals overlap the closed forms where there are both") {
    std::vector<Contact> all = tilted();
    for (const std::size_t i : {0U, 1U, 6U, 7U}) {
        all.push_back(symmetric()[i]);
    }
    for (const Contact& c : all) {
        CAPTURE(c.name);
        const IntegratedContact integrals(c.profile, c.modulus, c.load, integral_bits);
        const BallContact closed(c.profile, c.modulus, c.load, integral_bits);
        const auto meet = [](const Ball& x, const Ball& y) {
            CHECK(overlaps(x, y));
            CHECK(x.relative_accuracy_bits() > 150);
        };
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

// Branch points on knots: whole, half and third powers, on one or both sides of the knot, also for
// edges that are solved for. The integrals remove the branch point by a change of variable, which
// the witness does not use.
TEST_CASE("roots on knots: integrals and a disk give what the witness gives") {
    const Symbols x{"x"};
    struct Case {
        Profile profile;
        Load load;
    };
    const Case cases[] = {
        {Profile::piecewise_symmetric({exact("1/3")}, {parse("0", x), parse("(x - 1/3)^(3/2)", x)}),
         Load::right_edge(exact("1"))},
        {Profile::piecewise({exact("0"), exact("1/5")},
                            {parse("-sqrt(-2*x)/3", x), parse("0", x),
                             parse("sqrt(3*(x - 1/5)/2) + ((x - 1/5)/7)^(4/3)", x)}),
         Load::right_edge(exact("4/5"))},
        {Profile::piecewise_symmetric({exact("1/4")},
                                      {parse("x/3", x), parse("x/3 + sinh((x - 1/4)^(5/3))", x)}),
         Load::force(exact("1/3"))},
    };
    for (const Case& c : cases) {
        const IntegratedContact balls(c.profile, exact("1"), c.load, integral_bits);
        const Witness second(c.profile, exact("1"), c.load, 40);
        const PrecisionScope scope(60);
        const auto meet = [](const Ball& enclosed, const Real& value) {
            const Real error = abs(value) * Real("1e-30");
            CHECK(overlaps(enclosed, Ball::around(value, error, integral_bits)));
            CHECK(enclosed.relative_accuracy_bits() > 150);
        };
        meet(balls.b(), second.b());
        meet(balls.force(), second.force());
        for (const char* u : {"1e-9", "1/9"}) {
            meet(balls.pressure(Edge::right, exact(u)),
                 second.pressure(Edge::right, exact(u), Route::singular_integral).value);
        }
        const auto enclosed = balls.expansion(Edge::right, 6);
        const auto values = Witness(c.profile, exact("1"), c.load, 12).coefficients(Edge::right, 3);
        for (std::size_t k = 0; k < values.size(); ++k) {
            CAPTURE(k);
            CHECK(agree(values[k], enclosed[k].midpoint(), 11));
        }
    }
}

// g'' is infinite on the knot, but g' and therefore p are finite.
TEST_CASE("p over a ball that meets a root on a knot") {
    const Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {exact("1/2")}, {parse("x/9", x), parse("x/9 + sqrt(x - 1/2)", x)});
    const IntegratedContact balls(profile, exact("1"), Load::right_edge(exact("1")), 128);
    const Ball wide = Ball::from_interval(Real("0.499999"), Real("0.500002"), 128);
    const Ball p = balls.pressure(Edge::right, wide);
    REQUIRE(p.is_finite());
    CHECK(p.relative_accuracy_bits() >= 3);
    for (const char* u : {"0.499999", "0.5", "0.5000003", "0.500002"}) {
        CHECK(overlaps(p, balls.pressure(Edge::right, exact(u))));
    }
}

TEST_CASE("rigorous integrals hold what the witness finds for a curved slope") {
    for (const Contact& c : {own_symmetric(), own_tilted()}) {
        CAPTURE(c.name);
        REQUIRE_FALSE(BallContact::has_closed_form(c.profile));
        const IntegratedContact balls(c.profile, c.modulus, c.load, integral_bits);
        const Witness second(c.profile, c.modulus, c.load, 40);
        const PrecisionScope scope(60);
        const auto holds = [](const Ball& x, const Real& y) {
            CHECK(overlaps(x, Ball::around(y, Real(abs(y) * Real("1e-38")), integral_bits)));
            CHECK(x.relative_accuracy_bits() > 100);
        };
        holds(balls.b(), second.b());
        holds(balls.force(), second.force());
        if (!c.profile.symmetric()) {
            holds(balls.moment(), second.moment());
        }
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const char* u : {"1e-20", "0.01", "0.29", "0.31", "0.5"}) {
                CAPTURE(u);
                holds(balls.pressure(edge, exact(u)),
                      second.pressure(edge, exact(u), Route::singular_integral).value);
            }
            const auto x = balls.expansion(edge, 4);
            const auto y = Witness(c.profile, c.modulus, c.load, 12).coefficients(edge, 2);
            for (std::size_t k = 0; k < y.size(); ++k) {
                CHECK(agree(y[k], x[k].midpoint(), 11));
            }
        }
    }
}

TEST_CASE("a force on a symmetric curved contact: its edge enclosed") {
    const Contact c = own_symmetric();
    const Load load = Load::force(exact("1/10"));
    const IntegratedContact balls(c.profile, c.modulus, load, integral_bits);
    CHECK(overlaps(balls.force(), Ball(Rational(1, 10), integral_bits)));
    CHECK(balls.a().relative_accuracy_bits() > 250);
}

TEST_CASE(
    "on a bend that exact numbers identify, the pressure is enclosed; on a corner it is not") {
    const Contact c = own_tilted();
    const IntegratedContact balls(c.profile, c.modulus, c.load, integral_bits);
    const Witness second(c.profile, c.modulus, c.load, 40);
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
    const Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {exact("1/3")}, {parse("1/10", x), parse("3/10 + (x - 1/3)", x)});
    for (const char* gap : {"1e-15", "3e-17", "7e-19", "2e-22"}) {
        CAPTURE(gap);
        const Load load = Load::right_edge(exact(std::string("1/3 + ") + gap));
        const IntegratedContact few(profile, exact("7/3"), load, 100);
        const BallContact many(profile, exact("7/3"), load, 600);
        CHECK(contains(few.force(), many.force()));
        for (const char* u : {"1e-3", "0.1", "0.4"}) {
            const Ball p = few.pressure(Edge::right, exact(u));
            CHECK(contains(p, many.pressure(Edge::right, exact(u))));
            CHECK(p.relative_accuracy_bits() > 20);
        }
    }
}

// The left edge equals that of the witness, and the force is the given one.
TEST_CASE("a force on a curved contact that is not symmetric: both edges enclosed") {
    const Contact c = own_tilted();
    const char* force = "1/3";
    const Load load = Load::force(exact(force));
    const IntegratedContact balls(c.profile, c.modulus, load, integral_bits);
    const Witness second(c.profile, c.modulus, load, 12);
    const PrecisionScope scope(40);
    CHECK(overlaps(balls.force(), Ball(exact(force).rational(), integral_bits)));
    CHECK(balls.a().relative_accuracy_bits() > 240);
    CHECK(balls.b().relative_accuracy_bits() > 240);
    CHECK(agree(balls.a().midpoint(), second.a(), 11));
    CHECK(agree(balls.b().midpoint(), second.b(), 11));
    // If that edge is given, the force is found again.
    const IntegratedContact back(
        c.profile, c.modulus, Load::right_edge(exact(balls.a().midpoint().str(60))), integral_bits);
    CHECK(agree(back.force().midpoint(), exact(force).to<Real>(), 38));
    CHECK(overlaps(
        back.pressure(Edge::left, exact("1/100")).with_bits(100),
        balls.pressure(Edge::left, exact("1/100")).with_bits(100) *
            Ball::from_interval(Real(1) - pow(Real(10), -38), Real(1) + pow(Real(10), -38), 300)));
}

TEST_CASE("the edges of a tilted wedge under a force: integrals against logarithms") {
    const Profile wedge = Profile::tilted_wedge(exact("pi/16"), exact("pi/20"));
    const Load load = Load::force(exact("1/10"));
    const IntegratedContact integrals(wedge, exact("7/3"), load, integral_bits);
    const BallContact closed(wedge, exact("7/3"), load, integral_bits);
    CHECK(overlaps(integrals.a(), closed.a()));
    CHECK(overlaps(integrals.b(), closed.b()));
    CHECK(integrals.b().relative_accuracy_bits() > 200);
    CHECK(overlaps(integrals.expansion(Edge::left, 2)[1], closed.expansion(Edge::left, 2)[1]));
}

// The knot has no effect inside the contact: the coefficients are those of the piece continued
// beyond the knot.
TEST_CASE("a given edge on a knot is expanded from inside the contact") {
    const Symbols x{"x"};
    const Load unit = Load::right_edge(exact("1"));
    const Profile bent = Profile::piecewise_symmetric(
        {exact("1")}, {parse("sinh(x)", x), parse("sinh(x) + (x - 1)", x)});
    const Profile smooth = Profile::piecewise_symmetric({}, {parse("sinh(x)", x)});
    const auto c = IntegratedContact(bent, exact("1"), unit, integral_bits);
    const auto d = IntegratedContact(smooth, exact("1"), unit, integral_bits);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(overlaps(c.expansion(Edge::left, 3)[k], d.expansion(Edge::right, 3)[k]));
        CHECK(c.expansion(Edge::right, 3)[k].relative_accuracy_bits() > 200);
    }
    CHECK(overlaps(c.force(), d.force()));
}

// g' = x^(3/2) has no Taylor series at its knot; its pressure is Gauss's 2F1.
TEST_CASE("a root at a knot: integrals against the closed form of the power law") {
    const Profile own = Profile::piecewise_symmetric({}, {parse("2*x^(3/2)", Symbols{"x"})});
    const Load load = Load::right_edge(exact("4/5"));
    const IntegratedContact integrals(own, exact("7/3"), load, 200);
    const BallContact closed(Profile::power_law(exact("2"), exact("3/2")), exact("7/3"), load, 200);
    CHECK(overlaps(integrals.force(), closed.force()));
    for (const char* u : {"1e-9", "1/3", "4/5"}) {
        CAPTURE(std::string(u));
        const Ball p = integrals.pressure(Edge::right, exact(u));
        CHECK(overlaps(p, closed.pressure(Edge::right, exact(u))));
        CHECK(p.relative_accuracy_bits() > 150);
    }
}

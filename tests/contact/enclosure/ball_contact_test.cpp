// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contact/scenes.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

std::vector<Contact> all_closed() {
    std::vector<Contact> all = symmetric();
    for (const Contact& c : tilted()) {
        all.push_back(c);
    }
    return all;
}

} // namespace

TEST_CASE("balls hold what the witness finds, and are narrow") {
    for (const Contact& c : all_closed()) {
        CAPTURE(c.name);
        const Witness contact(c.profile, c.modulus, c.load, 50);
        const BallContact balls(c.profile, c.modulus, c.load, 400);
        const PrecisionScope scope(60);
        // The values of the witness are good to 50 digits: a ball of that radius must overlap.
        const auto holds = [&](const Ball& ball, const Real& value) {
            const Real slack = abs(value) * Real("1e-50");
            CHECK(overlaps(ball, Ball::around(value, slack, 400)));
            CHECK(ball.relative_accuracy_bits() > 200);
        };
        holds(balls.b(), contact.b());
        holds(balls.force(), contact.force());
        if (!c.profile.symmetric() && c.name != "tilted flat-and-rounded a=0.2") {
            holds(balls.moment(), contact.moment());
        }
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const char* fraction : {"1e-30", "0.013", "0.3", "0.47"}) {
                const Exact u = exact(fraction);
                if (!(u.to<Real>() < contact.a() + contact.b())) {
                    continue;
                }
                CAPTURE(fraction);
                holds(balls.pressure(edge, u),
                      contact.pressure(edge, u, Route::singular_integral).value);
            }
        }
    }
}

TEST_CASE("a force given: the edge is isolated, and it is the right one") {
    for (const Contact& c : {symmetric()[6], symmetric()[2], tilted()[0], tilted()[4]}) {
        CAPTURE(c.name);
        const BallContact from_force(c.profile, c.modulus, Load::force(exact("0.05")), 300);
        CHECK(overlaps(from_force.force(), Ball(Rational(1, 20), 300)));
        CHECK(from_force.a().relative_accuracy_bits() > 200);
        const Witness contact(c.profile, c.modulus, Load::force(exact("0.05")), 40);
        CHECK(overlaps(from_force.a(),
                       Ball::around(contact.a(), Real(contact.a() * Real("1e-40")), 300)));
    }
}

// The search once stopped where bisection met the end of the flat, at which dP/da = 0.
TEST_CASE("a force for which the search meets a knot on its way") {
    const Profile flat = Profile::flat_and_rounded(exact("0.4"), exact("1"));
    const BallContact contact(flat, exact("1"), Load::force(exact("0.1")), 300);
    CHECK(overlaps(contact.force(), Ball(Rational(1, 10), 300)));
    CHECK(contact.a().relative_accuracy_bits() > 200);
    CHECK(certainly_less(Ball(Rational(2, 5), 300), contact.a()));
}

TEST_CASE("escalation reaches the requested digits in the hard places") {
    const Contact flat = symmetric()[6];
    // Points at 1e-30 from a knot, on it, and 1e-300 from the edge.
    for (const char* u : {"1.1000000000000000000000000000001", "1.1", "1e-300"}) {
        CAPTURE(u);
        const Ball p =
            enclosed_pressure(flat.profile, flat.modulus, flat.load, Edge::right, exact(u), 50);
        CHECK(round_ball(p, 50).complete);
        const Witness contact(flat.profile, flat.modulus, flat.load, 55);
        const PrecisionScope scope(60);
        CHECK(common_digits(contact.pressure(Edge::right, exact(u), Route::singular_integral).value,
                            p.midpoint()) >= 50);
    }
    // The pressure is infinite at the apex of a wedge: the budget ends without a guess.
    const Contact wedge = tilted()[0];
    CHECK_THROWS_AS((void)enclosed_pressure(wedge.profile, wedge.modulus, wedge.load, Edge::right,
                                            exact("1.5"), 50),
                    BudgetError);
    CHECK_THROWS_AS(
        BallContact(own_symmetric().profile, exact("1"), Load::right_edge(exact("1")), 100),
        DomainError);
}

TEST_CASE("the tilted wedge in balls: gamma from 1e-25 to 1 - 1e-25") {
    // b = gamma a by hand (moore-hills.tex line 301, solved for alpha): alpha = (2 phi/pi)
    // asin((1-gamma)/(1+gamma)).
    for (const char* gamma : {"1e-25", "1e-3", "0.5", "1 - 1e-25"}) {
        CAPTURE(gamma);
        const std::string g = std::string("(") + gamma + ")";
        const Exact alpha = exact("2*(pi/7)/pi*asin((1-" + g + ")/(1+" + g + "))");
        const Profile profile = Profile::tilted_wedge(exact("pi/7"), alpha);
        const BallContact balls(profile, exact("3"), Load::right_edge(exact("7/5")), 500);
        const Ball expected = Ball(exact(gamma).rational(), 500) * 7 / 5;
        CHECK(overlaps(balls.b(), expected));
        CHECK(balls.b().relative_accuracy_bits() > 250);
    }
}

TEST_CASE(
    "balls of the expansion hold the coefficients of the witness, at both edges, and are narrow") {
    for (const Contact& c : all_closed()) {
        CAPTURE(c.name);
        const Witness contact(c.profile, c.modulus, c.load, 20);
        for (const Edge edge : {Edge::right, Edge::left}) {
            if (edge == Edge::left && c.profile.symmetric()) {
                continue;
            }
            const std::vector<Ball> balls =
                BallContact(c.profile, c.modulus, c.load, 1200).expansion(edge, 12);
            const std::vector<Real> values = contact.coefficients(edge, 3);
            const PrecisionScope scope(60);
            REQUIRE(balls.size() == 12);
            for (std::size_t k = 0; k < 12; ++k) {
                CAPTURE(k);
                const Real natural =
                    abs(values[0]) * pow(contact.radius(edge), -static_cast<int>(k));
                if (k < values.size()) {
                    const Real slack = (abs(values[k]) + natural) * Real("1e-20");
                    CHECK(overlaps(balls[k], Ball::around(values[k], slack, 400)));
                }
                const bool narrow = balls[k].relative_accuracy_bits() > 165 ||
                                    balls[k].radius() < natural * Real("1e-50");
                CHECK(narrow);
            }
        }
    }
}

TEST_CASE("an edge just beyond a corner is isolated") {
    // b lies 0.8 % beyond the corner at -0.835/90, where the balance behaves like a root of the
    // distance from the corner, and Newton's method oscillates.
    Symbols x;
    x.add("x");
    const Profile profile = Profile::piecewise(
        {Exact::parse("-8.35e-2/9"), Exact::parse("0"), Exact::parse("8.35e-2/7")},
        {parse("-1/5", x), parse("-1/16", x), parse("1/8", x), parse("1/5 + x/(34*8.35e-2)", x)});
    const Load load = Load::right_edge(Exact::parse("3.99e-3"));
    const BallContact balls(profile, Exact::parse("1"), load, 256);
    CHECK(balls.b().relative_accuracy_bits() > 200);
    const Witness contact(profile, Exact::parse("1"), load, 40);
    const PrecisionScope scope(60);
    CHECK(overlaps(balls.b(), Ball::around(contact.b(), pow(Real(10), -40), 300)));
    // The same contact, found from its force.
    const BallContact from_force(profile, Exact::parse("1"), Load::force(Exact::parse("3.99e-3")),
                                 256);
    CHECK(from_force.a().relative_accuracy_bits() > 200);
}

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

struct CurvedCase {
    const char* knots;
    const char* slopes;
    bool symmetric;
    const char* a;
};

/// Slopes of every kind, and branch points on knots: whole, half and third powers on one or both
/// sides of the knot, which the integrals remove by a change of variable that the witness does not
/// use. Values of those before `of_roots` by mpmath are rows of tests/scene/values.txt.
constexpr std::size_t of_roots = 12;
const CurvedCase curved_cases[] = {
    {"", "sin(x)", true, "0.8"},
    {"", "tan(x)", true, "0.8"},
    {"0", "x*(1 - x^2/10); x*(1 - x^2/10)", false, "0.8"},
    {"0", "atan(x); 2*x", false, "0.8"},
    {"0; 1/5", "x; 0; (x - 1/5)^(3/2)", false, "0.8"},
    {"-1/5; 0", "-(-x - 1/5)^(3/2); 0; x", false, "0.8"},
    {"0; 1/5", "x; 0; sqrt(x - 1/5)", false, "0.8"},
    {"0; 1", "sinh(x); 0; (x - 1)^3", false, "2"},
    {"", "x^2", true, "0.8"},
    {"0", "x; x*gamma(x + 2)", false, "0.8"},
    {"0", "x; log(1 + 3*x)", false, "0.8"},
    {"0", "1 - exp(-x); exp(x) - 1", false, "0.8"},
    {"1/3", "0; (x - 1/3)^(3/2)", true, "1"},
    {"0; 1/5", "-sqrt(-2*x)/3; 0; sqrt(3*(x - 1/5)/2) + ((x - 1/5)/7)^(4/3)", false, "4/5"},
    {"1/4", "x/3; x/3 + sinh((x - 1/4)^(5/3))", true, "4/5"},
};

/// Checks the edges, the loads and pressures by the witness, which are good to its digits.
void check_by_witness(const Profile& profile, const char* modulus, const Load& load,
                      unsigned digits, const std::vector<const char*>& places) {
    const long bits = digits < 20 ? 160 : integral_bits;
    const IntegratedContact balls(profile, exact(modulus), load, bits);
    const Witness second(profile, exact(modulus), load, digits);
    const PrecisionScope scope(60);
    const auto holds = [&](const Ball& x, const Real& y) {
        const Real slack = abs(y) * pow(Real(10), 2 - static_cast<int>(digits));
        CHECK(overlaps(x, Ball::around(y, slack, bits)));
        CHECK(x.relative_accuracy_bits() > bits / 3);
    };
    holds(balls.a(), second.a());
    holds(balls.b(), second.b());
    holds(balls.force(), second.force());
    if (!profile.symmetric() && balls.moment().relative_accuracy_bits() > 0) {
        holds(balls.moment(), second.moment());
    }
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const char* u : places) {
            CAPTURE(u);
            holds(balls.pressure(edge, exact(u)),
                  second.pressure(edge, exact(u), Route::singular_integral).value);
        }
    }
}

/// Checks the coefficients by those of a witness of 12 digits.
void check_coefficients(const Profile& profile, const char* modulus, const Load& load, Edge edge) {
    const auto x = IntegratedContact(profile, exact(modulus), load, 160).expansion(edge, 2);
    const auto y = Witness(profile, exact(modulus), load, 12).coefficients(edge, 2);
    const PrecisionScope scope(60);
    for (std::size_t k = 0; k < y.size(); ++k) {
        CAPTURE(k);
        CHECK(agree(y[k], x[k].midpoint(), 11));
    }
}

} // namespace

// Compares integrals with logarithms: the two share the arithmetic, but no formula.
TEST_CASE("rigorous integrals overlap the closed forms where there are both") {
    std::vector<Contact> all = tilted();
    for (const std::size_t i : {0U, 1U, 6U, 7U}) {
        all.push_back(symmetric()[i]);
    }
    all.push_back(
        {"tilted wedge under a force", all[0].profile, exact("7/3"), Load::force(exact("1/10"))});
    for (const Contact& c : all) {
        CAPTURE(c.name);
        const IntegratedContact integrals(c.profile, c.modulus, c.load, integral_bits);
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

TEST_CASE("slopes of every kind: rigorous integrals hold what the witness finds") {
    for (const CurvedCase& c : curved_cases) {
        CAPTURE(c.slopes);
        check_by_witness(curve(c.knots, c.slopes, c.symmetric), "1", Load::right_edge(exact(c.a)),
                         14, {"1/10"});
    }
    for (std::size_t i = of_roots; i < std::size(curved_cases); ++i) {
        const CurvedCase& c = curved_cases[i];
        check_coefficients(curve(c.knots, c.slopes, c.symmetric), "1", Load::right_edge(exact(c.a)),
                           Edge::right);
    }
}

TEST_CASE("slopes of every kind: the second route, flat punches laid over each other" *
          doctest::test_suite("slow")) {
    for (std::size_t i = 0; i < of_roots; ++i) {
        const CurvedCase& c = curved_cases[i];
        CAPTURE(c.slopes);
        const Profile profile = curve(c.knots, c.slopes, c.symmetric);
        const Load load = Load::right_edge(exact(c.a));
        const Ball p =
            IntegratedContact(profile, exact("1"), load, 160).pressure(Edge::right, exact("1/10"));
        const Witness contact(profile, exact("1"), load, 12);
        const PrecisionScope scope(60);
        CHECK(agree(contact.pressure(Edge::right, exact("1/10"), Route::barber_mossakovskii).value,
                    p.midpoint(), 12));
    }
}

// g'' is infinite on the knot, but g' and therefore p are finite.
TEST_CASE("p over a ball that meets a root on a knot") {
    const Profile profile = curve("1/2", "x/9; x/9 + sqrt(x - 1/2)", true);
    const IntegratedContact balls(profile, exact("1"), Load::right_edge(exact("1")), 128);
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
        check_by_witness(c.profile, "7/3", c.load, 40, {"1e-20", "0.01", "0.29", "0.31", "0.5"});
        for (const Edge edge : {Edge::right, Edge::left}) {
            check_coefficients(c.profile, "7/3", c.load, edge);
        }
        const Load load = Load::force(exact("1/3"));
        check_by_witness(c.profile, "7/3", load, 20, {"0.01"});
        const IntegratedContact balls(c.profile, exact("7/3"), load, integral_bits);
        CHECK(overlaps(balls.force(), Ball(Rational(1, 3), integral_bits)));
        CHECK(balls.a().relative_accuracy_bits() > 240);
        CHECK(balls.b().relative_accuracy_bits() > 240);
    }
    const Contact c = own_tilted();
    const IntegratedContact balls(c.profile, c.modulus, c.load, integral_bits);
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
    const Profile profile = curve("1/3", "1/10; 3/10 + (x - 1/3)", true);
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

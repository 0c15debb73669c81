// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

Profile punch(const char* alpha, const char* t, const char* R) {
    return Profile::tilted_flat_and_rounded(Exact::parse(alpha), Exact::parse(t), Exact::parse(R));
}

} // namespace

// Only digits are known here: they do not distinguish whether b is 1e-60 from the knot or on it.
TEST_CASE("the witness: an edge that no digits separate from a knot is taken to be on it, with "
          "a note") {
    const Witness contact(punch("0.1", "0.5", "2"), Exact::parse("1"),
                          Load::force(Exact::parse("pi*0.005")), 30);
    CHECK(contact.edge_taken_on_knot());
    const PrecisionScope scope(40);
    // Hertz: p = sqrt(u (2/5 - u))/4, so c_0 = sqrt(2/5)/4 and c_1 = -(5/4) c_0.
    const Real c0 = sqrt(Real(2) / 5) / 4;
    for (const Edge edge : {Edge::right, Edge::left}) {
        const auto c = contact.coefficients(edge, 2);
        CHECK(abs(Real(c[0] - c0)) < Real("1e-30"));
        CHECK(abs(Real(c[1] + c0 * 5 / 4)) < Real("1e-30"));
    }
    const Witness near_knot(punch("0.1", "0.5", "2"), Exact::parse("1"),
                            Load::force(Exact::parse("pi*0.005 + 1e-40")), 30);
    CHECK_FALSE(near_knot.edge_taken_on_knot());
}

TEST_CASE("the simplest fraction in a ball, also where its continued fraction is long") {
    CHECK(simplest_rational(Ball(Rational(22, 7), 200)) == Rational(22, 7));
    CHECK(simplest_rational(Ball::hull(Ball(-3, 64), Ball(2, 64))) == Rational(0));
    CHECK(simplest_rational(Ball::hull(Ball(Rational(-7, 20), 64), Ball(Rational(-13, 50), 64))) ==
          Rational(-1, 3));
    // Pell: the convergents p/q of sqrt(2), about 150,000 of them, have p^2 - 2 q^2 = +-1, and the
    // intermediate fractions between them have at most +-2.
    const auto q = simplest_rational(sqrt(Ball(2, 400'000)));
    REQUIRE(q);
    const Integer p = boost::multiprecision::numerator(*q);
    const Integer d = boost::multiprecision::denominator(*q);
    const Integer pell = p * p - 2 * d * d;
    CHECK(abs(pell) <= 2);
    CHECK(pell != 0);
    CHECK(msb(d) > 190'000);
    CHECK(msb(d) < 210'000);
}

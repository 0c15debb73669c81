// SPDX-License-Identifier: BSD-3-Clause
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
TEST_CASE("the witness: an edge that no digits separate from a knot is taken to be on it") {
    const Witness contact(punch("0.1", "0.5", "2"), Exact::parse("1"),
                          Load::force(Exact::parse("pi*0.005")), 30);
    const PrecisionScope scope(40);
    for (const Edge edge : {Edge::right, Edge::left}) {
        for (const char* place : {"1e-15", "1e-2"}) { // Hertz: p = sqrt(u (2/5 - u))/4
            const Exact u = Exact::parse(place);
            const Real p = contact.pressure(edge, u, Route::singular_integral).value;
            const Real exact = sqrt(Real(u.to<Real>() * (Real(2) / 5 - u.to<Real>()))) / 4;
            CHECK(abs(Real(p / exact - 1)) < Real("1e-30"));
        }
    }
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

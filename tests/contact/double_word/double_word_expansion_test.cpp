// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/double_word/double_word_expansion.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace edgeproof;

namespace {

Exact expansion_number(const char* text) { return Exact::parse(text); }

} // namespace

TEST_CASE("sums of terms and their relative errors in double words: Hertz's, by hand") {
    // p = (1/2) sqrt(u (2 - u)), so that p_n/p is the truncated binomial series of (1 - u/2)^(1/2).
    const Profile hertz = Profile::power_law(expansion_number("1"), expansion_number("1"));
    const BallContact contact(hertz, expansion_number("1"), Load::right_edge(expansion_number("1")),
                              DoubleWordPressure::contact_bits);
    const std::vector<Rational> binomial{1, Rational(-1, 4), Rational(-1, 32), Rational(-1, 128)};
    for (std::size_t n = 1; n <= 4; ++n) {
        const DoubleWordSum sum(contact, Edge::left, n);
        const DoubleWordRelativeError error(hertz, contact, Edge::left, n);
        for (const double u : {1e-60, 1e-25, 1e-8, 0.01, 0.03, 0.3, 1.0, 1.7, 1.999}) {
            CAPTURE(n);
            CAPTURE(u);
            const PrecisionScope scope(400);
            Real series(0);
            Real power(1);
            for (std::size_t k = 0; k < n; ++k) {
                series += Real(binomial[k]) * power;
                power *= Real(u);
            }
            const Real p_n = series * sqrt(Real(2 * Real(u))) / 2;
            CHECK(sum.nearest(u) == p_n.convert_to<double>());
            const Real off = abs(Real(1 - series / sqrt(Real(1 - Real(u) / 2))));
            if (off < Real(1e-200)) { // its low word would underflow
                CHECK_FALSE(error.nearest(u));
                continue;
            }
            CHECK(error.nearest(u) == off.convert_to<double>());
        }
        CHECK_FALSE(sum.nearest(2.0));
        CHECK_FALSE(sum.nearest(0.0));
        CHECK_FALSE(error.nearest(2.5));
    }
}

TEST_CASE("on a corner, where p is infinite, the relative error in double words is 1") {
    const Profile wedge = Profile::power_law(expansion_number("1"), expansion_number("0"));
    const BallContact contact(wedge, expansion_number("1"), Load::right_edge(expansion_number("1")),
                              DoubleWordPressure::contact_bits);
    const DoubleWordRelativeError error(wedge, contact, Edge::right, 2);
    CHECK(error.nearest(1.0) == 1.0);
    CHECK(error.nearest(std::nextafter(1.0, 0.0)) < 0.99);
    CHECK_FALSE(error.nearest(2.0));
}

TEST_CASE("the relative error in double words on both sides of where its series ends") {
    const Profile profile =
        Profile::flat_and_rounded(expansion_number("1/2"), expansion_number("30"));
    const Load load = Load::force(expansion_number("1e-3"));
    const BallContact contact(profile, expansion_number("7/3"), load,
                              DoubleWordPressure::contact_bits);
    const NormalContact second(profile, expansion_number("7/3"), load, 60);
    const std::vector<Real> c = second.expansion(Edge::right, 2);
    const DoubleWordRelativeError error(profile, contact, Edge::right, 2);
    const double reach = contact.reach(Edge::right).midpoint().convert_to<double>();
    for (const double part : {0.001, 0.05, 0.062, 0.063, 0.1, 0.5, 0.99}) {
        CAPTURE(part);
        const double u = reach * part;
        const PrecisionScope scope(60);
        const Real p =
            second.pressure(Edge::right, Exact::of(Rational(u)), Route::singular_integral).value;
        const Real p_2 = (c[0] + c[1] * Real(u)) * sqrt(Real(u));
        CHECK(error.nearest(u) == Real(abs(Real(1 - p_2 / p))).convert_to<double>());
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/law/shear.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using scenes::all_signs;
using scenes::exact;
using scenes::ShearCase;

namespace {

constexpr long shear_bits = 300;

ShearLoad<Ball> balls(const ShearCase& c) {
    return {Ball(exact(c.Q).rational(), shear_bits), Ball(exact(c.sigma).rational(), shear_bits)};
}

} // namespace

// The brackets of shear.hpp are exact over the rationals, and are compared with coefficients by
// hand; here Q/pi is rational.
TEST_CASE("balls of the shear's coefficients hold the exact ones, and are narrow") {
    const Rational length(9, 4); // a square, so that the root is rational
    for (const ShearCase& c : all_signs) {
        CAPTURE(c.Q);
        CAPTURE(c.sigma);
        for (const Edge edge : {Edge::right, Edge::left}) {
            const Rational over_pi = exact(c.Q).rational();
            const Rational sigma = exact(c.sigma).rational();
            const auto brackets = full_stick_brackets<Rational>(over_pi, sigma, length, edge, 12);
            const auto s = full_stick_expansion(
                Ball(length, shear_bits),
                ShearLoad<Ball>{Ball(over_pi, shear_bits) * Ball::pi(shear_bits),
                                Ball(sigma, shear_bits)},
                edge, 12);
            REQUIRE(s.size() == 12);
            for (std::size_t k = 0; k < 12; ++k) {
                const Rational exactly = brackets[k] / Rational(3, 2);
                CHECK(contains(s[k], exactly));
                CHECK(s[k].relative_accuracy_bits() > 250);
            }
        }
    }
}

TEST_CASE("balls of the traction hold the one in Real") {
    const PrecisionScope scope(60);
    const Extent<Real> e{Real(7) / 3, Real(1) / 5};
    const Ball length = Ball(Rational(7, 3), shear_bits) + Ball(Rational(1, 5), shear_bits);
    for (const ShearCase& c : all_signs) {
        const ShearLoad<Real> load{exact(c.Q).to<Real>(), exact(c.sigma).to<Real>()};
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const char* u : {"1e-20", "0.001", "0.7", "2.5"}) {
                const Real value =
                    full_stick_traction(point_at(e, edge, exact(u).to<Real>()), load);
                const Ball q = full_stick_traction(length, balls(c), edge,
                                                   Ball(exact(u).rational(), shear_bits));
                CHECK(overlaps(
                    q, Ball::around(value, Real(abs(value) * pow(Real(10), -55)), shear_bits)));
                CHECK(q.relative_accuracy_bits() > 250);
            }
        }
    }
    CHECK_FALSE(full_stick_traction(length, balls(all_signs[0]), Edge::right, length).is_finite());
}

TEST_CASE("an edge given on a knot exactly is expanded from inside the contact") {
    // Inside, the contact is the wedge's, with g' = -+1/10; the slope beyond has no effect.
    const Symbols x{"x"};
    const Profile knotted = Profile::piecewise_symmetric(
        {exact("1/3")}, {parse("1/10", x), parse("1/10 + (x - 1/3)", x)});
    const Profile plain = Profile::power_law(exact("1/10"), exact("0"));
    const Load load = Load::right_edge(exact("1/3"));
    const BallContact on(knotted, exact("7/3"), load, shear_bits);
    const BallContact without(plain, exact("7/3"), load, shear_bits);
    for (const Edge edge : {Edge::right, Edge::left}) {
        const auto c = on.expansion(edge, 6);
        const auto d = without.expansion(edge, 6);
        for (std::size_t k = 0; k < 6; ++k) {
            CHECK(overlaps(c[k], d[k]));
            CHECK(c[k].relative_accuracy_bits() > 200);
        }
        CHECK(overlaps(on.pressure(edge, exact("1/5")), without.pressure(edge, exact("1/5"))));
    }
    CHECK(overlaps(on.force(), without.force()));
}

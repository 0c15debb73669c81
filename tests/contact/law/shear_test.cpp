// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "tests/contact/forward.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using scenes::agree;
using scenes::all_signs;
using scenes::exact;
using scenes::ShearCase;

namespace {

constexpr long shear_bits = 300;

ShearLoad<Ball> balls(const ShearCase& c) {
    return {Ball(exact(c.Q).rational(), shear_bits), Ball(exact(c.sigma).rational(), shear_bits)};
}

} // namespace

TEST_CASE("full stick: the integral equation gives the tension, the resultant gives Q") {
    const PrecisionScope scope(50);
    for (const Extent<Real>& e :
         {Extent<Real>{Real(3) / 2, Real(3) / 2}, Extent<Real>{Real(7) / 3, Real(1) / 5},
          Extent<Real>{Real("1e-6"), Real(40)}}) {
        for (const ShearCase& c : all_signs) {
            const ShearLoad<Real> load{exact(c.Q).to<Real>(), exact(c.sigma).to<Real>()};
            const auto q = [&](const Point<Real>& at) { return full_stick_traction(at, load); };
            CAPTURE(c.Q);
            CAPTURE(c.sigma);
            // Relative to the size of the integrand, because the tension's own resultant is zero.
            const Real size = abs(load.Q) + abs(load.bulk_tension) * e.length();
            const auto Q = resultant(e, q, 40);
            REQUIRE(Q.converged);
            CHECK(abs(Real(Q.value - load.Q)) < size * Real("1e-38"));
            for (const char* fraction : {"1e-3", "0.2", "0.5", "0.77", "0.999"}) {
                const Real u = exact(fraction).to<Real>() * e.length();
                const Point<Real> at = point_at(e, Edge::right, u);
                const auto strain = principal_value(e, at, q, 34);
                REQUIRE(strain.converged);
                const Real expected = pi<Real>() * load.bulk_tension / 4;
                const Real around = size / sqrt(Real(at.right * at.left)) *
                                    (e.length() / (at.right < at.left ? at.right : at.left));
                CHECK(abs(Real(strain.value - expected)) < around * Real("1e-31"));
            }
        }
    }
}

TEST_CASE("the same code in every arithmetic") {
    const auto check = [](auto zero, double tolerance) {
        using std::abs;
        using std::sqrt;
        using T = decltype(zero);
        const Extent<T> e{T(3), T(1)};
        const ShearLoad<T> load{T(2), T(-1)};
        const Point<T> at = point_at(e, Edge::left, T(T(1) / T(8)));
        // Computed by hand: x = -7/8, r = 31/8, l = 1/8: (2/pi + 15/32)/(sqrt(31)/8).
        const T expected = (T(2) / pi<T>() + T(15) / T(32)) * T(8) / sqrt(T(31));
        CHECK(static_cast<double>(abs(T(full_stick_traction(at, load) - expected))) < tolerance);
        const auto s = full_stick_expansion(e.length(), load, Edge::right, 3);
        // K_II = (Q/pi + sigma_0 (a+b)/8)/sqrt(a+b)
        CHECK(static_cast<double>(abs(T(s[0] - (T(2) / pi<T>() - T(1) / T(2)) / T(2)))) <
              tolerance);
    };
    check(0.0, 1e-15);
    const PrecisionScope scope(80);
    check(Real(0), 1e-78);
}

// Expanded by hand from (1 - z)^(-1/2) = 1 + z/2 + 3 z^2/8 + 5 z^3/16 + ...
TEST_CASE("the brackets over the rationals") {
    const Rational Q(3);
    const Rational sigma(5);
    const Rational D(7);
    for (const Edge edge : {Edge::right, Edge::left}) {
        const Rational s(edge == Edge::right ? 1 : -1);
        const auto k = full_stick_brackets<Rational>(Q, sigma, D, edge, 4);
        const Rational lead = Q + s * sigma * D / 8;
        CHECK(k[0] == lead);
        CHECK(k[1] == lead / (2 * D) - s * sigma / 4);
        CHECK(k[2] == lead * 3 / (8 * D * D) - s * sigma / (8 * D));
        CHECK(k[3] == lead * 5 / (16 * D * D * D) - s * sigma * 3 / (32 * D * D));
    }
    CHECK(full_stick_brackets<Rational>(Q, sigma, D, Edge::left, 0).empty());
}

TEST_CASE("expansions converge to the traction; a mirror changes the sign of the tension") {
    const PrecisionScope scope(60);
    const Extent<Real> e{Real(7) / 3, Real(1) / 5};
    for (const ShearCase& c : all_signs) {
        const ShearLoad<Real> load{exact(c.Q).to<Real>(), exact(c.sigma).to<Real>()};
        for (const Edge edge : {Edge::right, Edge::left}) {
            const auto s = full_stick_expansion(e.length(), load, edge, 40);
            const Real u = e.length() / 1000;
            Real sum = 0;
            for (std::size_t k = s.size(); k-- > 0;) {
                sum = sum * u + s[k];
            }
            CHECK(agree(Real(sum / sqrt(u)), full_stick_traction(point_at(e, edge, u), load), 55));
            const auto mirrored = full_stick_expansion(
                e.length(), ShearLoad<Real>{load.Q, Real(-load.bulk_tension)}, opposite(edge), 40);
            CHECK(s == mirrored);
        }
    }
}

TEST_CASE("the loading at which a coefficient vanishes, and at which edge") {
    const PrecisionScope scope(60);
    const Real D = Real(7) / 5;
    for (std::size_t k = 0; k < 6; ++k) {
        for (const int Q : {2, -2}) {
            for (const int sense : {1, -1}) {
                // |r_k| = |2k - 1|/(2k + 1), from the ratio 2k/(2k - 1) of neighbouring binomials.
                const int n = static_cast<int>(2 * k);
                const Real r = Real(abs(n - 1)) / (n + 1);
                const Real sigma = 8 / pi<Real>() * r * Q * sense / D;
                const ShearLoad<Real> load{Real(Q), sigma};
                // It is the right edge if Q and sigma_0 have the same sign, except for k = 0.
                const Edge edge = (k == 0) == (sense > 0) ? Edge::left : Edge::right;
                const auto here = full_stick_expansion(D, load, edge, k + 1);
                const auto there = full_stick_expansion(D, load, opposite(edge), k + 1);
                CHECK(abs(here[k]) < Real("1e-57"));
                CHECK(abs(there[k]) > Real("1e-3"));
            }
        }
    }
}

TEST_CASE("equal signs at both edges, for both signs of Q and of the tension") {
    const PrecisionScope scope(40);
    const Real D = 3;
    const Real limit = 8 / pi<Real>() / D;
    for (const int Q : {1, -1}) {
        for (const int sense : {1, -1}) {
            for (const char* part : {"0.5", "0.999999", "1.000001", "3"}) {
                const ShearLoad<Real> load{Real(Q), Real(limit * exact(part).to<Real>() * sense)};
                const Real right = full_stick_expansion(D, load, Edge::right, 1)[0];
                const Real left = full_stick_expansion(D, load, Edge::left, 1)[0];
                CHECK(same_sign_at_both_edges(D, load) == (right * left > 0));
            }
        }
    }
    CHECK_FALSE(same_sign_at_both_edges(D, ShearLoad<Real>{Real(0), Real(1)}));
}

TEST_CASE("P and Q that grow together: the sum of increments is similar to the pressure") {
    for (const auto& c : {scenes::symmetric()[4], scenes::tilted()[0], scenes::tilted()[5]}) {
        CAPTURE(c.name);
        const BallContact contact(c.profile, c.modulus, c.load, shear_bits);
        const PrecisionScope scope(50);
        const Real a = c.load.value.to<Real>();
        const Real u = a / 30; // no knot is passed
        // Increments dQ/(pi w) while the edge moves from x to a; Q(s) = (Q/P) P(s).
        const Real x = a - u;
        const Real rate = Real(-7) / 10 / contact.force().midpoint();
        const auto sum = integrate_one_sided<Real>(
            [&](const Real& lo, const Real&) {
                const BallContact then = contact.with_right_edge(Ball(Real(x + lo), shear_bits));
                const Real force_rate = at_working_precision(then.force_rate().midpoint());
                const Point<Real> at{lo, Real(x + at_working_precision(then.b().midpoint())), x};
                return full_stick_traction(at, ShearLoad<Real>{Real(rate * force_rate), Real(0)});
            },
            u, Real(0), true, {.target_digits = 25});
        REQUIRE(sum.converged);
        const Ball p = contact.pressure(Edge::right, Ball(u, shear_bits));
        CHECK(agree(sum.value, Real(rate * p.midpoint()), 20));
    }
}

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

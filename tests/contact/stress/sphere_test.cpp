// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"
#include "edgeproof/contact/stress/axisymmetric_stress.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <vector>

/// The stresses below a sphere in closed form, and the proof by branch and bound that mises and
/// tau_max are greatest on the axis for every Poisson's ratio (docs/axisymmetric.md, "The greatest
/// stresses"), on which greatest_value() relies. Lengths in the radius of the contact, stresses in
/// the greatest pressure.
namespace {

using namespace edgeproof;
using namespace edgeproof::contact;

constexpr long lemma_bits = 96;

Ball number(double x) { return {Real(x), lemma_bits}; }
Ball between(double lo, double hi) { return Ball::hull(number(lo), number(hi)); }

/// A value and its derivative by r^2.
struct Dual {
    Ball value;
    Ball rate;
    friend Dual operator+(const Dual& x, const Dual& y) {
        return {x.value + y.value, x.rate + y.rate};
    }
    friend Dual operator-(const Dual& x, const Dual& y) {
        return {x.value - y.value, x.rate - y.rate};
    }
    friend Dual operator*(const Dual& x, const Ball& c) { return {x.value * c, x.rate * c}; }
    friend Dual operator*(const Dual& x, const Dual& y) {
        return {x.value * y.value, x.rate * y.value + x.value * y.rate};
    }
};
Dual square(const Dual& x) { return {pow_int(x.value, 2), x.value * x.rate * 2}; }
Dual imaginary(const Box& value, const Box& rate) { return {value.imaginary(), rate.imaginary()}; }

/// The root of a box with a real part >= 0, also if it contains 0.
Box root(const Box& x) {
    const Ball s = sqrt(upper_end(abs(x)));
    return x.contains_zero() ? Box(Ball::hull(s * 0, s), Ball::hull(-s, s)) : principal_root(x);
}

/// The squares of mises and of the greatest shear stress in the plane, and tau_max across it.
struct Stresses {
    Dual mises;
    Dual in_plane;
    Dual across;
};

/// For all places of a rectangle r x z and all c = 1 - 2 nu of a ball. With tau = z + i, R^2 = r^2
/// + tau^2, S = R + tau and h' = s the integrals of docs/axisymmetric.md, "Inside the body", are
/// imaginary parts of z Phi - T at tau, with Phi' = f, T' = tau f for each integrand f.
Stresses stresses(const Ball& r, const Ball& z, const Ball& c) {
    const Ball one(1, lemma_bits);
    const Box i(one * 0, one);
    const Box tau(z, one);
    const Box R = root(Box(z, one - r)) * root(Box(z, one + r));
    const Box S = R + tau;
    const Box lnS = log1p(S - one);
    const Box half(one / 2);
    const Box inverse = Box(one) / R;
    const Box dR = half * inverse; // by r^2
    const Box dS = dR / S;         // of lnS
    // |R|^2 >= z (1 + r)
    Box z_over_R = inverse * z;
    if (!z_over_R.is_finite()) {
        const Ball most = up_to(sqrt(upper_end(z) / (1 + lower_end(r))));
        z_over_R = Box(most, most);
    }
    const Dual I = imaginary(lnS * z - R, dS * z - dR);
    const Box cubic = R * R + R * tau + tau * tau;
    const Box third(one / 3);
    const Dual M =
        imaginary((lnS + tau / S) * half * z - cubic / S * third,
                  (dS - tau * dR / (S * S)) * half * z -
                      ((R * dR * (one * 2) + tau * dR) / S - cubic * dR / (S * S)) * third);
    const Dual J = imaginary(z_over_R * (Box(one) - Box(z) / S), // z J
                             z_over_R * (Box(z) * dR * (S + R) / (R * S * S) - dR / R));
    const Dual K = imaginary(i * z_over_R - lnS * z, -(i * z_over_R * dR / R) - dS * z);
    const Dual L = imaginary(((i - Box(z)) / S - lnS) * half * z,
                             (-((i - Box(z)) * dR / (S * S)) - dS) * half * z);
    const Dual xz = L - K * (one * 2) - M * c;                    // sxx - szz
    const Dual xy = L * (one * 2) - K + (I - M * (one * 2)) * c;  // sxx - syy
    const Dual yz = Dual{one * 0, one * 0} - K - L - (I - M) * c; // syy - szz
    const Dual shear = square(J) * Dual{r * r, one};              // sxz^2
    const Dual in_plane = square(xz) * (one / 4) + shear;
    const Ball root_of = Field<Ball>::root(in_plane.value);
    const Dual E = (xy - yz) * (one / 2); // (sxx + szz)/2 - syy
    const Dual size = certainly_negative(E.value)   ? E * -one
                      : certainly_positive(E.value) ? E
                                                    : Dual{abs(E.value), unknown_ball(lemma_bits)};
    return {(square(xz) + square(xy) + square(yz)) * (one / 2) + shear * (one * 3), in_plane,
            (size + Dual{root_of, in_plane.rate / (root_of * 2)}) * (one / 2)};
}

/// True if f is less than `most` over the rectangle, or decreases with r: then its greatest value
/// over all places, if that is at least `most`, is on the axis.
bool decided(const Dual& f, const Ball& most) {
    return (f.value.is_finite() && certainly_less(f.value, most)) ||
           (f.rate.is_finite() && certainly_negative(f.rate));
}

struct Rectangle {
    double r;
    double z;
    double half;
};

} // namespace

TEST_CASE("the stresses below a sphere in closed form: on the axis, at the edge, and inside") {
    // On the axis sxx - szz is that of johnson1985, eq. 3.45; at the edge the stress is pure shear.
    for (const double nu : {0.0, 0.25, 0.3, 0.5}) {
        const Ball c = 1 - number(nu) * 2;
        const Ball z = number(0.5);
        const Stresses at = stresses(number(0), z, c);
        const Ball depth = 1 - z * atan(1 / z);
        const Ball across = -(1 + number(nu)) * depth + 1 / ((1 + z * z) * 2);
        const Ball difference = across + 1 / (1 + z * z);
        CHECK(overlaps(sqrt(at.mises.value), abs(difference)));
        CHECK(overlaps(sqrt(at.in_plane.value), abs(difference) / 2));
        CHECK(at.mises.value.radius() < Real("1e-20"));
        const Ball at_edge = c / 3;
        const Stresses edge = stresses(number(1), number(0), c);
        CHECK(overlaps(edge.across.value, at_edge));
    }
    // Inside, by rigorous integration: g' = x and E* = pi/2 have these units.
    const auto exact = [](const char* text) { return Exact::parse(text); };
    const AxisymmetricContact sphere(Profile::power_law(exact("1"), exact("1")).revolved(),
                                     exact("pi/2"), Load::right_edge(exact("1")), lemma_bits);
    for (const double nu : {0.0, 0.25, 0.5}) {
        const Ball r = number(0.75);
        const Ball z = number(0.375);
        const StressState state =
            AxisymmetricStress(sphere, sphere.force(), number(nu)).inside(r, z);
        const Stresses at = stresses(r, z, 1 - number(nu) * 2);
        CHECK(overlaps(sqrt(at.mises.value), state.mises(number(nu))));
        CHECK(overlaps(max(sqrt(at.in_plane.value), at.across.value), state.tau_max()));
        CHECK(state.tau_max().radius() < Real("1e-18"));
    }
}

TEST_CASE("below a sphere mises and tau_max are greatest on the axis, for every Poisson's ratio" *
          doctest::test_suite("slow")) {
    // Beyond r = 4 or z = 3 every point load of the contact is farther than 3. Its mises is at most
    // 5.6 P/(2 pi d^2) (johnson1985, eq. 3.19), tau_max at most mises/sqrt(3); P = 2 pi/3.
    const Ball far = number(5.6) / 3 / 9;
    constexpr int parts = 16; // of the range of 1 - 2 nu
    constexpr double smallest = 0x1p-18;
    for (int k = 0; k < parts; ++k) {
        const Ball c = between(static_cast<double>(k) / parts, static_cast<double>(k + 1) / parts);
        Ball mises(0, lemma_bits);
        Ball tau(0, lemma_bits);
        for (const double z : {0.36, 0.4, 0.44, 0.48, 0.52, 0.56}) {
            const Stresses at = stresses(number(0), number(z), c);
            mises = max(mises, lower_end(at.mises.value));
            tau = max(tau, lower_end(sqrt(at.in_plane.value)));
        }
        REQUIRE(certainly_less(far, sqrt(mises)));
        REQUIRE(certainly_less(far / sqrt(number(3)), tau));
        std::vector<Rectangle> open;
        for (const double r : {0.5, 1.5, 2.5, 3.5}) {
            for (const double z : {0.5, 1.5, 2.5}) {
                open.push_back({r, z, 0.5});
            }
        }
        std::size_t undecided = 0;
        while (!open.empty()) {
            const Rectangle box = open.back();
            open.pop_back();
            const Stresses at = stresses(between(box.r - box.half, box.r + box.half),
                                         between(box.z - box.half, box.z + box.half), c);
            if (decided(at.mises, mises) && decided(at.in_plane, tau * tau) &&
                decided(at.across, tau)) {
                continue;
            }
            const double h = box.half / 2;
            if (h < smallest) {
                ++undecided;
                continue;
            }
            for (const double r : {box.r - h, box.r + h}) {
                for (const double z : {box.z - h, box.z + h}) {
                    open.push_back({r, z, h});
                }
            }
        }
        CHECK(undecided == 0);
    }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/greatest_stress.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/split_mix.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr long greatest_bits = 128;
constexpr std::size_t greatest_boxes = 60'000;

Ball greatest_ball(const std::string& text) {
    return formula::enclosed_constant(scenes::exact(text), greatest_bits);
}

struct SmoothContact {
    std::string name;
    std::shared_ptr<const PlaneContact> plane;
    std::vector<Ball> knots;
    [[nodiscard]] const PlaneContact& contact() const { return *plane; }
};

/// Contacts without a corner, of scenes.hpp and power laws of other exponents.
std::vector<SmoothContact> smooth_contacts() {
    std::vector<scenes::Contact> all = scenes::symmetric();
    for (const scenes::Contact& c : scenes::tilted()) {
        all.push_back(c);
    }
    for (const std::string m : {"2", "5/2", "4"}) {
        all.push_back(scenes::contact_of("power-law C=3/7 a=5/4 m=" + m));
    }
    std::vector<SmoothContact> smooth;
    for (const scenes::Contact& c : all) {
        const bool corner =
            c.name.find("wedge") != std::string::npos || c.name.find(" m=0 ") != std::string::npos;
        if (!corner) {
            const auto closed =
                std::make_shared<BallContact>(c.profile, c.modulus, c.load, greatest_bits);
            smooth.push_back({c.name, closed, closed->slope().knots});
        }
    }
    const std::vector<Ball> origin{greatest_ball("0")};
    const std::vector<Ball> knots{greatest_ball("-1/4"), greatest_ball("0"), greatest_ball("1/4")};
    const auto add_curved = [&](const std::string& words, const std::vector<Ball>& at) {
        const auto [name, profile, modulus, load] = scenes::contact_of(words + " a=1 E=1");
        const auto whole =
            std::make_shared<IntegratedContact>(profile, modulus, load, greatest_bits);
        smooth.push_back({"curved " + name, whole, at});
        smooth.push_back(
            {"curved zone " + name, whole->zone(greatest_ball("1/2"), greatest_ball("1/3")), at});
    };
    add_curved("piecewise symmetric slopes=x+x^3", origin);
    add_curved("piecewise symmetric knots=1/4 slopes=0;(x-1/4)^2", knots);
    add_curved("piecewise knots=0 slopes=x/2;sinh(x)", origin);
    return smooth;
}

double unit_number(SplitMix64& random) {
    return static_cast<double>(random.next() >> 11) * 0x1p-53;
}

/// A power of two in units of the length of the contact.
Ball dyadic_part(const PlaneContact& c, double part) {
    return Ball(Real(std::ldexp(part, std::ilogb(c.a().midpoint().convert_to<double>()))),
                greatest_bits);
}

/// A box [x - r, x + r] x [z, z + 2 r] with r a power of two; z = 0 is exact.
struct DrawnBox {
    double x;
    double z;
    double r;
    [[nodiscard]] Box all(const PlaneContact& c) const {
        Ball across = dyadic_part(c, x);
        Ball down = dyadic_part(c, z + r);
        const long scale = std::ilogb(c.a().midpoint().convert_to<double>());
        mag_set_ui_2exp_si(arb_radref(across.data()), 1, std::ilogb(r) + scale);
        mag_set_ui_2exp_si(arb_radref(down.data()), 1, std::ilogb(r) + scale);
        return {across, down};
    }
    [[nodiscard]] Box point(const PlaneContact& c, double s, double t) const {
        return {dyadic_part(c, x + r * (2 * s - 1)), dyadic_part(c, z + 2 * r * t)};
    }
};

} // namespace

// The Cauchy integral itself is compared with quadratures of the tractions in
// tests/scene/stress_relations_test.cpp.
TEST_CASE("each derivative of the Cauchy integral is the rate of the one before") {
    for (const SmoothContact& one : smooth_contacts()) {
        CAPTURE(one.name);
        const PlaneContact& c = one.contact();
        const Box zeta = Box(c.a() * greatest_ball("2/7"), c.a() * greatest_ball("5/6")).middle();
        const Ball h = dyadic_part(c, 0x1p-24);
        const CauchyDerivatives t = c.cauchy_derivatives(zeta);
        const CauchyDerivatives ahead = c.cauchy_derivatives(zeta + h);
        const CauchyDerivatives behind = c.cauchy_derivatives(zeta - h);
        const CauchyIntegral exact = c.cauchy_integral(zeta);
        const auto small = [](const Box& x, const Ball& size) {
            return certainly_less(abs(x), size);
        };
        Ball scale =
            c.force() / zeta.imaginary(); // at least the size of T, then of its derivatives
        CHECK(small(t[0] - exact.value, scale * greatest_ball("1e-20")));
        for (long n = 1; n < 4; ++n) {
            CAPTURE(n);
            const auto k = static_cast<std::size_t>(n);
            scale = scale * n / zeta.imaginary();
            const Box rate = (ahead[k - 1] - behind[k - 1]) / (h * 2);
            CHECK(small(t[k] - rate, scale * greatest_ball("1e-11")));
            CHECK(Ball(abs(t[k])).radius() < Ball(scale * greatest_ball("1e-20")).lower());
        }
        CHECK(small(t[1] - exact.derivative, scale * greatest_ball("1e-20")));
    }
}

TEST_CASE("bounds over boxes contain the values at their points, and become narrow") {
    SplitMix64 random(20261125);
    std::size_t narrow = 0;
    std::size_t wide = 0;
    for (const SmoothContact& one : smooth_contacts()) {
        const std::string& name = one.name; // clang 14: lambdas capture no structured bindings
        const PlaneContact& c = one.contact();
        if (name.starts_with("power-law m=10")) {
            continue; // boxes near the origin must be smaller
        }
        CAPTURE(name);
        const double unit = std::ldexp(1, std::ilogb(c.a().midpoint().convert_to<double>()));
        std::vector<double> places{c.a().midpoint().convert_to<double>() / unit,
                                   -c.b().midpoint().convert_to<double>() / unit, 0, 0.4};
        for (const Ball& knot : one.knots) {
            places.push_back(knot.midpoint().convert_to<double>() / unit);
        }
        for (int i = 0; i < 60; ++i) {
            const double r = std::ldexp(1, -static_cast<int>(random.below(40)));
            const double x = places[random.below(places.size())] +
                             (static_cast<double>(random.below(3)) - 1) * r / 3;
            const DrawnBox box{x, random.below(2) == 0 ? 0.0 : unit_number(random) * r, r};
            CAPTURE(box.x);
            CAPTURE(box.z);
            CAPTURE(box.r);
            const Box all = box.all(c);
            const CauchyBounds bounds = c.cauchy_bounds(all);
            const CauchyDerivatives derivatives = c.cauchy_derivatives(all);
            const Box point = box.point(c, unit_number(random), 1 - unit_number(random) / 2);
            const CauchyIntegral exact = c.cauchy_integral(point);
            const Box with_depth = exact.derivative * point.imaginary();
            if (bounds.value.is_finite()) {
                CHECK(overlaps(bounds.value.real(), exact.value.real()));
                CHECK(overlaps(bounds.value.imaginary(), exact.value.imaginary()));
            }
            if (bounds.with_depth.is_finite()) {
                CHECK(overlaps(bounds.with_depth.real(), with_depth.real()));
                CHECK(overlaps(bounds.with_depth.imaginary(), with_depth.imaginary()));
            }
            const CauchyDerivatives there = c.cauchy_derivatives(point);
            for (std::size_t n = 0; n < there.size(); ++n) {
                if (derivatives[n].is_finite()) {
                    CHECK(overlaps(derivatives[n].real(), there[n].real()));
                    CHECK(overlaps(derivatives[n].imaginary(), there[n].imaginary()));
                }
            }
            if (r < 1e-9) {
                const Ball scale = c.force() / c.a() + abs(exact.value);
                ++(bounds.value.is_finite() && bounds.with_depth.is_finite() &&
                           certainly_less(Ball(abs(bounds.with_depth).upper(), greatest_bits),
                                          scale / 10)
                       ? narrow
                       : wide);
            }
        }
    }
    CAPTURE(narrow);
    CAPTURE(wide);
    CHECK(narrow > 5 * wide);
}

TEST_CASE("a budget of boxes that does not suffice is refused with the limits") {
    const SmoothContact c = smooth_contacts().front(); // a cylinder
    const StressField field{.parts = {{c.plane, Ball(1, greatest_bits), Ball(0, greatest_bits)}},
                            .bulk = Ball(0, greatest_bits)};
    const StressMeasure F(field, {});
    CHECK_THROWS_AS((void)greatest_stress(F, 10), BudgetError);
    CHECK(greatest_stress(F, greatest_boxes).places.size() == 1);
}

TEST_CASE("next to a corner of a curved slope nothing bounds the Cauchy integral") {
    const IntegratedContact c(scenes::curve("", "1/10 + sinh(x)", true), scenes::exact("1"),
                              Load::right_edge(scenes::exact("1")), greatest_bits);
    for (const char* const size : {"1/100", "1/100000"}) {
        const Ball h = greatest_ball(size);
        const CauchyBounds bounds =
            c.cauchy_bounds(Box(Ball::hull(-h, h), Ball::hull(Ball(0, greatest_bits), h)));
        CHECK_FALSE(bounds.value.is_finite());
        CHECK_FALSE(bounds.with_depth.is_finite());
    }
}

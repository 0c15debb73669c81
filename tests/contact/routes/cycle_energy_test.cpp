// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/partial_slip.hpp"

#include "edgeproof/contact/stress/dissipation.hpp"
#include "tests/contact/slip_scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

using scenes::size_cases, scenes::Slipping, scenes::slipping;

namespace {

constexpr long cycle_bits = 256;

Real energy_in_real(const Slipping& s, const Profile& profile, const char* modulus, const char* a,
                    const char* tau) {
    const NormalContact contact(Profile(profile), scenes::exact(modulus),
                                Load::right_edge(scenes::exact(a)), 26);
    ShearSpec shear;
    const Ball Q = formula::enclosed_constant(scenes::exact(tau), cycle_bits) *
                   Ball(Rational(3, 5), cycle_bits) * s.force();
    shear.Q = scenes::exact(Q.midpoint().str(60));
    shear.bulk_tension = scenes::exact("0");
    shear.friction = scenes::exact("3/5");
    const PartialSlip slip(contact, shear);
    return cycle_energy(contact, slip, *shear.friction);
}

bool within(const Real& x, const Real& y, const char* relative) {
    const PrecisionScope scope(40);
    return abs(Real(x / y - 1)) < Real(relative);
}

} // namespace

// tests/contact/stress/cycle_energy_test.cpp gives the source of the value of the tilted punch.
TEST_CASE("the energy of a cycle by quadrature: a tilted punch, and closed forms") {
    const PrecisionScope scope(40);
    for (const scenes::SizeCase& c : size_cases()) {
        const bool punch = c.name == "tilted flat and rounded";
        if (!punch && c.name != "tilted wedge" && c.name != "cubic") {
            continue;
        }
        CAPTURE(c.name);
        const Slipping s = slipping(c.profile, c.modulus, c.a, "3/10", c.r, cycle_bits);
        const Real W = energy_in_real(s, c.profile, c.modulus, c.a, "3/10");
        const Real expected =
            punch ? Real("0.0775464093049073581084124865")
                  : similar_cycle_energy(*s.slip, Ball(c.name == "cubic" ? 4 : 1, cycle_bits))
                        .midpoint();
        CHECK(within(W, expected, "1e-24"));
    }
}

TEST_CASE("the energy of a cycle by quadrature keeps its digits under little shear") {
    const PrecisionScope scope(40);
    for (const scenes::SizeCase& c : size_cases()) {
        if (c.name != "tilted wedge") {
            continue;
        }
        const char* tau = "1e-30";
        const Slipping s = slipping(c.profile, c.modulus, c.a, tau, "0", 2 * cycle_bits);
        const Ball closed = similar_cycle_energy(*s.slip, Ball(1, 2 * cycle_bits));
        CHECK(
            within(energy_in_real(s, c.profile, c.modulus, c.a, tau), closed.midpoint(), "1e-24"));
    }
}

TEST_CASE("the energy of a cycle in balls and by quadrature agree where slip passes a knot") {
    const formula::Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {scenes::exact("1/2")}, {formula::parse("x/10", x), formula::parse("x - 9/20", x)});
    const Slipping s = slipping(profile, "1", "3/5", "9/10", "0", cycle_bits);
    REQUIRE(certainly_less(s.slip->stick().a, Ball(Rational(1, 2), cycle_bits)));
    const Real in_balls = cycle_energy(*s.slip, growth_of(*s.of->closed_form())).midpoint();
    CHECK(within(energy_in_real(s, profile, "1", "3/5", "9/10"), in_balls, "1e-24"));
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("the energy of a cycle by quadrature where slip passes corners") {
    const formula::Symbols x{"x"};
    const Profile profile = Profile::piecewise_symmetric(
        {scenes::exact("1/2")}, {formula::parse("x/10", x), formula::parse("x/10 + 1/5", x)});
    const Slipping s = slipping(profile, "1", "3/5", "99/100", "0", cycle_bits);
    REQUIRE(certainly_less(s.slip->stick().a, Ball(Rational(1, 2), cycle_bits)));
    const Real in_balls = cycle_energy(*s.slip, growth_of(*s.of->closed_form())).midpoint();
    CHECK(within(energy_in_real(s, profile, "1", "3/5", "99/100"), in_balls, "1e-24"));
}

TEST_SUITE_END();

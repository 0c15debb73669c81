// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/plane_stress.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "tests/contact/scenes.hpp"

#include <doctest/doctest.h>

namespace {

constexpr long stress_bits = 200;

Ball stress_ball(const char* text) {
    return formula::enclosed_constant(scenes::exact(text), stress_bits);
}

} // namespace

// For g' = x + x^3, E* = 1 and the edges -1 and 1 the pressure is (x^2 + 3/2) sqrt(1 - x^2)/2,
// since g' is the polynomial part of (x^2 + 3/2) sqrt(x^2 - 1) at infinity.
TEST_CASE("the Cauchy integral of a curved slope has its digits next to an edge") {
    const scenes::Contact cubic = scenes::contact_of("piecewise symmetric slopes=x+x^3 a=1 E=1");
    const IntegratedContact contact(cubic.profile, cubic.modulus, cubic.load, stress_bits);
    const char* const places[][2] = {{"1", "1e-8"},   {"1", "1e-9"},          {"1", "1e-30"},
                                     {"-1", "1e-30"}, {"1 + 1e-12", "1e-20"}, {"999/1000", "1e-9"}};
    for (const auto& place : places) {
        CAPTURE(std::string(place[0]));
        CAPTURE(std::string(place[1]));
        const Box zeta(stress_ball(place[0]), stress_ball(place[1]));
        const Box root = root_outside({Ball(1, stress_bits), Ball(1, stress_bits)}, zeta);
        const Box square = zeta * zeta;
        const Ball half_pi = Ball::pi(stress_bits) / 2;
        const Box factor = square + Box(stress_ball("3/2"));
        const Box value = (zeta + zeta * square - factor * root) * half_pi;
        const Box rate = (square * Ball(3, stress_bits) + 1 - zeta * root * Ball(2, stress_bits) -
                          factor * zeta / root) *
                         half_pi;
        const CauchyIntegral here = contact.cauchy_integral(zeta, {});
        CHECK(abs(here.value - value).upper() < Real("1e-40"));
        CHECK(abs(here.derivative - rate).upper() < Real("1e-25") * abs(rate).lower());
    }
}

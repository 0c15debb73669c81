// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/dissipation.hpp"

#include "tests/contact/slip_scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using scenes::size_cases, scenes::Slipping, scenes::slipping;

namespace {

constexpr long energy_bits = 192;

Slipping upright(const std::string& name, const char* tau = "3/10") {
    for (const scenes::SizeCase& c : size_cases()) {
        if (c.name == name) {
            return slipping(c.profile, c.modulus, c.a, tau, "0", energy_bits);
        }
    }
    throw Error("no such case: " + name);
}

Ball number(const char* text) {
    return formula::enclosed_constant(scenes::exact(text), energy_bits);
}

} // namespace

// mpmath 1.3 at 30 digits, f = 3/5, tau = 3/10: 4 f^2 times the integral over both slip zones of p
// times the gap of the contact under P - Q/f, which is the slip over 2 f. p and the gap's slope by
// Gauss-Legendre from g' alone (eqn:SIEPressure), the gap by integrating the polynomial through its
// slope at 32 points of each piece; 20 points agree to 26 digits.
TEST_CASE("the energy of a cycle is slip times traction over the slip zones") {
    const std::pair<const char*, const char*> cases[] = {
        {"Hertz", "0.00150632623324495620139399268"},
        {"flat and rounded", "0.00058844869970052064993547324"},
        {"tilted flat and rounded", "0.0775464093049073581084124865"},
    };
    for (const auto& [which, value] : cases) {
        const char* const name = which; // clang's CAPTURE takes no structured binding
        CAPTURE(name);
        const Slipping s = upright(name);
        const Ball W = cycle_energy(*s.slip, growth_of(*s.of->closed_form()));
        CHECK(certainly_less(abs(Ball(W / number(value) - 1)), number("2e-26")));
        CHECK(W.relative_accuracy_bits() > energy_bits * 3 / 4);
    }
}

// mpmath at 25 digits: 8 f^2/(pi E*) times the integral of (P - L)(L - L_s) dD/D over the right
// edge, where b, P and dD/da are integrals of g' alone, in parts between the knots that the edges
// pass (two of them corners): 16 digits agree from one level of quadrature to the next.
TEST_CASE("the energy of a cycle where the slip zones contain corners and knots") {
    const Symbols x{"x"};
    std::vector<Expr> slopes;
    for (const char* slope : {"2/5 + x/4", "x/10 - 1/20", "-1/5", "x/5", "x/10", "3*x/10 - 1/5",
                              "x/20 + 2/5", "x/5 + 1/40"}) {
        slopes.push_back(parse(slope, x));
    }
    std::vector<Exact> knots;
    for (const char* knot : {"-3", "-2", "-1", "0", "1", "2", "5/2"}) {
        knots.push_back(scenes::exact(knot));
    }
    const Slipping s =
        slipping(Profile::piecewise(knots, slopes), "2", "3", "17/20", "0", energy_bits);
    const Ball W = cycle_energy(*s.slip, growth_of(*s.of->closed_form()));
    CHECK(certainly_less(abs(Ball(W / number("0.3994889352862168") - 1)), number("1e-15")));
    CHECK(W.relative_accuracy_bits() > energy_bits * 3 / 4);
}

TEST_CASE("the closed form of linear pieces is that of similar contacts") {
    const std::pair<const char*, long> cases[] = {{"Hertz", 2}, {"wedge", 1}, {"tilted wedge", 1}};
    for (const auto& [which, power] : cases) {
        const char* const name = which;
        for (const char* tau : {"1e-9", "3/10", "999/1000"}) {
            CAPTURE(name);
            CAPTURE(tau);
            const Slipping s = upright(name, tau);
            const Ball by_pieces = cycle_energy(*s.slip, growth_of(*s.of->closed_form()));
            const Ball closed = similar_cycle_energy(*s.slip, Ball(power, energy_bits));
            CHECK(overlaps(by_pieces, closed));
            CHECK(by_pieces.relative_accuracy_bits() > energy_bits / 3);
            CHECK(closed.relative_accuracy_bits() > energy_bits / 3);
        }
    }
}

// For a small shear tau^3/6 replaces the expression with the logarithm.
TEST_CASE("the energy is proportional to the cube of a small shear force") {
    const Slipping s = upright("Hertz", "1e-9");
    const Ball P = s.force();
    const Ball cube = P * P * 8 * Ball(Rational(9, 25), energy_bits) / Ball::pi(energy_bits) / 2 *
                      number("1e-27/6");
    const Ball W = similar_cycle_energy(*s.slip, Ball(2, energy_bits));
    CHECK(certainly_less(abs(Ball(W / cube - 1)), number("1e-9")));
    CHECK(certainly_less(number("1e-10"), abs(Ball(W / cube - 1)))); // tau/2
}

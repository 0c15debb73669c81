// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <ios>
#include <string>
#include <utility>

namespace {

scene::Scene round_scene(const std::string& m, const std::string& C, const std::string& load) {
    return scene::parse_scene(
        "[profile]\nkind = \"power-law\"\ngeometry = \"axisymmetric\"\nm = \"" + m + "\"\nC = \"" +
            C + "\"\n[load]\n" + load + "\ncontact_modulus = \"7/3\"\n",
        "round.toml");
}

Ball value_of_contact(const scene::Scene& s, scene::Quantity quantity) {
    const scene::BoundedValue value =
        scene::SceneValues(s, {{quantity}}, {40, Rounding::nearest, false}).value({quantity});
    CHECK(value.proved);
    return value.value;
}

std::string round_refusal(const std::string& text) {
    try {
        (void)run_scene(scene::parse_scene(text, "round.toml"));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

Real integral_of(const auto& f) {
    return quadrature::tanh_sinh<Real>(f, {.target_digits = 35}).value;
}

} // namespace

// johnson1985, sec. 4.2: a^3 = 3 P R/(4 E*), delta = a^2/R, p_0 = 3 P/(2 pi a^2), p = p_0 sqrt(1 -
// r^2/a^2).
TEST_CASE("a sphere") {
    const scene::Scene s = round_scene("1", "1/2", "P = \"7/9\""); // a^3 = 1/2
    const Ball a = pow(Ball(Rational(1, 2), 200), Rational(1, 3));
    CHECK(overlaps(value_of_contact(s, scene::Quantity::a), a));
    CHECK(overlaps(value_of_contact(s, scene::Quantity::delta), a * a / 2));
    CHECK(contains(value_of_contact(s, scene::Quantity::P), Rational(7, 9)));
    const Ball p_0 = Ball(Rational(7, 6), 200) / Ball::pi(200) / (a * a);
    CHECK(overlaps(value_of_contact(s, scene::Quantity::p_max), p_0));
    const scene::Scene by_delta = round_scene("1", "1/2", "delta = \"2\"");
    CHECK(overlaps(value_of_contact(by_delta, scene::Quantity::a), Ball(2, 200)));
}

// Values that the tests of two public programs state: MOOSE,
// modules/contact/test/tests/hertz_spherical (examples/scenes/two-spheres.toml), and
// ContactMechanics, test/ReferenceSolutions/test_reference_solutions.py (to 1e-7).
TEST_CASE("spheres of the tests of public programs") {
    const scene::Scene moose = scene::parse_scene(
        "[profile]\nkind = \"hertz\"\ngeometry = \"axisymmetric\"\nR1 = \"2\"\nR2 = \"2\"\n"
        "[load]\nP = \"10000\"\nE1 = \"1.40625e7\"\nnu1 = \"0.25\"\nE2 = \"1.40625e7\"\n"
        "nu2 = \"0.25\"\n",
        "moose.toml");
    CHECK(contains(value_of_contact(moose, scene::Quantity::a), Rational(1, 10)));
    CHECK(contains(value_of_contact(moose, scene::Quantity::delta), Rational(1, 100)));
    const scene::Scene other = scene::parse_scene(
        "[profile]\nkind = \"hertz\"\ngeometry = \"axisymmetric\"\nR = \"4\"\n[load]\nP = \"7\"\n"
        "contact_modulus = \"5\"\n",
        "contact-mechanics.toml");
    for (const auto& [quantity, stated] :
         {std::pair{scene::Quantity::delta, "0.6507879989531481"},
          std::pair{scene::Quantity::a, "1.6134286460245437"},
          std::pair{scene::Quantity::p_max, "1.2839257217043503"}}) {
        const Real ratio = value_of_contact(other, quantity).midpoint() / Real(stated);
        CHECK(abs(Real(ratio - 1)) < Real("1e-7"));
    }
}

// sneddon1965: h(s) = s integral_0^s g'(r)/sqrt(s^2 - r^2) dr, delta = h(a), P = 2 E* integral of s
// h'(s) ds, p(r) = (E*/pi) integral_r^a h'(s)/sqrt(s^2 - r^2) ds, each by tanh-sinh quadrature.
TEST_CASE("axisymmetric power laws agree with the Abel transform by quadrature") {
    const PrecisionScope precision(60);
    const auto at = [](const Ball& x) { return at_working_precision(x.midpoint()); };
    for (const char* m_text : {"0", "1/2", "5/8", "1", "2", "5/2", "9", "31/3", "sqrt(2)"}) {
        CAPTURE(m_text);
        const Real m = at_working_precision(formula::ball_of(Exact::parse(m_text), 220).midpoint());
        const Real C = Real(3) / 7;
        const Real a = Real(5) / 4;
        const Real E = Real(7) / 3;
        const scene::Scene s = round_scene(m_text, "3/7", "a = \"5/4\"");
        // kappa of h = kappa s^(m+1); t = 1 - hi, 1 - t^2 = hi (2 - hi)
        const Real kappa = C * integral_of([&](const Real& lo, const Real& hi) {
                               return Real(pow(lo, m) / sqrt(Real(hi * (2 - hi))));
                           });
        const Real power = m + 1;
        const Real delta = kappa * pow(a, power);
        const Real P = 2 * E * integral_of([&](const Real& lo, const Real&) {
                           return Real(a * power * kappa * pow(Real(a * lo), power));
                       });
        const auto near = [&](const Ball& x, const Real& y) {
            return abs(Real(at(x) - y)) < abs(y) * Real("1e-33");
        };
        CHECK(near(value_of_contact(s, scene::Quantity::delta), delta));
        CHECK(near(value_of_contact(s, scene::Quantity::P), P));
        for (const char* u_text : {"1e-20", "1/100", "3/5", "6/5"}) {
            CAPTURE(u_text);
            const Exact u = Exact::parse(u_text);
            const Real from_edge = at_working_precision(formula::ball_of(u, 220).midpoint());
            const Real r = a - from_edge;
            const Real p =
                E / edgeproof::pi<Real>() * integral_of([&](const Real& lo, const Real&) {
                    const Real beyond = from_edge * lo; // s - r
                    return Real(power * kappa * pow(Real(r + beyond), m) * from_edge /
                                sqrt(Real(beyond * (2 * r + beyond))));
                });
            scene::AskedValue asked{scene::Quantity::p};
            asked.u = u;
            const Ball found =
                scene::SceneValues(s, {asked}, {40, Rounding::nearest, false}).value(asked).value;
            CHECK(near(found, p));
        }
    }
}

// The pressure over the disc carries the load: P = 2 pi integral of r p dr.
TEST_CASE("the pressure of an axisymmetric contact carries its load") {
    const PrecisionScope precision(50);
    for (const char* m : {"1/2", "1", "4"}) {
        CAPTURE(m);
        const scene::Scene s = round_scene(m, "3/7", "a = \"5/4\"");
        scene::AskedValue first{scene::Quantity::p};
        first.u = Exact::parse("1/2");
        scene::SceneValues values(s, {first}, {30, Rounding::nearest, false});
        const Real a = Real(5) / 4;
        const Real force =
            quadrature::tanh_sinh<Real>(
                [&](const Real& lo, const Real& hi) {
                    const Real u = a * hi;
                    scene::AskedValue asked{scene::Quantity::p};
                    asked.u = Exact::parse(u.str(45, std::ios_base::scientific));
                    return Real(at_working_precision(values.value(asked).value.midpoint()) * a *
                                lo * a);
                },
                {.target_digits = 15})
                .value *
            2 * edgeproof::pi<Real>();
        const Real P = at_working_precision(value_of_contact(s, scene::Quantity::P).midpoint());
        CHECK(abs(Real(force - P)) < P * Real("1e-14"));
    }
}

TEST_CASE("axisymmetric scenes that are not computed are refused") {
    const std::string sphere =
        "[profile]\nkind = \"hertz\"\ngeometry = \"axisymmetric\"\nR = \"1\"\n[load]\na = "
        "\"1\"\ncontact_modulus = \"1\"\n";
    CHECK(round_refusal(sphere + "[ask]\nterms = 1\n").empty());
    CHECK(round_refusal(sphere + "[shear]\nQ = \"0.1\"\n").find("only partial slip") !=
          std::string::npos);
    CHECK(round_refusal(sphere + "[ask]\npoints = [[\"0\", \"1\"]]\n").find("no Poisson") !=
          std::string::npos);
    CHECK(round_refusal("[profile]\nkind = \"tilted-wedge\"\ngeometry = "
                        "\"axisymmetric\"\nphi = \"1/2\"\nalpha = \"1/4\"\n[load]\na = "
                        "\"2\"\ncontact_modulus = \"1\"\n")
              .find("only power laws") != std::string::npos);
    CHECK(round_refusal("[profile]\nkind = \"hertz\"\ngeometry = \"round\"\nR = "
                        "\"1\"\n[load]\na = \"2\"\ncontact_modulus = \"1\"\n")
              .find("unknown geometry") != std::string::npos);
    CHECK(round_refusal("[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\ndelta = "
                        "\"2\"\ncontact_modulus = \"1\"\n")
              .find("undetermined") != std::string::npos);
}

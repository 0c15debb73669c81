// SPDX-License-Identifier: GPL-3.0-or-later
// Axisymmetric contacts with curved slopes: closed forms, and integrals of g' in Real.

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/digits_right.hpp"
#include "edgeproof/scene/scene.hpp"
#include "lab/validation/abel_quadrature.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

constexpr unsigned digits_of_curved = 40;

scene::Scene curved_body(const std::string& knots, const std::string& slopes,
                         const std::string& load, const std::string& rest = "") {
    return scene::parse_scene("[profile]\ngeometry = \"axisymmetric\"\nkind = \"piecewise\"\n"
                              "symmetric = true\nknots = [" +
                                  knots + "]\nslopes = [" + slopes + "]\n[load]\n" + load +
                                  "\ncontact_modulus = \"7/3\"\n" + rest,
                              "curved.toml");
}

Ball value_of_curved(const scene::Scene& scene, const scene::AskedValue& asked,
                     unsigned digits = digits_of_curved) {
    const scene::BoundedValue value =
        scene::SceneValues(scene, {asked}, {digits, Rounding::nearest, false}).value(asked);
    CHECK(value.proved);
    return value.value;
}

scene::AskedValue pressure_of_curved(const std::string& u) {
    scene::AskedValue asked{scene::Quantity::p};
    asked.u = Exact::parse(u);
    return asked;
}

std::string refusal_of_curved(const auto& f) {
    try {
        f();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// p, P, delta and c_0 of a scene against integrals of g' in Real.
void check_curved_body(const scene::Scene& scene, const std::vector<std::string>& places) {
    const Ball radius = value_of_curved(scene, {scene::Quantity::a}, digits_of_curved + 90);
    const PrecisionScope scope(digits_of_curved + 90);
    const AbelQuadrature second(scene, at_working_precision(radius.midpoint()),
                                digits_of_curved + 10);
    const auto check = [](const Real& x, const Ball& exact) {
        CHECK(digits_right(x, exact) + 1 >= digits_of_curved);
        CHECK(digits_proved(exact) + 1 >= digits_of_curved);
    };
    check(second.force(), value_of_curved(scene, {scene::Quantity::P}));
    check(second.approach(), value_of_curved(scene, {scene::Quantity::delta}));
    for (const std::string& u : places) {
        CAPTURE(u);
        check(second.pressure(Exact::parse(u).to<Real>()),
              value_of_curved(scene, pressure_of_curved(u)));
    }
}

} // namespace

// The pressure is linear in g' at a given radius, so that the polynomial is a sum of power laws.
TEST_CASE("a body of revolution of a polynomial slope is the sum of power laws") {
    const scene::Scene sum = curved_body("", "\"x/2 + x^3\"", "a = \"6/5\"");
    const auto power = [](const char* m, const char* C) {
        return scene::parse_scene(
            std::string("[profile]\ngeometry = \"axisymmetric\"\nkind = \"power-law\"\nm = \"") +
                m + "\"\nC = \"" + C + "\"\n[load]\na = \"6/5\"\ncontact_modulus = \"7/3\"\n",
            "power.toml");
    };
    const scene::Scene first = power("1", "1/2");
    const scene::Scene third = power("3", "1");
    scene::AskedValue c_2{scene::Quantity::c};
    c_2.k = 2;
    for (const scene::AskedValue& asked :
         {pressure_of_curved("1e-20"), pressure_of_curved("1/3"), pressure_of_curved("6/5"),
          scene::AskedValue{scene::Quantity::P}, scene::AskedValue{scene::Quantity::delta},
          scene::AskedValue{scene::Quantity::c}, c_2}) {
        const Ball whole = value_of_curved(sum, asked);
        CHECK(overlaps(whole, value_of_curved(first, asked) + value_of_curved(third, asked)));
        CHECK(digits_proved(whole) >= digits_of_curved);
    }
}

// sneddon1965: delta = (a/2) log((R + a)/(R - a)), and P = E* ((a^2 + R^2)/2 log((R + a)/(R - a))
// - a R) for an exact sphere.
TEST_CASE("an exact sphere of revolution") {
    const scene::Scene sphere = curved_body("", "\"x/sqrt(4 - x^2)\"", "a = \"3/2\"");
    const long bits = 300;
    const Ball ratio = log(Ball(7, bits));
    CHECK(overlaps(value_of_curved(sphere, {scene::Quantity::delta}), ratio * 3 / 4));
    const Ball P = (ratio * Ball(Rational(25, 8), bits) - 3) * 7 / 3;
    CHECK(overlaps(value_of_curved(sphere, {scene::Quantity::P}), P));
    const PrecisionScope scope(60);
    const scene::Scene by_force =
        curved_body("", "\"x/sqrt(4 - x^2)\"", "P = \"" + P.midpoint().str(60) + "\"");
    const Ball a = value_of_curved(by_force, {scene::Quantity::a});
    CHECK(digits_right(Real(Real(3) / 2), a) + 1 >= digits_of_curved);
}

TEST_CASE("curved bodies of revolution agree with integrals of g'" * doctest::test_suite("slow")) {
    check_curved_body(curved_body("", "\"sinh(x)\"", "P = \"1\""), {"1e-30", "1/7", "1/2"});
    // a rounded cone whose flank is curved, a corner, and an edge 1e-12 beyond it
    check_curved_body(curved_body("\"1/2\"", "\"x\", \"1/2 + (x - 1/2)*exp(x)\"", "delta = \"1\""),
                      {"1e-30", "1/5"});
    check_curved_body(
        curved_body("\"1/3\"", "\"x^2\", \"1/4 + log(1 + x)\"", "a = \"1/3 + 1e-12\""),
        {"1e-30", "1/5"});
}

TEST_CASE("the coefficients of a curved body of revolution agree with divided differences" *
          doctest::test_suite("slow")) {
    const scene::Scene scene =
        curved_body("\"1/2\"", "\"x\", \"1/2 + (x - 1/2)*exp(x)\"", "a = \"1\"");
    const unsigned digits = difference_digits(1, digits_of_curved);
    const PrecisionScope scope(digits + 70);
    const AbelQuadrature second(scene, Real(1), digits);
    scene::AskedValue c_1{scene::Quantity::c};
    c_1.k = 1;
    const Real differences = coefficient_by_differences(
        1, digits_of_curved, Real(Real(1) / 2), [&](const Real& u) { return second.pressure(u); });
    CHECK(digits_right(differences, value_of_curved(scene, c_1)) + 1 >= digits_of_curved);
}

TEST_CASE("what is not computed for curved bodies of revolution is refused") {
    const char* const slope = "\"sinh(x)\"";
    const char* const load = "a = \"1\"";
    const auto refused = [&](const std::string& rest) {
        return refusal_of_curved([&] { (void)run_scene(curved_body("", slope, load, rest)); });
    };
    CHECK(refused("[ask]\nterms = 2\nu = [\"0.1\"]\ndigits = 10\n").empty());
    CHECK(refused("[shear]\nQ = \"0.1\"\nfriction = \"1/2\"\n").find("shear is not computed") !=
          std::string::npos);
    for (const char* group : {"extent", "peak", "displacement", "stress"}) {
        CAPTURE(group);
        CHECK(refused("[ask]\nterms = 1\ntolerance = \"1%\"\nx = [\"2\"]\n"
                      "quantities = [\"" +
                      std::string(group) + "\"]\n")
                  .find("curved slopes of revolution") != std::string::npos);
    }
    CHECK(refusal_of_curved([&] {
              (void)curved_body("\"1/2\"", "\"0\", \"sqrt(x - 1/2)\"", load);
          }).find("not analytic at r = 1/2") != std::string::npos);
    CHECK(refusal_of_curved([&] {
              (void)curved_body("", "\"x^(3/2)\"", load);
          }).find("not analytic at r = 0") != std::string::npos);
    CHECK(refusal_of_curved([&] {
              (void)curved_body("", "\"x + abs(x)\"", load);
          }).find("beyond the rigorous") != std::string::npos);
    CHECK(refusal_of_curved([&] {
              (void)run_scene(curved_body("", "\"sin(3*x)\"", load, "[ask]\nu = [\"0.1\"]\n"));
          }).find("decreases") != std::string::npos);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/comparison/comparison.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "tests/comparison/hertz_data.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace edgeproof::hertz_data;

// p = C acosh(a/|x|)/pi of a wedge with E* = 1 (Johnson, section 5.2). With a = 1 + 2^-60 no
// distance from the edge in binary64 has the digits of a place near the apex.
TEST_CASE("the exact contact: p and q near a corner have the digits of the place") {
    const ExactContact wedge(
        scene_of_words("kind=power-law m=0 C=1 a=1+2^-60 contact_modulus=1 Q=(1+2^-60)/8 "
                       "path=together"));
    for (const double x : {3.3e-15, -1e-13, 1e-9, -1e-5, 1e-3, 0.3}) {
        CAPTURE(x);
        const ExactContact::Place place = wedge.at(Real(x));
        const double p = std::acosh(1 / std::abs(x)) / std::numbers::pi;
        CHECK(wedge.p(place).value() == doctest::Approx(p).epsilon(3e-15));
        CHECK(wedge.q(place).value() == doctest::Approx(p / 8).epsilon(3e-15));
    }
    CHECK_FALSE(wedge.p(wedge.at(Real(0))));
}

// P = pi/20 closes the contact up to the corner at 1; 1e-45 beyond it 128 bits do not separate
// both.
TEST_CASE("the exact contact: an edge that few bits do not separate from a corner") {
    const ExactContact contact(
        scene_of_words("kind=piecewise symmetric=true knots=1 slopes=x/5,x/5+1 P=pi/20+1/10^45 "
                       "contact_modulus=1"));
    // Hertz with R = 5: p = sqrt(a^2 - x^2)/10
    for (const double x : {0.0, -0.6, 0.8}) {
        CHECK(contact.p(contact.at(Real(x))).value() ==
              doctest::Approx(std::sqrt(1 - x * x) / 10).epsilon(3e-15));
    }
}

// Slopes with a corner, a jump of g'', a branch point and no symmetry, and a body of revolution
// without a closed form; places from 1e-7 of the contact next to edges and knots. The exact
// pressures are those of rigorous integration.
TEST_CASE("pressures of curved slopes for searches agree with the exact ones") {
    for (const char* profile : {"symmetric=true knots=1/2 slopes=x/10,x/10+(x-1/2)^3",
                                "knots=0,1/4 slopes=sinh(x)-1/10,x^3,1/64+sqrt(x-1/4)",
                                "knots=-1/3 slopes=exp(x)-1+(x+1/3)/5,exp(x)-1",
                                "geometry=axisymmetric symmetric=true knots=1/2 slopes=0,x-1/2"}) {
        CAPTURE(profile);
        const ExactContact contact(
            scene_of_words(std::string("kind=piecewise contact_modulus=100 a=3/4 ") + profile));
        std::vector<double> places{-contact.b().value, contact.a().value};
        for (const ContactKnot& knot : contact.knots()) {
            places.push_back(knot.x);
        }
        for (const double place : places) {
            for (const double away : {-0.2, -1e-2, -1e-4, -1e-7, 1e-7, 1e-4, 1e-2, 0.2}) {
                const double x = place + away * contact.length();
                CAPTURE(x);
                const auto exact = contact.p(contact.at(Real(x)));
                const auto quick = contact.quick_pressure(x);
                REQUIRE(exact.has_value() == quick.has_value());
                CHECK(quick.value_or(0) == doctest::Approx(exact.value_or(0)).epsilon(1e-9));
            }
        }
    }
}

// Data of axisymmetric contacts: r and p.
namespace {

scene::Scene compared_sphere(const std::string& load) {
    return hertz_data::scene_of_words("kind=hertz geometry=axisymmetric R=10 contact_modulus=1e5 " +
                                      load);
}

/// r and p of a sphere with a = 1 (johnson1985, section 4.2), p multiplied by a factor.
std::string sphere_data(double factor, bool both_sides) {
    const double p0 = 2 * 1e5 / (10 * std::acos(-1));
    std::string text = "r,p\n";
    for (int i = both_sides ? -60 : 0; i <= 60; ++i) {
        const double r = i * 0.02;
        text +=
            fmt::format("{:.12e},{:.12e}\n", r, factor * p0 * std::sqrt(std::max(0.0, 1 - r * r)));
    }
    return text;
}

FileComparison compared_with(const scene::Scene& s, const std::string& data) {
    Tolerances tolerances;
    tolerances.pressure = 1e-6;
    tolerances.force = 1e-3;
    return hertz_data::Diagnosed(s).of(data, tolerances);
}

} // namespace

TEST_CASE("compare: radii and pressures of a sphere, with the total force") {
    for (const bool both_sides : {false, true}) {
        CAPTURE(both_sides);
        const FileComparison file =
            compared_with(compared_sphere("a=1"), sphere_data(1, both_sides));
        CHECK(file.passes());
        const double P = 4.0 / 3 * 1e5 / 10; // 4 E* a^3/(3 R)
        // The error of trapezoids where p falls like a root; the exact p has the same.
        CHECK(std::abs(file.contact.force.value() / P - 1) < 3e-3);
        CHECK(std::abs(file.contact.force.value() / file.of_exact.force.value() - 1) < 1e-10);
    }
}

// p of a punch with a rounded edge, whose pressure is integrated, from the scene's own values.
TEST_CASE("compare: a profile that is no power law") {
    const scene::Scene s = hertz_data::scene_of_words(
        "kind=flat-and-rounded geometry=axisymmetric t=2/5 R=1 a=1 contact_modulus=1");
    std::string text = "r,p\n";
    std::vector<scene::AskedValue> asked;
    for (int i = 0; i < 40; ++i) {
        asked.push_back({scene::Quantity::p});
        asked.back().u = Exact::of(Rational(40 - i, 40));
    }
    scene::SceneValues values(s, asked, {20, Rounding::nearest, false});
    for (int i = 0; i < 40; ++i) {
        const auto& at = asked[static_cast<std::size_t>(i)];
        text += fmt::format("{:.12e},{:.15e}\n", i / 40.0,
                            values.value(at).value.midpoint().convert_to<double>());
    }
    const FileComparison file = compared_with(s, text + "1,0\n1.1,0\n");
    CHECK(file.passes());
    CHECK(file.all.peak < 1e-11);
}

// The tip of a cone with a steeper part outside is a corner, where p is infinite, and its knot at
// 1/2 is a bend, where p is finite.
TEST_CASE("compare: the node on the corner of a body of revolution is left out") {
    const ExactContact exact(
        hertz_data::scene_of_words("kind=piecewise geometry=axisymmetric symmetric=true knots=1/2 "
                                   "slopes=1/10+x/5,1/5 a=1 contact_modulus=1"));
    CHECK_FALSE(exact.p(exact.at(Real(0))).has_value());
    const double left = exact.p(exact.at(Real(0.5 - 1e-9))).value();
    const double right = exact.p(exact.at(Real(0.5 + 1e-9))).value();
    CHECK(exact.p(exact.at(Real(0.5))).value() ==
          doctest::Approx((left + right) / 2).epsilon(1e-8));
}

// p of the same sphere with the force P/(2 pi) has the factor (2 pi)^(-1/3) in p_0 and in a.
TEST_CASE("compare: the force of one radian is named") {
    const double P = 4.0 / 3 * 1e5 / 10;
    const scene::Scene s =
        compared_sphere(fmt::format("P={:.17g}", P * 2 * std::acos(-1))); // for 2 pi radians
    const FileComparison file = compared_with(s, sphere_data(1, false));
    CHECK_FALSE(file.passes());
    CHECK(hertz_data::is_named(file.diagnosis, "force-per-radian"));
}

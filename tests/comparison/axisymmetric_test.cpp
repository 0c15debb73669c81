// SPDX-License-Identifier: GPL-3.0-or-later
// Data of axisymmetric contacts: r and p.
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

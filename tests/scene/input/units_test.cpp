// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

TEST_CASE("units: names, prefixes and factors") {
    // In NIST SP 811, table B.8, the inch, the pound-force and the kilogram-force are exact.
    CHECK(unit_named("mm")->factor == Rational(1, 1000));
    CHECK(unit_named("MPa")->factor == Rational(1'000'000));
    CHECK(unit_named("mPa")->factor == Rational(1, 1000));
    CHECK(unit_named("kN")->dimension == Unit::Dimension::force);
    CHECK(unit_named("in")->factor == Rational(254, 10000));
    CHECK(unit_named("N/mm^2")->factor == Rational(1'000'000));
    CHECK(unit_named("N/mm2")->factor == Rational(1'000'000));
    CHECK(abs(unit_named("psi")->factor.convert_to<double>() - 6894.757293168361) < 1e-9);
    CHECK_FALSE(unit_named("MPA"));
    CHECK_FALSE(unit_named(""));
    CHECK_FALSE(unit_named("contact"));
    CHECK_FALSE(unit_named("N/m"));
}

TEST_CASE("units of a scene are labels") {
    const Scene scene = made("hertz R=10 P=5 units.length=mm units.force=N units.pressure=MPa");
    REQUIRE(scene.units);
    CHECK(scene.units->text() == "lengths in mm, P in N/mm, M in N, pressures in MPa");
    CHECK(scene.load.value.rational() == 5); // not converted
    CHECK(made("hertz R=10 P=5 units.length=um").units->text() == "lengths in um");
}

TEST_CASE("Hertz by the radii: 1/R = 1/R1 + 1/R2; the flat and the contact by their widths") {
    const auto curvature = [](const std::string& words) {
        const Scene scene = made(words + " P=1");
        CHECK(scene.profile->kind() == Profile::Kind::power_law);
        CHECK(scene.profile->parameters().at("m").rational() == 1);
        return scene.profile->parameters().at("C").rational();
    };
    CHECK(curvature("hertz R=100") == Rational(1, 100));
    CHECK(curvature("hertz R1=10 R2=15") == Rational(1, 6));
    CHECK(curvature("hertz R1=10 R2=-11") == Rational(1, 110));
    CHECK(curvature("hertz R2=4") == Rational(1, 4));
    CHECK(curvature("cylinder-on-flat R=3") == Rational(1, 3));
    const Scene pad = made("flat-and-rounded flat_width=3 R=50 width=5");
    CHECK(pad.profile->parameters().at("t").rational() == Rational(3, 2));
    CHECK(pad.load.kind == Load::Kind::right_edge);
    CHECK(pad.load.value.rational() == Rational(5, 2));
}

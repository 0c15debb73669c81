// SPDX-License-Identifier: BSD-3-Clause
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_text.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

const std::string bodies = "E1 = \"200\"\nnu1 = \"0.3\"\nE2 = \"200\"\nnu2 = \"0.3\"\n";

std::string with_units(const std::string& units) {
    return "[units]\n" + units + "[profile]\nkind = \"hertz\"\nR = \"10\"\n[load]\nP = \"5\"\n" +
           bodies;
}

/// Returns the line of the error in a text, and its message.
std::pair<std::size_t, std::string> refused(const std::string& text) {
    try {
        (void)parsed(text);
    } catch (const InputError& error) {
        return {error.line(), error.what()};
    }
    return {0, ""};
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace

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

TEST_CASE("units of a scene are labels, and must be consistent") {
    const Scene scene = parsed(with_units("length = \"mm\"\nforce = \"N\"\npressure = \"MPa\"\n"));
    REQUIRE(scene.units);
    CHECK(scene.units->text() == "lengths in mm, P in N/mm, M in N, pressures in MPa");
    CHECK(scene.load.value.rational() == 5); // not converted
    CHECK(parsed(with_units("length = \"um\"\n")).units->text() == "lengths in um");
    const auto [line, why] =
        refused(with_units("length = \"m\"\nforce = \"N\"\npressure = \"MPa\"\n"));
    CHECK(line == 4);
    CHECK(says(why, "MPa times m squared is not N"));
    CHECK(refused(with_units("length = \"Pa\"\n")).first == 2);
    CHECK(refused(with_units("length = \"furlong\"\n")).first == 2);
    CHECK(refused(with_units("width = \"mm\"\n")).first == 2);
}

TEST_CASE("Hertz by the radii: 1/R = 1/R1 + 1/R2") {
    const auto curvature = [](const std::string& profile) {
        const Scene scene = parsed("[profile]\n" + profile + "[load]\nP = \"1\"\n" + bodies);
        CHECK(scene.profile->kind() == Profile::Kind::power_law);
        CHECK(scene.profile->parameters().at("m").rational() == 1);
        return scene.profile->parameters().at("C").rational();
    };
    CHECK(curvature("kind = \"hertz\"\nR = \"100\"\n") == Rational(1, 100));
    CHECK(curvature("kind = \"hertz\"\nR1 = \"10\"\nR2 = \"15\"\n") == Rational(1, 6));
    CHECK(curvature("kind = \"hertz\"\nR1 = \"10\"\nR2 = \"-11\"\n") == Rational(1, 110));
    CHECK(curvature("kind = \"hertz\"\nR2 = \"4\"\n") == Rational(1, 4));
    CHECK(curvature("kind = \"cylinder-on-flat\"\nR = \"3\"\n") == Rational(1, 3));
    const std::string rest = "[load]\nP = \"1\"\n" + bodies;
    CHECK(refused("[profile]\nkind = \"hertz\"\n" + rest).first == 1);
    CHECK(refused("[profile]\nkind = \"hertz\"\nR = \"0\"\n" + rest).first == 3);
    CHECK(refused("[profile]\nkind = \"hertz\"\nR = \"1\"\nR1 = \"1\"\n" + rest).first == 3);
    CHECK(refused("[profile]\nkind = \"hertz\"\nR1 = \"1\"\nR2 = \"-1\"\n" + rest).first == 3);
    CHECK(refused("[profile]\nkind = \"cylinder-on-flat\"\nR1 = \"1\"\n" + rest).first == 3);
}

TEST_CASE("the flat by its length, the contact by its width") {
    const Scene pad = parsed("[profile]\nkind = \"flat-and-rounded\"\nflat_width = \"3\"\nR = "
                             "\"50\"\n[load]\nwidth = \"5\"\n" +
                             bodies);
    CHECK(pad.profile->parameters().at("t").rational() == Rational(3, 2));
    CHECK(pad.load.kind == Load::Kind::right_edge);
    CHECK(pad.load.value.rational() == Rational(5, 2));
    const std::string profile = "[profile]\nkind = \"flat-and-rounded\"\nflat_width = \"3\"\n";
    CHECK(says(refused(profile + "R = \"50\"\n[load]\nwidth = \"2\"\n" + bodies).second,
               "does not reach beyond the flat"));
    CHECK(refused(profile + "t = \"1.5\"\nR = \"50\"\n[load]\nwidth = \"5\"\n" + bodies).first ==
          3);
    CHECK(refused(profile + "R = \"50\"\n[load]\nwidth = \"5\"\na = \"2\"\n" + bodies).first == 6);
    CHECK(says(refused("[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.02\"\n"
                       "[load]\nwidth = \"2\"\n" +
                       bodies)
                   .second,
               "different distances from the origin"));
}

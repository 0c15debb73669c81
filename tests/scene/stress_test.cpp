// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

using scene::Body, scene::BodyPoint, scene::Quantity, scene::QuantityRow, scene::Scene;

namespace {

const std::string hertz_text = R"([profile]
kind = "hertz"
R = "1"
[load]
a = "1"
contact_modulus = "2"
nu = "0.3"
[ask]
points = [["0", "0.78615137775742328606955858584295892952"], ["1/2", "0"], ["2", "0"]]
digits = 15
)";

const std::string slip_text = R"([profile]
kind = "tilted-flat-and-rounded"
alpha = "0.1"
t = "0.4"
R = "2"
[load]
a = "1"
contact_modulus = "3/2"
[shear]
Q = "-0.1"
friction = "0.6"
bulk_tension = "0.03"
bulk_A = "0.2"
[ask]
digits = 20
)";

Scene stress_scene(const std::string& text) { return scene::parse_scene(text, "scene.toml"); }

Ball stress_at(Scene s, const std::string& x, const std::string& z, Body body, Quantity quantity) {
    s.ask.quantities = {scene::QuantityGroup::stress};
    s.ask.in_bodies = {{Exact::parse(x), Exact::parse(z), body}};
    const scene::SceneResult result = run_scene(s);
    const auto places = result.at_places(QuantityRow::Place::body);
    REQUIRE(places.size() == 1);
    CHECK(places[0].at(quantity).proved);
    return places[0].at(quantity).value;
}

std::string refusal(const std::string& text) {
    try {
        (void)run_scene(stress_scene(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

} // namespace

// johnson1985, sec. 4.2(a): tau_max = 0.300 p_0 at z = 0.78 a, where its derivative by z vanishes
// at z = a sqrt((sqrt(5) - 1)/2); the value is sqrt((5 sqrt(5) - 11)/2) to 15 digits.
TEST_CASE("stresses of a cylinder") {
    const scene::SceneResult result = run_scene(stress_scene(hertz_text));
    const auto places = result.at_places(QuantityRow::Place::body);
    REQUIRE(places.size() == 3);
    const auto text = [&](std::size_t i, Quantity quantity) {
        return printed(places[i].at(quantity), {15, Rounding::nearest, false}).text;
    };
    CHECK(text(0, Quantity::tau_max) == "0.300283106000778");
    CHECK(text(1, Quantity::sxx) == "-0.866025403784439");
    CHECK(text(1, Quantity::szz) == "-0.866025403784439");
    CHECK(text(2, Quantity::szz) == "0");
    CHECK(text(2, Quantity::sxx) == "0");
    CHECK(places[0].find(Quantity::mises) != nullptr);
    CHECK(result.work.counts.stresses == 3);
}

// Without shear szz = sxx on the surface; an incompressible body then has no mises stress, and on
// the axis of symmetry there is no shear stress.
TEST_CASE("stresses that vanish are exactly 0") {
    for (const std::string profile :
         {"kind = \"hertz\"\nR = \"1\"", "kind = \"power-law\"\nm = \"5/8\"\nC = \"1\"",
          "kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"1\"",
          "kind = \"piecewise\"\nknots = [\"-1/2\", \"0\", \"1/4\"]\n"
          "slopes = [\"2*x + 1/2\", \"x\", \"x\", \"3*x - 1/2\"]"}) {
        CAPTURE(profile);
        const Scene s = stress_scene(
            with(with(hertz_text, "kind = \"hertz\"\nR = \"1\"", profile), "0.3", "1/2"));
        const auto is_zero = [&](const char* x, const char* z, Quantity quantity) {
            const Ball value = stress_at(s, x, z, Body::A, quantity);
            return value.is_exact() && contains_zero(value);
        };
        CHECK(is_zero("1/3", "0", Quantity::tau_max));
        CHECK(is_zero("1/3", "0", Quantity::mises));
        if (s.symmetric()) {
            CHECK(is_zero("0", "1/3", Quantity::sxz));
        }
    }
}

TEST_CASE("mises needs Poisson's ratio") {
    const auto places = run_scene(stress_scene(with(hertz_text, "nu = \"0.3\"\n", "")))
                            .at_places(QuantityRow::Place::body);
    CHECK(places.size() == 3);
    const scene::SceneResult without =
        run_scene(stress_scene(with(hertz_text, "nu = \"0.3\"\n", "")));
    CHECK(without.at_places(QuantityRow::Place::body)[0].find(Quantity::mises) == nullptr);
}

// Under the contact both bodies are strained alike where they stick; sxx is then the same in both,
// although B has the greater bulk stress.
TEST_CASE("in the stick zone both surfaces have the same stress along the surface") {
    const Scene s = stress_scene(slip_text);
    for (const std::string x : {"-1.4", "-0.3", "0.2", "0.85"}) {
        CAPTURE(x);
        CHECK(overlaps(stress_at(s, x, "0", Body::A, Quantity::sxx),
                       stress_at(s, x, "0", Body::B, Quantity::sxx)));
    }
    const Ball differs = stress_at(s, "0.95", "0", Body::A, Quantity::sxx) -
                         stress_at(s, "0.95", "0", Body::B, Quantity::sxx);
    CHECK_FALSE(contains_zero(differs));
}

// The rate of slip is the difference of the surface strains, (sxx_A - sxx_B)/(2 E*): Simpson's rule
// over small steps, from stresses, against the closed form of the slip.
TEST_CASE("the slip is the integral of the difference of the surface strains") {
    Scene s = stress_scene(slip_text);
    const auto slip = [&](const std::string& x) {
        Scene asked = s;
        asked.ask.quantities = {scene::QuantityGroup::displacement};
        asked.ask.u = {{Exact(), 0, scene::Place::parse(x, scene::Place::From::origin, {})}};
        const scene::SceneResult result = run_scene(asked);
        return result.at_places(QuantityRow::Place::surface)
            .at(0)
            .at(Quantity::slip_displacement)
            .value;
    };
    const auto rate = [&](const std::string& x) {
        return (stress_at(s, x, "0", Body::A, Quantity::sxx) -
                stress_at(s, x, "0", Body::B, Quantity::sxx)) /
               3;
    };
    const auto check = [&](const std::string& lo, const std::string& middle,
                           const std::string& hi) {
        const Ball step = Ball(Rational(1, 10000), 128);
        const Ball simpson = (rate(lo) + rate(middle) * 4 + rate(hi)) * step / 6;
        const Ball exactly = slip(hi) - slip(lo);
        CHECK(abs(Ball(simpson - exactly)).upper() < abs(exactly).lower() * Real("1e-9"));
    };
    check("0.95", "0.95005", "0.9501");
    check("-1.6", "-1.59995", "-1.5999");
    CHECK(contains(slip("0.1"), Rational(0)));
    // Q < 0 acts on A, so that A slips in the direction of +x.
    CHECK(certainly_positive(slip("0.97")));
    CHECK(certainly_positive(slip("-1.65")));
}

TEST_CASE("stresses that do not exist or are not computed are refused") {
    const std::string stick = with(hertz_text, "[ask]", "[shear]\nQ = \"0.1\"\n[ask]");
    CHECK(refusal(with(stick, "[\"2\", \"0\"]", "[\"1\", \"0\"]")).find("sxx at x = 1, z = 0") !=
          std::string::npos);
    CHECK(refusal(with(hertz_text, "[\"2\", \"0\"]", "[\"2\", \"-1\"]")).find("negative") !=
          std::string::npos);
    CHECK(refusal(with(hertz_text, "[\"2\", \"0\"]", "[\"2\"]")).find("no list of pairs") !=
          std::string::npos);
    CHECK(refusal(with(hertz_text, "0.3", "0.6")).find("no Poisson's ratio") != std::string::npos);
}

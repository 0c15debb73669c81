// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/scene_certificate.hpp"

#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace {

std::vector<certificate::Certificate> certified(const std::string& profile, const std::string& load,
                                                const std::string& ask) {
    const scene::Scene scene = scene::parse_scene(
        "[profile]\n" + profile + "\n[load]\ncontact_modulus = \"1\"\n" + load +
            "\n[ask]\ndigits = 10\nquantities = [\"pressure\", \"coefficients\", \"contact\"]\n" +
            "terms = [3]\n" + ask,
        "scene.toml");
    return certificate::certify_scene(scene, run_scene(scene));
}

const certificate::Certificate& named(const std::vector<certificate::Certificate>& all,
                                      std::string_view id) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.id == id; });
    REQUIRE(found != all.end());
    return *found;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace

// p = Es C/2 sqrt(a^2 - x^2), which is 2/5 at x = 3/5 for a = C = 1; P = pi/4; c_0 = 1/sqrt(2).
TEST_CASE("values of a parabola as theorems") {
    const auto all = certified("kind = \"power-law\"\nm = \"1\"\nC = \"1\"", "a = \"1\"",
                               "u = [\"0.4\"]\nedges = [\"right\"]\n");
    const auto& pressure = named(all, "pressure.right");
    CHECK(pressure.file == "pressure_right.v");
    CHECK(has(pressure.text, "Definition punch : list part := cons (Part 0 0 1) nil."));
    CHECK(has(pressure.text, "is_the_pressure Es (slope punch) a (a - (2 / 5)) p0 /\\\n"));
    CHECK(has(pressure.text, "Rabs (p0 - (4 / 10 ^ 1)) <= 5 / 10 ^ "));
    CHECK(has(named(all, "load").theorems.at(0).states, "P = 0.7853981634, rounded"));
    CHECK(has(named(all, "coefficients.right").theorems.at(0).states, "c_0 = 0.7071067812"));
}

// The force at a = 1 is pi/4.
TEST_CASE("an edge computed from a force") {
    const auto all = certified("kind = \"power-law\"\nm = \"1\"\nC = \"1\"", "P = \"pi/4\"",
                               "u = [\"0.4\"]\nedges = [\"right\"]\n");
    CHECK(has(named(all, "pressure.right").theorems.at(0).states, "p = 0.4"));
    CHECK(has(named(all, "pressure.right").text, "Definition a : R := (sqrt ("));
}

TEST_CASE("the force at the end of a step") {
    const auto all = certified("kind = \"power-law\"\nm = \"1\"\nC = \"1\"",
                               "[[step]]\nP = \"pi\"\n[[step]]\nP = \"pi/4\"",
                               "u = [\"0.4\"]\nedges = [\"right\"]\n");
    CHECK(has(named(all, "pressure.right").theorems.at(0).states, "p = 0.4"));
}

TEST_CASE("stresses that a scene asks for are listed as not stated") {
    scene::Scene scene =
        scene::parse_scene("[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\na = "
                           "\"1\"\ncontact_modulus = \"1\"\n[ask]\n"
                           "digits = 10\npoints = [[\"0\", \"1/2\"]]\nquantities = [\"stress\"]\n",
                           "scene.toml");
    scene::Scene stated = scene;
    stated.ask.quantities = {scene::QuantityGroup::contact};
    const auto all = certificate::certify_scene(scene, run_scene(stated));
    CHECK(named(all, "stress").theorems.empty());
    CHECK(has(named(all, "stress").leaves_out, "no theory is about this quantity"));
    CHECK(named(all, "load").theorems.size() == 1);
}

TEST_CASE("what cannot be stated about a scene has no theorem, but a reason") {
    const auto within = certified("kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"1\"",
                                  "a = \"1\"", "u = [\"0.1\", \"0.6\"]\nedges = [\"left\"]\n");
    CHECK(named(within, "pressure.left").theorems.size() == 1);
    CHECK(
        has(named(within, "pressure.left").text, "is_the_pressure Es (mirrored (slope punch)) a"));
    const auto& inside = named(within, "pressure.left: u = 0.6");
    CHECK(inside.theorems.empty());
    CHECK(has(inside.leaves_out, "nearer to the origin than a knot"));
    CHECK(inside.text.empty());

    const auto curved = certified("kind = \"power-law\"\nm = \"3\"\nC = \"1\"", "a = \"1\"",
                                  "u = [\"0.1\"]\nedges = [\"right\"]\n");
    for (const auto& c : curved) {
        CHECK(c.theorems.empty());
        CHECK(has(c.leaves_out, "no theory of the profile"));
    }
    const auto forced = certified("kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"1\"",
                                  "P = \"1\"", "u = [\"0.01\"]\nedges = [\"right\"]\n");
    CHECK(has(named(forced, "load").leaves_out, "give a"));
}

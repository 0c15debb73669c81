// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/scene/run_scene.hpp"

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

TEST_CASE("stresses under a parabola as theorems") {
    const auto certify_stresses = [](const std::string& profile, const std::string& z) {
        const scene::Scene scene = scene::parse_scene(
            "[profile]\n" + profile + "[load]\na = 1\ncontact_modulus = 1\n[ask]\ndigits = 30\n" +
                "points = [[\"0\", \"" + z + "\"]]\nquantities = [\"contact\", \"stress\"]\n",
            "scene.toml");
        return certificate::certify_scene(scene, run_scene(scene));
    };
    const std::string hertz = "kind = \"hertz\"\nR = 2\n";
    // Johnson, eqs. 4.45: under the middle szz = -p_0 a/sqrt(a^2 + z^2), here -1/(4 sqrt(2)).
    const auto stated = certify_stresses(hertz, "1");
    const auto& stress = named(stated, "stress");
    REQUIRE(stress.theorems.size() == 1);
    CHECK(has(stress.text, "are_the_pressures Es (Symmetric.slope punch) a a p"));
    CHECK(has(stress.text, "are_the_stresses p a a 0 1 sxx szz sxz"));
    CHECK(has(stress.theorems[0].states, "szz = -0.1767766953,"));
    CHECK(has(stress.text, "Rabs (szz - (- (1767766953 / 10 ^ 10))) <= 5 / 10 ^ 11"));
    // Without a theorem the reason is listed.
    CHECK(has(named(certify_stresses(hertz, "0"), "stress").leaves_out, "z > 0"));
    const auto rounded = certify_stresses("kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = 1\n", "1");
    CHECK(named(rounded, "stress").theorems.empty());
    CHECK(has(named(rounded, "stress").leaves_out, "under a parabola"));
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

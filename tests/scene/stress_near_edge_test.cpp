// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/stress_near_edge.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using scene::Body, scene::Quantity, scene::RayTerm, scene::Scene;

namespace {

constexpr long ray_bits = 400;

struct RayContact {
    std::string name;
    std::string text; ///< profile, load and shear; the right edge is at 1
};

std::vector<RayContact> ray_contacts() {
    const auto text_of = [](const char* profile, const std::string& traction) {
        return std::string("[profile]\n") + profile +
               "\n[load]\na = \"1\"\ncontact_modulus = \"3/2\"\n" + traction;
    };
    const char* const hertz_profile = "kind = \"hertz\"\nR = \"2\"";
    const char* const rounded_profile = "kind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"2\"";
    const char* const tilted_profile =
        "kind = \"tilted-flat-and-rounded\"\nalpha = \"0.1\"\nt = \"0.4\"\nR = \"2\"";
    const char* const wedge_profile = "kind = \"tilted-wedge\"\nphi = \"1/5\"\nalpha = \"-1/12\"";
    const char* const power_profile = "kind = \"power-law\"\nm = \"5/2\"\nC = \"1/3\"";
    return {{"no shear", text_of(rounded_profile, "")},
            {"no shear, tilted", text_of(wedge_profile, "")},
            {"together", text_of(power_profile, "[shear]\nQ = \"1/20\"\nbulk_A = \"1/9\"\npath = "
                                                "\"together\"\n")},
            {"full stick", text_of(tilted_profile, "[shear]\nQ = \"0.1\"\nbulk_tension = \"-0.2\"\n"
                                                   "bulk_A = \"0.3\"\n")},
            {"partial slip", text_of(hertz_profile, "[shear]\nQ = \"-0.1\"\nfriction = \"0.5\"\n")},
            {"partial slip, power law",
             text_of(power_profile, "[shear]\nQ = \"0.05\"\nfriction = \"0.6\"\n")},
            {"partial slip, tension",
             text_of(tilted_profile,
                     "[shear]\nQ = \"-0.1\"\nfriction = \"0.6\"\nbulk_tension = \"0.03\"\n"
                     "bulk_A = \"0.2\"\n")}};
}

Scene ray_scene(const std::string& text) {
    Scene s = scene::parse_scene(text + "[ask]\ndigits = 30\n", "scene.toml");
    s.ask.edges = {contact::Edge::right};
    return s;
}

/// sxx, szz, sxz at the distance r from the right edge at 1, by the closed forms at points
/// (contact/stress/cauchy_integral.hpp), which use no expansion.
std::array<Ball, 3> stresses_on_ray(Scene s, Body body, const std::string& angle,
                                    const std::string& r) {
    const std::string turn = "*" + angle + "*pi/180)";
    s.ask.quantities = {scene::QuantityGroup::stress};
    s.ask.in_bodies = {
        {Exact::parse("1 - " + r + "*cos(1" + turn),
         Exact::parse(r + (angle == "180" || angle == "0" ? std::string("*0") : "*sin(1" + turn)),
         body}};
    const scene::SceneResult result = run_scene(s);
    const auto at = result.at_places(scene::QuantityRow::Place::body).front();
    return {at.at(Quantity::sxx).value, at.at(Quantity::szz).value, at.at(Quantity::sxz).value};
}

/// The sum of the first n terms of a stress.
Ball sum_on_ray(const std::vector<RayTerm>& terms, std::size_t stress, std::size_t n,
                const Ball& r) {
    Ball sum(0, ray_bits);
    for (std::size_t j = 0; j < n; ++j) {
        sum += terms[j].values[stress].value * pow(r, Rational(terms[j].halves, 2));
    }
    return sum;
}

} // namespace

TEST_CASE("the series of the stresses near an edge add up to the stresses at points") {
    constexpr std::size_t terms = 24;
    const char* const r = "(1/10000)"; // less than 1/100 of the radius of convergence
    const Ball distance(Rational(1, 10'000), ray_bits);
    for (const RayContact& c : ray_contacts()) {
        CAPTURE(c.name);
        const Scene s = ray_scene(c.text);
        for (const std::string angle : {"0", "37", "90", "135", "180"}) {
            const Body body = angle.size() == 2 ? Body::B : Body::A;
            CAPTURE(angle);
            const auto series = ray_terms(s, body, Exact::parse(angle), terms);
            REQUIRE(series.size() == terms);
            CHECK(series.front().halves == (c.name == "full stick" ? -1 : 0));
            const auto exact = stresses_on_ray(s, body, angle, r);
            for (std::size_t i = 0; i < exact.size(); ++i) {
                CAPTURE(i);
                CHECK(certainly_less(abs(Ball(sum_on_ray(series, i, terms, distance) - exact[i])),
                                     Ball(Rational(1, 1'000'000'000'000'000'000), ray_bits)));
                CHECK(series[7].values[i].proved);
            }
        }
    }
}

TEST_CASE("the series of the stresses at the left edge are those of the mirror image") {
    const std::string text = "[profile]\nkind = \"tilted-wedge\"\nphi = \"1/5\"\nalpha = \"1/12\"\n"
                             "[load]\nP = \"1/7\"\ncontact_modulus = \"3/2\"\n[shear]\nQ = "
                             "\"1/50\"\nfriction = \"0.5\"\nbulk_tension = \"1/100\"\n";
    std::string mirrored = text;
    mirrored.replace(mirrored.find("\"1/12\""), 6, "\"-1/12\"");
    mirrored.replace(mirrored.find("\"1/50\""), 6, "\"-1/50\"");
    Scene left = ray_scene(text);
    left.ask.edges = {contact::Edge::left};
    const Exact angle = Exact::parse("70");
    const auto one = ray_terms(left, Body::A, angle, 9);
    const auto other = ray_terms(ray_scene(mirrored), Body::A, angle, 9);
    for (std::size_t j = 0; j < one.size(); ++j) {
        CAPTURE(j);
        CHECK(overlaps(one[j].values[0].value, other[j].values[0].value));
        CHECK(overlaps(one[j].values[1].value, other[j].values[1].value));
        CHECK(overlaps(one[j].values[2].value, -other[j].values[2].value));
    }
    CHECK(!contains_zero(one[1].values[2].value));
}

// Without shear sxx = szz = -p on the contact, and sxz = 0 (`johnson1985`, eq. 2.24).
TEST_CASE("terms of the stresses near an edge that vanish are exactly 0") {
    const auto terms =
        ray_terms(ray_scene(ray_contacts().front().text), Body::A, Exact::parse("0"), 4);
    const auto zero = [&](std::size_t j, std::size_t i) {
        return terms[j].values[i].exactly == Rational(0);
    };
    CHECK((zero(0, 0) && zero(0, 1) && zero(0, 2)));
    CHECK((!zero(1, 0) && !zero(1, 1) && zero(1, 2)));
    CHECK((zero(2, 1) && zero(2, 2)));
    CHECK(overlaps(terms[1].values[0].value, terms[1].values[1].value));
}

TEST_CASE("expansions of stresses that are not computed are refused") {
    const std::string text = "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = []\n"
                             "slopes = [\"x^3\"]\n[load]\na = \"1\"\ncontact_modulus = \"1\"\n";
    std::string problem;
    try {
        (void)ray_terms(ray_scene(text), Body::A, Exact::parse("45"), 3);
    } catch (const InputError& error) {
        problem = error.what();
    }
    CHECK(problem.find("the stresses near an edge are expanded for plane power laws") !=
          std::string::npos);
}

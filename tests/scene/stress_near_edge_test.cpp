// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/run_scene.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using scene::Body, scene::Quantity, scene::RayTerm, scene::Scene;

namespace {

constexpr long ray_bits = 400;

/// The right edges are at 1.
const std::string stuck_contact = "tilted-flat-and-rounded alpha=0.1 t=0.4 R=2 a=1 E=3/2 Q=0.1 "
                                  "bulk_tension=-0.2 bulk_A=0.3";
const std::vector<std::string> ray_contacts{
    "flat-and-rounded t=0.4 R=2 a=1 E=3/2",
    "tilted-wedge phi=1/5 alpha=-1/12 a=1 E=3/2",
    "power-law m=5/2 C=1/3 a=1 E=3/2 Q=1/20 bulk_A=1/9 path=together",
    stuck_contact,
    "tilted-wedge phi=1/5 alpha=-1/12 a=1 E=3/2 friction=0.3 sliding=left bulk_tension=0.1",
    "hertz R=2 a=1 E=3/2 Q=-0.1 friction=0.5",
    "power-law m=5/2 C=1/3 a=1 E=3/2 Q=0.05 friction=0.6",
    "tilted-flat-and-rounded alpha=0.1 t=0.4 R=2 a=1 E=3/2 Q=-0.1 friction=0.6 bulk_tension=0.03 "
    "bulk_A=0.2",
    "piecewise symmetric slopes=x+x^3 a=1 E=3/2 Q=-0.1 friction=0.5"};

Scene ray_scene(const std::string& words) { return scenes::made(words + " edges=right digits=30"); }

/// sxx, szz, sxz at the distance r from the right edge at 1, by the formulas at points
/// (contact/enclosure/plane_contact.hpp), which use no expansion.
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
    for (const std::string& words : ray_contacts) {
        CAPTURE(words);
        const Scene s = ray_scene(words);
        for (const std::string angle : {"0", "37", "90", "135", "180"}) {
            const Body body = angle.size() == 2 ? Body::B : Body::A;
            CAPTURE(angle);
            const auto series = ray_terms(s, body, Exact::parse(angle), terms);
            REQUIRE(series.size() == terms);
            CHECK(series.front().halves == (words == stuck_contact ? -1 : 0));
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
    const auto wedge = [](const std::string& alpha, const std::string& Q) {
        return ray_scene("tilted-wedge phi=1/5 alpha=" + alpha + " P=1/7 E=3/2 Q=" + Q +
                         " friction=0.5 bulk_tension=1/100");
    };
    Scene left = wedge("1/12", "1/50");
    left.ask.edges = {contact::Edge::left};
    const Exact angle = Exact::parse("70");
    const auto one = ray_terms(left, Body::A, angle, 9);
    const auto other = ray_terms(wedge("-1/12", "-1/50"), Body::A, angle, 9);
    for (std::size_t j = 0; j < one.size(); ++j) {
        CAPTURE(j);
        CHECK(overlaps(one[j].values[0].value, other[j].values[0].value));
        CHECK(overlaps(one[j].values[1].value, other[j].values[1].value));
        CHECK(overlaps(one[j].values[2].value, -other[j].values[2].value));
    }
    CHECK(!contains_zero(one[1].values[2].value));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace edgeproof::scenes;

namespace {

const double infinite = std::numeric_limits<double>::infinity();
const double no_number = std::numeric_limits<double>::quiet_NaN();

/// Returns places of all kinds in a contact of that length.
std::vector<double> places_in(double length) {
    std::vector<double> u{5e-324, 1e-300, 1e-30, 1e-12};
    for (int k = 1; k < 13; ++k) {
        u.push_back(length * k / 13);
    }
    u.push_back(length / 2); // powers of |x| have their singularity there
    u.push_back(length * (1 - 1e-9));
    u.push_back(std::nextafter(length, 0.0) - length * 1e-15);
    return u;
}

std::vector<double> computed_at(const std::string& words, const Binary64Question& question,
                                const std::vector<double>& places, Edge edge = Edge::right) {
    std::vector<double> values(places.size(), -1);
    Binary64Values(made(words), question)(edge, places, values);
    return values;
}

const Binary64Question q_by_x{.quantity = Quantity::q, .from_origin = true};

} // namespace

// The double words and the balls share no evaluation of p; the balls are compared with other routes
// in values_test.cpp. Some power laws have no form in double words, or are too large for one.
TEST_CASE("binary64 pressures are those nearest to the values of balls") {
    for (const char* words :
         {"power-law m=0 C=0.3 a=1.1 E=7/3", "power-law m=0 C=1 a=1e40 E=7/3",
          "power-law m=5/8 C=2 P=1/7 E=7/3", "power-law m=1/3 C=1 a=3/4 E=7/3",
          "power-law m=1/2 C=1 a=3/4 E=7/3", "power-law m=3/2 C=1 a=3/4 E=7/3",
          "power-law m=2 C=1 a=3/4 E=7/3", "power-law m=7 C=1 a=3/4 E=7/3",
          "power-law m=1000 C=1 a=3/4 E=7/3", "flat-and-rounded t=0.5 R=3 a=1 E=7/3",
          "tilted-wedge phi=0.1 alpha=0.02 a=1 E=7/3",
          "tilted-flat-and-rounded t=1 R=1 alpha=0.01 P=1/5 E=7/3",
          "tilted-flat-and-rounded t=1 R=1 P=1/5 M=-1/50 E=7/3",
          "piecewise symmetric slopes=sinh(x) a=1 E=7/3",
          "piecewise knots=0 slopes=-1/10+x;tanh(x) P=1/9 E=7/3"}) {
        CAPTURE(std::string(words));
        const Scene scene = made(words);
        const Binary64Values pressures(scene);
        const double length = number_of(scene, {Quantity::a}) + number_of(scene, {Quantity::b});
        AskedValue p{Quantity::p};
        SceneValues values(scene, {p}, {40});
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const double u : places_in(length)) {
                CAPTURE(u);
                p.edge = edge;
                p.u = Exact::of(exact_rational(u));
                CHECK(pressures(edge, u) == values.value(p).value.midpoint().convert_to<double>());
            }
        }
    }
}

TEST_CASE("zero at the edges and outside, infinite on a corner, never NaN") {
    const Binary64Values wedge(made("power-law m=0 C=0.3 a=1"));
    for (const double u : {0.0, -0.0, -1.0, 2.0, 3.0, infinite, -infinite}) {
        CAPTURE(u);
        CHECK(wedge(Edge::right, u) == 0);
        CHECK(wedge(Edge::left, u) == 0);
    }
    CHECK(wedge(Edge::right, 1.0) == infinite);
    CHECK(std::isfinite(wedge(Edge::right, std::nextafter(1.0, 0.0))));
    CHECK(std::isfinite(wedge(Edge::right, std::nextafter(1.0, 2.0))));
    CHECK(wedge(Edge::right, std::nextafter(2.0, 0.0)) > 0);
    CHECK_THROWS_AS((void)wedge(Edge::right, no_number), DomainError);
    // A knot is no corner: at the end of the flat g' has a bend and p is finite.
    CHECK(std::isfinite(Binary64Values(made("flat-and-rounded t=0.5 R=3 a=1"))(Edge::right, .5)));
    CHECK_THROWS_AS(Binary64Values(made("flat-and-rounded t=2 R=1 a=1")), InputError);
}

// Edges that are numbers, but are not computed exactly: b = a/3 with sin(pi alpha/2 phi) = 1/2, and
// p = sqrt(u (2a - u))/2 at u = 2 in a contact of a = 1 + e is sqrt(e), far below the precision of
// a solved edge.
TEST_CASE("places at edges and corners that are not known numbers") {
    const Binary64Values wedge(made("tilted-wedge phi=1 alpha=1/3 a=3"));
    CHECK(wedge(Edge::left, 1) == infinite);
    CHECK(wedge(Edge::right, 3) == infinite);
    CHECK(wedge(Edge::left, 4) == 0);
    CHECK(wedge(Edge::right, 4) == 0);
    CHECK(wedge(Edge::left, std::nextafter(4.0, 0.0)) > 0);
    const auto hertz = [](const std::string& a) {
        return Binary64Values(made("hertz R=1 P=pi/4*(" + a + ")^2"));
    };
    CHECK(hertz("1+1e-40")(Edge::right, 2) == 1e-20);
    CHECK(hertz("1+1e-60")(Edge::right, 2) == 1e-30);
    CHECK(hertz("1+1e-300")(Edge::left, 2) == 1e-150);
    CHECK(hertz("1-1e-300")(Edge::right, 2) == 0);
    CHECK(hertz("1")(Edge::right, 2) == 0);
}

TEST_CASE("arrays of a history and of axisymmetric profiles are those of single values") {
    const std::string history = "hertz R=1 friction=1/2 [P=pi/4] [Q=pi/16] [Q=0]";
    // By hand, as in values.txt.
    CHECK(computed_at(history, q_by_x, {0})[0] ==
          doctest::Approx((std::sqrt(3.0) - 1) / 4 - std::sqrt(2.0) / 8).epsilon(1e-13));
    const std::string round = "axisymmetric flat-and-rounded t=1/2 R=1 P=1 Q=0.3 friction=1/2";
    const Scene scene = made(round);
    for (const auto& [quantity, n] : {std::pair{Quantity::p, std::size_t{0}},
                                      {Quantity::q, std::size_t{0}},
                                      {Quantity::local, std::size_t{2}}}) {
        AskedValue asked{quantity, n};
        for (const double u : {1.0 / 8, 1.0 / 4}) {
            asked.u = Exact::of(exact_rational(u));
            CHECK(computed_at(round, {.quantity = quantity, .n = n}, {u})[0] ==
                  number_of(scene, asked));
        }
    }
}

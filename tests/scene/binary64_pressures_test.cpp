// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "tests/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace edgeproof::scenes;
using edgeproof::contact::Edge;

namespace {

std::string contact_of(const std::string& keys, const std::string& load = "a = \"1\"") {
    return "[profile]\n" + keys + "\n[load]\n" + load + "\ncontact_modulus = \"7/3\"\n";
}

const std::vector<std::string> contacts{
    contact_of("kind = \"power-law\"\nm = \"0\"\nC = \"0.3\""),
    contact_of("kind = \"power-law\"\nm = \"5/8\"\nC = \"2\"", "P = \"1/7\""),
    contact_of("kind = \"flat-and-rounded\"\nt = \"0.5\"\nR = \"3\""),
    contact_of("kind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.02\""),
    contact_of("kind = \"tilted-flat-and-rounded\"\nt = \"1\"\nR = \"1\"\nalpha = \"0.01\"",
               "P = \"1/5\""),
    contact_of("kind = \"piecewise\"\nsymmetric = true\nslopes = [\"sinh(x)\"]"),
    contact_of("kind = \"piecewise\"\nknots = [\"0\"]\nslopes = [\"-1/10 + x\", \"tanh(x)\"]",
               "P = \"1/9\""),
};

/// Returns places of all kinds in a contact of that length.
std::vector<double> places(double length) {
    std::vector<double> u{5e-324, 1e-300, 1e-30, 1e-12};
    for (int k = 1; k < 13; ++k) {
        u.push_back(length * k / 13);
    }
    u.push_back(length * (1 - 1e-9));
    u.push_back(std::nextafter(length, 0.0) - length * 1e-15);
    return u;
}

} // namespace

TEST_CASE("each is the binary64 nearest to what another route gives with 40 digits") {
    for (const std::string& text : contacts) {
        CAPTURE(text);
        const Scene scene = parsed(text);
        const Binary64Values pressures(scene);
        const contact::NormalContact contact(*scene.profile, scene.contact_modulus, scene.load, 40);
        const double length = contact.a().convert_to<double>() + contact.b().convert_to<double>();
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const double u : places(length)) {
                CAPTURE(u);
                // This route uses another formula than Binary64Values.
                const contact::Estimated p = contact.pressure(edge, formula::Exact::of(Rational(u)),
                                                              contact::Route::singular_integral);
                CHECK(pressures(edge, u) == p.value.convert_to<double>());
            }
        }
    }
}

TEST_CASE("zero at the edges and outside, infinite on a corner, never NaN") {
    const Binary64Values wedge(parsed(contacts[0]));
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double u : {0.0, -0.0, -1.0, 2.0, 3.0, infinity, -infinity}) {
        CAPTURE(u);
        CHECK(wedge(Edge::right, u) == 0);
        CHECK(wedge(Edge::left, u) == 0);
    }
    CHECK(wedge(Edge::right, 1.0) == infinity);
    CHECK(std::isfinite(wedge(Edge::right, std::nextafter(1.0, 0.0))));
    CHECK(std::isfinite(wedge(Edge::right, std::nextafter(1.0, 2.0))));
    CHECK(wedge(Edge::right, std::nextafter(2.0, 0.0)) > 0);
    CHECK_THROWS_AS((void)wedge(Edge::right, std::numeric_limits<double>::quiet_NaN()),
                    DomainError);
}

// Edges that are numbers, but are not computed exactly: b = a/3 with sin(pi alpha/2 phi) = 1/2, and
// a = 1 with P = pi/4 (E* = C = 1).
TEST_CASE("zero on a far edge, infinite on a corner, where the edge is not a known number") {
    const double inf = std::numeric_limits<double>::infinity();
    const Binary64Values wedge(
        parsed(contact_of("kind = \"tilted-wedge\"\nphi = \"1\"\nalpha = \"1/3\"", "a = \"3\"")));
    CHECK(wedge(Edge::left, 1) == inf);
    CHECK(wedge(Edge::right, 3) == inf);
    CHECK(wedge(Edge::left, 4) == 0);
    CHECK(wedge(Edge::right, 4) == 0);
    CHECK(wedge(Edge::left, std::nextafter(4.0, 0.0)) > 0);
}

// p = sqrt(u (2a - u))/2 at u = 2 in a contact of a = 1 + e is sqrt(e), far below the precision of
// a solved edge.
TEST_CASE("a place closer to the far edge than 55 digits resolve") {
    const auto hertz = [](const std::string& a) {
        return Binary64Values(
            parsed("[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\nP = \"pi/4*(" +
                   a + ")^2\"\ncontact_modulus = \"1\"\n"));
    };
    CHECK(hertz("1 + 1e-40")(Edge::right, 2) == 1e-20);
    CHECK(hertz("1 + 1e-60")(Edge::right, 2) == 1e-30);
    CHECK(hertz("1 + 1e-300")(Edge::left, 2) == 1e-150);
    CHECK(hertz("1 - 1e-300")(Edge::right, 2) == 0);
    CHECK(hertz("1")(Edge::right, 2) == 0);
}

TEST_CASE("an array of places is the places one by one") {
    const Binary64Values half(parsed(contact_of("kind = \"power-law\"\nm = \"1/2\"\nC = \"1\"")));
    const std::vector<double> u{0, 1e-20, 0.25, 1, 1.5, 2, 3};
    std::vector<double> p(u.size(), -1);
    half(Edge::left, u, p);
    for (std::size_t i = 0; i < u.size(); ++i) {
        CHECK(p[i] == half(Edge::left, u[i]));
    }
    // The greatest pressure is in the middle.
    CHECK(p[3] == *std::ranges::max_element(p));
}

TEST_CASE("a knot is no corner") {
    // At x = t, the end of the flat, g' has a bend and p is finite.
    CHECK(std::isfinite(Binary64Values(parsed(contacts[2]))(Edge::right, 0.5)));
}

TEST_CASE("a tilt that is solved for") {
    const Scene scene = parsed(contact_of(
        "kind = \"tilted-flat-and-rounded\"\nt = \"1\"\nR = \"1\"", "P = \"1/5\"\nM = \"-1/50\""));
    const Binary64Values pressures(scene);
    Scene one = scene;
    one.ask.quantities = {QuantityGroup::pressure};
    one.ask.route = contact::Route::singular_integral; // not the closed form
    one.ask.u = {{formula::Exact::of(Rational(0.125)), 0}};
    const SceneResult result = run_scene(one);
    CHECK(pressures(Edge::right, 0.125) ==
          result.points()[0].at(Quantity::p).value.midpoint().convert_to<double>());
}

TEST_CASE("a load that no contact carries is refused") {
    CHECK_THROWS_AS(
        Binary64Values(parsed(contact_of("kind = \"flat-and-rounded\"\nt = \"2\"\nR = \"1\""))),
        InputError);
}

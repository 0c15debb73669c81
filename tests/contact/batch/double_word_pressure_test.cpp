// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/double_word_pressure.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

using namespace edgeproof;

namespace {

struct Pressed {
    Profile profile;
    Load load;
};

std::vector<Pressed> pressed() {
    const auto a = [](const char* text) {
        return Load{Load::Kind::right_edge, Exact::parse(text)};
    };
    const auto P = [](const char* text) { return Load{Load::Kind::force, Exact::parse(text)}; };
    const auto x = [](const char* text) { return Exact::parse(text); };
    return {{Profile::power_law(x("1/3"), x("1")), a("2")},
            {Profile::power_law(x("0.1"), x("0")), P("7")},
            {Profile::flat_and_rounded(x("1/2"), x("30")), P("1e-3")},
            {Profile::tilted_wedge(x("1/10"), x("1/11")), a("1e9")},
            {Profile::tilted_flat_and_rounded(x("1/100"), x("2/5"), x("1")), P("1/5")}};
}

} // namespace

TEST_CASE("in double words: the binary64 nearest to the singular integral at 40 digits") {
    std::size_t decided = 0;
    for (const Pressed& c : pressed()) {
        const Exact modulus = Exact::parse("7/3");
        const DoubleWordPressure pressure(BallContact(c.profile, modulus, c.load, 128));
        const NormalContact contact(c.profile, modulus, c.load, 40);
        const double length = (contact.a() + contact.b()).convert_to<double>();
        for (const Edge edge : {Edge::right, Edge::left}) {
            for (const double u : {1e-40, 1e-9, 0.003, 0.21, 0.4999, 0.73, 1 - 1e-9}) {
                CAPTURE(u);
                const double at = length * u;
                const auto p = pressure.nearest(edge, at);
                if (!p) {
                    continue;
                }
                ++decided;
                // Another formula, by quadrature.
                CHECK(*p ==
                      contact.pressure(edge, Exact::of(Rational(at)), Route::singular_integral)
                          .value.convert_to<double>());
            }
        }
    }
    CHECK(decided >= 68); // of 70
}

TEST_CASE("in double words: outside, on a corner, tiny or not a number is left to others") {
    const Exact one = Exact::parse("1");
    const DoubleWordPressure wedge(BallContact(Profile::power_law(one, Exact::parse("0")), one,
                                               {Load::Kind::right_edge, one}, 128));
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double u : {0.0, -0.0, -1.0, 1.0, 2.0, 3.0, 5e-324, 1e-300, infinity, -infinity,
                           std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(u);
        CHECK_FALSE(wedge.nearest(Edge::right, u));
        CHECK_FALSE(wedge.nearest(Edge::left, u));
    }
    CHECK(wedge.nearest(Edge::right, std::nextafter(1.0, 0.0)));
    CHECK(wedge.nearest(Edge::right, std::nextafter(2.0, 0.0)));
    const DoubleWordPressure vast(BallContact(Profile::power_law(one, Exact::parse("0")), one,
                                              {Load::Kind::right_edge, Exact::parse("1e40")}, 128));
    CHECK_FALSE(vast.nearest(Edge::right, 1e30));
}

TEST_CASE("in double words: a thread that rounds upwards is left to others") {
    const Exact one = Exact::parse("1");
    const DoubleWordPressure hertz(
        BallContact(Profile::power_law(one, one), one, {Load::Kind::right_edge, one}, 128));
    REQUIRE(hertz.nearest(Edge::right, 0.1));
    const int before = std::fegetround();
    REQUIRE(std::fesetround(FE_UPWARD) == 0);
    const auto p = hertz.nearest(Edge::right, 0.1);
    std::fesetround(before);
    CHECK_FALSE(p);
}

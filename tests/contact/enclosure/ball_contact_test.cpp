// SPDX-License-Identifier: BSD-3-Clause
#include "tests/contact/by_witness.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace edgeproof::scenes;

namespace {

std::vector<Contact> all_closed() {
    std::vector<Contact> all = symmetric();
    for (const Contact& c : tilted()) {
        all.push_back(c);
    }
    return all;
}

} // namespace

TEST_CASE("balls hold what the witness finds, and are narrow") {
    for (const Contact& c : all_closed()) {
        CAPTURE(c.name);
        CHECK(digits_shared(c, 50, Route::singular_integral, {"1e-30", "0.013", "0.3", "0.47"}) >=
              50);
    }
}

TEST_CASE("escalation reaches the requested digits in the hard places") {
    const Contact flat = symmetric()[6];
    // Points at 1e-30 from a knot, on it, and 1e-300 from the edge.
    for (const char* u : {"1.1000000000000000000000000000001", "1.1", "1e-300"}) {
        CAPTURE(u);
        const Ball p =
            enclosed_pressure(flat.profile, flat.modulus, flat.load, Edge::right, exact(u), 50);
        CHECK(round_ball(p, 50).complete);
        const Witness contact(flat.profile, flat.modulus, flat.load, 55);
        const PrecisionScope scope(60);
        CHECK(common_digits(contact.pressure(Edge::right, exact(u), Route::singular_integral).value,
                            p.midpoint()) >= 50);
    }
    // The pressure is infinite at the apex of a wedge: the budget ends without a guess.
    const Contact wedge = tilted()[0];
    CHECK_THROWS_AS((void)enclosed_pressure(wedge.profile, wedge.modulus, wedge.load, Edge::right,
                                            exact("1.5"), 50),
                    BudgetError);
    CHECK_THROWS_AS(
        BallContact(own_symmetric().profile, exact("1"), Load::right_edge(exact("1")), 100),
        DomainError);
}

TEST_CASE(
    "balls of the expansion hold the coefficients of the witness, at both edges, and are narrow") {
    for (const Contact& c : all_closed()) {
        CAPTURE(c.name);
        const BallContact contact(c.profile, c.modulus, c.load, 1200);
        for (const Edge edge : {Edge::right, Edge::left}) {
            if (edge == Edge::left && c.profile.symmetric()) {
                continue;
            }
            const std::vector<Ball> balls = contact.expansion(edge, 12);
            REQUIRE(balls.size() == 12);
            check_coefficients(c, contact, edge, 3, 24);
            for (std::size_t k = 0; k < 12; ++k) {
                CAPTURE(k);
                const Real natural = abs(balls[0].midpoint()) *
                                     pow(contact.reach(edge).midpoint(), -static_cast<int>(k));
                const bool narrow = balls[k].relative_accuracy_bits() > 165 ||
                                    balls[k].radius() < natural * Real("1e-50");
                CHECK(narrow);
            }
        }
    }
}

TEST_CASE("the expansion of a stick zone is that of its pressure, also off the origin") {
    constexpr long zone_bits = 300;
    const auto number = [](const char* x) { return enclosed_constant(exact(x), zone_bits); };
    const Ball u = number("1e-6");
    for (const std::string& words :
         std::vector<std::string>{"power-law m=1 C=1 a=1", "flat-and-rounded t=0.3 R=1 a=1",
                                  "tilted-flat-and-rounded alpha=0.01 t=0.3 R=1 a=1"}) {
        CAPTURE(words);
        const Contact c = contact_of(words);
        const BallContact whole(c.profile, c.modulus, c.load, zone_bits);
        for (const std::pair<const char*, const char*> at :
             {std::pair{"0.7", "-0.1"}, {"-0.1", "0.8"}, {"0.9", "0.2"}}) {
            CAPTURE(at.first);
            const BallContact zone = whole.between(number(at.first), number(at.second));
            for (const Edge edge : {Edge::right, Edge::left}) {
                const std::vector<Ball> c_k = zone.expansion(edge, 3);
                const Ball sum = sqrt(u) * (c_k[0] + u * (c_k[1] + u * c_k[2]));
                CHECK(certainly_less(abs(sum / zone.pressure(edge, u) - 1), number("1e-12")));
            }
        }
    }
}

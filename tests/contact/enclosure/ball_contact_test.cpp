// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

using namespace edgeproof::scenes;

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
        for (const std::pair<const char*, const char*>& at :
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

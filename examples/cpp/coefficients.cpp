// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficients of the pressure at both edges of a tilted wedge, proved:
//     p(u) = c_0 u^(1/2) + c_1 u^(3/2) + c_2 u^(5/2) + ...    u: distance inwards from the edge
// The left edge is not given: it follows from the profile and the right edge.
#include "edgeproof/contact/contact.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <iostream>
#include <vector>

int main() {
    using namespace edgeproof;
    using namespace edgeproof::contact;
    using formula::Exact;

    // Half-angle pi/2 - phi, tilted clockwise by alpha: exact, as formulas are.
    const Profile wedge = Profile::tilted_wedge(Exact::parse("pi/16"), Exact::parse("pi/64"));
    const Exact modulus = Exact::parse("1");
    const Load load = Load::right_edge(Exact::parse("1"));
    constexpr unsigned digits = 30;
    constexpr std::size_t terms = 4;
    const BallContact contact(wedge, modulus, load, 256); // more bits than 30 digits need

    for (const Edge edge : {Edge::right, Edge::left}) {
        const std::vector<Ball> c = contact.expansion(edge, terms);
        for (std::size_t k = 0; k < terms; ++k) {
            std::cout << (edge == Edge::right ? "right" : "left") << " c_" << k << ' '
                      << round_ball(c[k], digits).text << '\n';
        }
    }
}

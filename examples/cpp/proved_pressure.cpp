// SPDX-License-Identifier: BSD-3-Clause
// A proved pressure: a flat punch with rounded corners, one hundredth from the edge.
//
// Units are yours as long as they agree. Here lengths are in units of a, pressures in units of E*.
#include "edgeproof/contact/contact.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <iostream>

int main() {
    using namespace edgeproof;
    using namespace edgeproof::contact;
    using formula::Exact;

    // Numbers go in as text and mean exactly that: "1/100" is no binary fraction near it.
    const Profile punch = Profile::flat_and_rounded(Exact::parse("0.4"), Exact::parse("1")); // t, R
    const Exact modulus = Exact::parse("1");                                                 // E*
    const Load load = Load::right_edge(Exact::parse("1")); // a; or Load::force for P
    const Exact u = Exact::parse("1/100");                 // distance inwards from the edge

    try {
        // The exact pressure lies in the ball, whose radius is below 10^-52 of it. The working
        // precision is found, not given.
        const Ball p = enclosed_pressure(punch, modulus, load, Edge::right, u, 50);
        std::cout << "p      " << round_ball(p, 50).text << '\n'; // every digit is right
        std::cout << "within " << round_ball(p, 20, Rounding::down).text << " ... "
                  << round_ball(p, 20, Rounding::up).text << '\n';
    } catch (const Error& error) { // bad input, a place outside the contact, too few bits
        std::cerr << error.what() << '\n';
        return 2;
    }
}

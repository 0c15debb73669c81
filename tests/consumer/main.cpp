// SPDX-License-Identifier: BSD-3-Clause
// An outside project: the pressure of a Hertzian contact, by a route and as an enclosure. With
// E* = 2, R = 1, a = 1 it is sqrt(1 - x^2) exactly: at x = 3/5, 0.8.
#include "edgeproof/contact/contact.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <iostream>

int main() {
    using namespace edgeproof;
    using namespace edgeproof::contact;
    using formula::Exact;
    const Profile hertz = Profile::power_law(Exact::parse("1"), Exact::parse("1"));
    const Exact modulus = Exact::parse("2");
    const Load load = Load::right_edge(Exact::parse("1"));
    const Exact u = Exact::parse("2/5");

    const Witness witness(hertz, modulus, load, 50);
    const auto p = witness.pressure(Edge::right, u, Route::barber_mossakovskii);
    std::cout << to_decimal(p.value, 50) << '\n';

    const Ball enclosed = enclosed_pressure(hertz, modulus, load, Edge::right, u, 50);
    std::cout << round_ball(enclosed, 50).text << '\n';
}

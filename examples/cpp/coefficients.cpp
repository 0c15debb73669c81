// SPDX-License-Identifier: BSD-3-Clause
// The coefficients of the pressure at both edges of a tilted wedge, proved:
//     p(u) = c_0 u^(1/2) + c_1 u^(3/2) + c_2 u^(5/2) + ...    u: distance inwards from the edge
// The left edge is not given: it follows from the profile and the right edge.
#include <edgeproof/edgeproof.hpp>

#include <iostream>

int main() {
    // Half-angle pi/2 - phi, tilted clockwise by alpha: exact, as formulas are.
    const edgeproof::Scene wedge("kind=tilted-wedge phi=pi/16 alpha=pi/64 a=1 contact_modulus=1");
    for (const std::string edge : {"right", "left"}) {
        for (const char* const c : {"c_0", "c_1", "c_2", "c_3"}) {
            std::cout << edge << ' ' << c << ' ' << wedge.value(c, "edge=" + edge, 30).text << '\n';
        }
    }
}

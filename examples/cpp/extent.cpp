// SPDX-License-Identifier: BSD-3-Clause
// How far from the edge are one, two and three terms within 1 % of the pressure?
#include <edgeproof/edgeproof.hpp>

#include <iostream>

int main() {
    const edgeproof::Scene cylinder("kind=hertz R=1 a=1 contact_modulus=1");
    for (const char* const extent : {"extent_1", "extent_2", "extent_3"}) {
        const edgeproof::Value u = cylinder.value(extent, "tolerance=1%", 20);
        std::cout << extent << " = " << u.text << (u.proved ? ", proved" : ", estimated") << '\n';
    }
}

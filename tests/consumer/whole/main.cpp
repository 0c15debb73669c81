// SPDX-License-Identifier: BSD-3-Clause
// An outside project that names no module. With E* = 2, R = 1, a = 1 the pressure is
// sqrt(1 - x^2), sqrt(0.19) at x = 9/10, and c_0 = sqrt(2).
#include <edgeproof/edgeproof.hpp>

#include <iostream>

int main() {
    const edgeproof::Scene hertz("kind=hertz R=1 a=1 contact_modulus=2");
    for (const edgeproof::Value& v : hertz.values({{"p", "u=1/10"}, {"c_0"}}, 20)) {
        std::cout << v.text << ' ' << v.route << '\n';
    }
}

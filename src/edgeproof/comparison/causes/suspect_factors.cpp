// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/suspect_maker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace edgeproof::comparison {

void suspect_factors(const SuspectMaker& make) {
    const auto both_ways = [&](const char* name, const std::string& what, double k) {
        make.add(name, "p is " + what + " times too large",
                 [&](std::size_t i) { return k * make.exact_pressure(i); });
        make.add(name, "p is " + what + " times too small",
                 [&](std::size_t i) { return make.exact_pressure(i) / k; });
    };
    const double pi = std::numbers::pi;
    both_ways("factor-2", "2", 2);
    both_ways("factor-pi", "pi", pi);
    both_ways("factor-pi", "2 pi", 2 * pi);
    both_ways("factor-sqrt-pi", "sqrt(pi)", std::sqrt(pi));
    // K = sqrt(2 pi) c_0: the stress intensity of fracture mechanics.
    both_ways("factor-sqrt-2-pi", "sqrt(2 pi)", std::sqrt(2 * pi));
    both_ways("unit-g", "9.80665", 9.80665);
    // One psi is 6894.757 Pa; one MPa is 145.038 psi.
    both_ways("unit-psi", "145.038", 1e6 / 6894.757293168);
    for (const double ten : {1.0, 1e-3, 1e3}) {
        both_ways("unit-psi", fmt::format("{:g}", 6894.757293168 * ten), 6894.757293168 * ten);
    }
    for (const int n : {1, 2, 3, 4, 5, 6, 9}) {
        both_ways("power-of-ten", fmt::format("1e{}", n), std::pow(10.0, n));
    }
    const ExactContact& exact = make.exact();
    const auto scale = [&](const char* name, double k) {
        const double origin = make.nodes().data.origin; // undoes the shift that was found
        make.add(name, fmt::format("x is {:g} times too large", k), exact.a().value * k - origin,
                 exact.b().value * k + origin, [&](std::size_t i) {
                     return make.pressure(exact, (make.nodes()[i].x + origin) / k);
                 });
    };
    for (const int n : {1, 2, 3, 6}) {
        scale("power-of-ten", std::pow(10.0, n));
        scale("power-of-ten", std::pow(10.0, -n));
    }
    scale("unit-inch", 25.4);
    scale("unit-inch", 1 / 25.4);
    scale("full-width-for-half", 2);
    scale("full-width-for-half", 0.5);
}

} // namespace edgeproof::comparison

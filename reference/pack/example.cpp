// SPDX-License-Identifier: BSD-3-Clause
// Hertz's line contact in double, as an example of a code that answers some of the pack.
#include "edgeproof_case.hpp"

#include <cmath>

std::optional<double> edgeproof_answer(const EdgeproofCase& c) {
    const double pi = std::acos(-1.0);
    if (c.kind != "power-law" || c.m != 1) {
        return std::nullopt;
    }
    const double a = std::isnan(c.a) ? std::sqrt(4 * c.P / (pi * c.E * c.C)) : c.a;
    const double k = c.E * c.C / 2; // p = k sqrt(a^2 - x^2)
    if (c.quantity == "p") {
        return k * std::sqrt(c.u * (2 * a - c.u));
    }
    if (c.quantity == "c_0") {
        return k * std::sqrt(2 * a);
    }
    if (c.quantity == "c_1") {
        return -k * std::sqrt(2 * a) / (4 * a);
    }
    if (c.quantity == "c_2") {
        return -k * std::sqrt(2 * a) / (32 * a * a);
    }
    if (c.quantity == "P") {
        return k * pi * a * a / 2;
    }
    if (c.quantity == "a" || c.quantity == "b") {
        return a;
    }
    return std::nullopt;
}

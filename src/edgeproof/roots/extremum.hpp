// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <utility>

namespace edgeproof::roots {

/// The place of the least value of a function with one minimum in (lo, hi), by golden section: one
/// evaluation a step, each of which shrinks the interval by 0.618. No bound: near a minimum values
/// are flat, so half the digits of Number are all that can be had. `found(value)` ends the search
/// as soon as it is true of either of the two values held.
template <class Number, class Function, class Found>
[[nodiscard]] Number place_of_minimum(const Function& f, Number lo, Number hi, int steps,
                                      const Found& found) {
    using std::sqrt;
    const Number golden = (sqrt(Number(5)) - 1) / 2;
    Number x = hi - golden * (hi - lo);
    Number y = lo + golden * (hi - lo);
    Number at_x = f(x);
    Number at_y = f(y);
    for (int k = 0; k < steps && !found(at_x) && !found(at_y); ++k) {
        if (at_x < at_y) {
            hi = y;
            y = x;
            at_y = at_x;
            x = hi - golden * (hi - lo);
            at_x = f(x);
        } else {
            lo = x;
            x = y;
            at_x = at_y;
            y = lo + golden * (hi - lo);
            at_y = f(y);
        }
    }
    return at_x < at_y ? x : y;
}

template <class Number, class Function>
[[nodiscard]] Number place_of_minimum(const Function& f, Number lo, Number hi, int steps) {
    return place_of_minimum(f, std::move(lo), std::move(hi), steps,
                            [](const Number&) { return false; });
}

} // namespace edgeproof::roots

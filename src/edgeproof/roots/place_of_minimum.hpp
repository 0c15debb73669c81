// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <utility>

namespace edgeproof::roots {

/// The place of the minimum of a function with one minimum in (lo, hi), by golden section
/// (`kiefer1953`): each step needs one evaluation and shrinks the interval by the factor 0.618.
/// There is no proved bound. Near a minimum the values are flat, so that only half the digits of
/// Number can be reached. The search ends when `found(value)` is true for either of the two current
/// values.
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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

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

/// y = factor x^exponent, by least squares in the logarithms (DLMF 3.11(v)). Units: those of the
/// points.
struct PowerLawFit {
    double factor = 0;
    double exponent = 0;
    std::size_t points = 0;
};

/// The fit of the points with x > 0 and y > 0. Returns nothing if there are fewer than two
/// different x. This is an estimate.
[[nodiscard]] inline std::optional<PowerLawFit>
power_law_fit(const std::vector<std::pair<double, double>>& points) {
    double n = 0;
    double sx = 0;
    double sy = 0;
    double sxx = 0;
    double sxy = 0;
    for (const auto& [x, y] : points) {
        if (x > 0 && y > 0) {
            const double lx = std::log(x);
            const double ly = std::log(y);
            n += 1;
            sx += lx;
            sy += ly;
            sxx += lx * lx;
            sxy += lx * ly;
        }
    }
    const double determinant = n * sxx - sx * sx;
    if (n < 2 || !(determinant > 1e-9 * n * sxx)) {
        return {};
    }
    const double exponent = (n * sxy - sx * sy) / determinant;
    return PowerLawFit{std::exp((sy - exponent * sx) / n), exponent, static_cast<std::size_t>(n)};
}

} // namespace edgeproof::roots

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace edgeproof::roots {

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

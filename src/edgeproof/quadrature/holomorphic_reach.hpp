// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/acb_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

namespace edgeproof::quadrature {

/// An ellipse about the interval centre +- half in which a function is holomorphic: its foci are
/// the ends of the interval, and its semi-axes half (rho +- 1/rho)/2 (`trefethen2013`, chapter 8).
struct BernsteinEllipse {
    double half;
    double rho;

    /// The ellipse that crosses the real axis at the distance `excess` beyond either end.
    [[nodiscard]] static BernsteinEllipse beyond(double half, double excess) {
        const double e = excess / half;
        return {half, 1 + e + std::sqrt(e * (e + 2))};
    }
    /// The distance beyond the ends at which it crosses the real axis.
    [[nodiscard]] double excess() const { return half * (rho - 1) * (rho - 1) / (2 * rho); }
    /// The semi-axis in the imaginary direction.
    [[nodiscard]] double height() const { return half * (rho - 1 / rho) / 2; }
};

/// ln of the error of the Gauss-Legendre rule of n nodes for a function that is at most exp(ln_M)
/// in size inside the ellipse: 64 M/(15 (rho - 1) rho^(2n-1)) for an interval of length 2
/// (`trefethen2013`, theorem 19.3).
[[nodiscard]] inline double gauss_legendre_log_error(const BernsteinEllipse& e, double ln_M,
                                                     std::size_t n) {
    return std::log(64.0 / 15 * e.half) + ln_M - std::log(e.rho - 1) -
           (2 * static_cast<double>(n) - 1) * std::log(e.rho);
}

/// The number of nodes for which this error is at most exp(ln_tolerance).
[[nodiscard]] inline double gauss_legendre_nodes_needed(const BernsteinEllipse& e, double ln_M,
                                                        double ln_tolerance) {
    const double one = gauss_legendre_log_error(e, ln_M, 1);
    return std::max(1.0, 1 + (one - ln_tolerance) / (2 * std::log(e.rho)));
}

/// The next larger number of nodes for which a table is made; wastes less than an eighth of the
/// nodes.
[[nodiscard]] inline std::size_t rounded_up_nodes(double n) {
    std::size_t size = 2;
    while (static_cast<double>(size) < n) {
        size += std::max<std::size_t>(2, size / 20 * 2);
    }
    return size;
}

/// An ellipse about an interval in which a function is proved to be holomorphic, and a bound of it.
struct HolomorphicReach {
    BernsteinEllipse ellipse;
    double ln_bound;
};

/// F(out, phi) encloses the values of a function of phi over a complex ball; not finite if the
/// function may not be holomorphic on all of it.
using ComplexFunction = std::function<void(acb_t out, const acb_t phi)>;
/// Returns, among a sequence of ellipses, the one that needs the fewest nodes for a tolerance of
/// exp(ln_tolerance) relative to the function, and extends at most `most_excess` beyond the
/// interval; nothing if no ellipse is proved. Every ellipse is covered with balls, so that the
/// result is proved; an ellipse that is not found may still be valid (docs/pressure.md, "Many
/// points of one contact"). `centre`, `half` and `most_excess` have the unit of phi.
[[nodiscard]] std::optional<HolomorphicReach> holomorphic_reach(const ComplexFunction& f,
                                                                double centre, double half,
                                                                double most_excess,
                                                                double ln_tolerance);

} // namespace edgeproof::quadrature

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <vector>

namespace edgeproof::quadrature {

/// A rule for the mean of f over 0 < t < 1 with the weight t^p (1 - t)^r, p, r > -1: end points
/// that no polynomial comes near are in the weights, and f need only be smooth. Exact for
/// polynomials of degree below the number of nodes, which are Gauss-Legendre's; the weights add up
/// to 1. Made of products and small quotients only, whatever p and r are, in n^2 steps.
struct ProductRule {
    std::vector<Real> t;
    std::vector<Real> from_end; ///< 1 - t
    std::vector<Real> weight;
    double size = 0; ///< of the sum of |weight|

    /// At the thread's working precision.
    ProductRule(std::size_t n, const Real& p, const Real& r);
};

/// ln of the rule's error for a function that is at most exp(ln_M) inside the ellipse `rho`: twice
/// what the best polynomial of degree n - 1 leaves (Trefethen, Approximation Theory and
/// Approximation Practice, theorem 8.2), over the weight and over the rule.
[[nodiscard]] double product_rule_log_error(std::size_t n, double rho, double ln_M, double size);

} // namespace edgeproof::quadrature

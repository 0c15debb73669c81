// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace edgeproof::quadrature {

/// The Gauss-Legendre rule of n nodes over -1 < x < 1, each number within about one unit of its
/// last bit (Arb's roots, proved: F. Johansson and M. Mezzarobba, SIAM J. Sci. Comput. 40 (2018)
/// C726). Only x >= 0 is kept, from the outermost inwards; the rule is symmetric.
struct GaussLegendreRule {
    std::size_t n = 0;
    std::vector<Real> x;
    std::vector<Real> from_end; ///< 1 - x, to its own last bit
    std::vector<Real> weight;
};

/// The rule at `bits` of precision: one table a number of nodes and precision for all threads,
/// built by whoever asks first and never changed after. n >= 1.
[[nodiscard]] std::shared_ptr<const GaussLegendreRule> gauss_legendre_rule(std::size_t n,
                                                                           long bits);

} // namespace edgeproof::quadrature

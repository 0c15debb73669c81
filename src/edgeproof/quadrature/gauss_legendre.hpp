// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace edgeproof::quadrature {

/// The Gauss-Legendre rule of n nodes over -1 < x < 1, enclosed (Arb's roots: F. Johansson and
/// M. Mezzarobba, SIAM J. Sci. Comput. 40 (2018) C726). Only x >= 0 is kept, from the outermost
/// inwards; the rule is symmetric.
struct GaussLegendreBalls {
    std::vector<Ball> x;
    std::vector<Ball> weight;
};

/// The rule at a working precision of `bits`. A table is built by whoever asks first, for all
/// threads, and never changed after; the most recent ones are kept. n >= 1.
[[nodiscard]] std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n,
                                                                             long bits);
/// How many tables are kept now, and the most that ever are.
[[nodiscard]] std::size_t gauss_legendre_tables();
constexpr std::size_t most_gauss_legendre_tables = 64;

/// The same rule, each number within about one unit of its last bit.
struct GaussLegendreRule {
    std::vector<Real> x;
    std::vector<Real> from_end; ///< 1 - x, to its own last bit
    std::vector<Real> weight;
};

/// In numbers of `bits` of precision. n >= 1.
[[nodiscard]] GaussLegendreRule gauss_legendre_rule(std::size_t n, long bits);

} // namespace edgeproof::quadrature

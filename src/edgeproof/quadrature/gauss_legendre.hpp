// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace edgeproof::quadrature {

/// The Gauss-Legendre rule of n nodes over -1 < x < 1, enclosed (Arb's roots:
/// `johansson-mezzarobba2018`). Only nodes x >= 0 are stored, from the outermost inwards; the rule
/// is symmetric.
struct GaussLegendreBalls {
    std::vector<Ball> x;
    std::vector<Ball> weight;
};

/// The rule at a working precision of `bits`, n >= 1. A table is built at its first use in a
/// thread, which keeps the most recent ones.
[[nodiscard]] std::shared_ptr<const GaussLegendreBalls> gauss_legendre_balls(std::size_t n,
                                                                             long bits);

} // namespace edgeproof::quadrature

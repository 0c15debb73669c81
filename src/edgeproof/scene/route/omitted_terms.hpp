// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::scene {

/// A power series in u whose coefficients are enclosed, with |c_k| <= most/radius^k for all k.
struct BoundedSeries {
    std::function<std::vector<Ball>(std::size_t)> coefficients; ///< the first n coefficients
    Ball most;
    Ball radius;
};

/// Returns the sum of c_k u^k over all k >= n, without a difference of nearly equal numbers: enough
/// terms for the bits of u, and a bound of the others. The result is not finite unless u is less
/// than a 16th of the radius.
[[nodiscard]] Ball omitted_terms(const BoundedSeries& series, std::size_t n, const Ball& u);

} // namespace edgeproof::scene

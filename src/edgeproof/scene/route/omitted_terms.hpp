// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::scene {

/// A power series in u whose coefficients are enclosed, with |c_k| <= most/radius^k for all k.
struct BoundedSeries {
    std::function<std::vector<Ball>(std::size_t)> coefficients; ///< so many
    Ball most;
    Ball radius;
};

/// The sum of c_k u^k over all k >= n, so that no difference of nearly equal numbers is taken: as
/// many terms as the bits of u hold, and the others by their bound. Not finite unless u is less
/// than a 16th of the radius.
[[nodiscard]] Ball omitted_terms(const BoundedSeries& series, std::size_t n, const Ball& u);

} // namespace edgeproof::scene

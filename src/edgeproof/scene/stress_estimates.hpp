// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <span>
#include <vector>

namespace edgeproof::scene {

/// A stress at many points of a body, for a picture.
struct PictureStresses {
    std::vector<double> values; ///< in units of the contact modulus
    bool estimates = false;     ///< else within the bounds of compute_binary64()
};

/// Computes sxx, szz, sxz, tau_max or mises at the places x and the depths z > 0. Plane piecewise
/// linear slopes are computed by compute_binary64(). Otherwise the values are estimates
/// (docs/stress.md, "Pictures"): straight lines replace g', or the rate h' of a body of revolution.
/// The greatest value, and values at other places, are compared with proved ones; where one differs
/// by more than 2e-4 of the greatest, compute_binary64() computes all. Throws as that does.
[[nodiscard]] PictureStresses picture_stresses(const Scene& scene, Quantity quantity, Body body,
                                               std::span<const double> x,
                                               std::span<const double> z);

} // namespace edgeproof::scene

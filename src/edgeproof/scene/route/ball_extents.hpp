// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <cstddef>
#include <optional>

namespace edgeproof::scene {

/// Returns the extents to which n terms stay within the scene's tolerance, proved by the signs of
/// the error between the crossings; nothing if the budget does not decide.
[[nodiscard]] std::optional<ExtentValues> enclosed_extent(BallRefinement& balls, const Scene& scene,
                                                          const Plan& plan, contact::Edge edge,
                                                          std::size_t n);

} // namespace edgeproof::scene

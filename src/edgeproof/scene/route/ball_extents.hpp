// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/ball_refinement.hpp"
#include "edgeproof/scene/route/value_route.hpp"

#include <cstddef>
#include <optional>

namespace edgeproof::scene {

/// How far n terms stay within the scene's tolerance, proved by signs of the error between the
/// crossings; nothing where the budget does not decide.
[[nodiscard]] std::optional<ExtentValues> enclosed_extent(BallRefinement& balls, const Scene& scene,
                                                          const Plan& plan, contact::Edge edge,
                                                          std::size_t n);

} // namespace edgeproof::scene

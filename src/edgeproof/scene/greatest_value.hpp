// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/run_scene.hpp"

#include <string>
#include <vector>

namespace edgeproof::scene {

/// The greatest value of a stress in a body, and its place; all three are proved.
struct GreatestValue {
    BoundedValue value;
    BoundedValue x;                 ///< from the origin (length)
    BoundedValue z;                 ///< the depth (length)
    std::vector<std::string> notes; ///< sentences about the place
};

/// Returns the greatest mises, tresca, s1 or tau_max for z >= 0, or the greatest sxx at z = 0, to
/// the digits of the scene. For mises, tresca and s1 the scene must have a Poisson's ratio. Throws
/// InputError for a quantity that has no greatest value, BudgetError where the search does not
/// decide.
[[nodiscard]] GreatestValue greatest_value(const Scene& scene, Quantity quantity, Body body);

} // namespace edgeproof::scene

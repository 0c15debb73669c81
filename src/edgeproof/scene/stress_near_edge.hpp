// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/run_scene.hpp"

#include <array>
#include <cstddef>
#include <vector>

/// The stresses near the edges of a plane contact along a ray into a body (docs/stress.md, "Near an
/// edge"). Angles are in degrees, between the ray and the surface of the contact.
namespace edgeproof::scene {

/// sxx, szz and sxz, in this order.
inline constexpr std::array ray_stresses{Quantity::sxx, Quantity::szz, Quantity::sxz};

/// The coefficients of r^(halves/2) (stress/length^(halves/2)) at the distance r from an edge.
struct RayTerm {
    Edge edge;
    int halves;
    std::array<BoundedValue, 3> values;
};
/// The coefficients of the first `terms` powers at each edge of the scene, proved. Throws
/// InputError for a contact without a closed form, BudgetError if no number of bits gives the
/// digits.
[[nodiscard]] std::vector<RayTerm> ray_terms(const Scene& scene, Body body, const Exact& angle,
                                             std::size_t terms);

} // namespace edgeproof::scene

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/scene/route/scene_values.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::scene {

/// The results of a scene: rows of the contact and the stick zone, then those of the points, the
/// coefficients, the extents and the slip zones, each edge by edge in the order of the request.
struct SceneResult {
    Plan plan;
    std::vector<Row> rows;
    bool in_proportion = true; ///< SceneValues::in_proportion(), for a scene with friction

    /// The row of a quantity of the contact; null if it was not asked for.
    [[nodiscard]] const Row* find(Quantity quantity) const { return RowsAt(rows).find(quantity); }
    /// The value of a quantity of the contact. Throws Error if there is none.
    [[nodiscard]] const BoundedValue& at(Quantity quantity) const {
        return RowsAt(rows).at(quantity);
    }
    /// The rows of each point, and the rows of a group at each edge. They refer to `rows`.
    [[nodiscard]] std::vector<RowsAt> points() const;
    [[nodiscard]] std::vector<RowsAt> at_places(QuantityRow::Place place) const;
    [[nodiscard]] std::vector<RowsAt> at_edges(QuantityGroup group) const;
};

/// The power of u of s_0 in the expansion of q, times 2: -1 under full stick, 1 if q is similar to
/// p.
[[nodiscard]] int shear_half_powers(const Scene& scene);

/// True if the first exit lies beyond the process zone of the scene.
[[nodiscard]] bool covers_zone(const Scene& scene, const BoundedValue& first_exit);

/// Called with the number of values and searches done, and their total.
using RunProgress = std::function<void(std::size_t, std::size_t)>;

/// Computes what a scene asks for. Throws InputError (with the line of the scene) for a load that
/// no contact carries and for a point outside the contact or on a corner; BudgetError if a
/// quadrature does not reach its digits; Interrupted.
[[nodiscard]] SceneResult run_scene(const Scene& scene, const RunProgress& progress = {});

/// The greatest value of a stress in a body, and its place; all three are proved.
struct GreatestValue {
    BoundedValue value;
    BoundedValue x;                 ///< from the origin (length)
    BoundedValue z;                 ///< the depth (length)
    std::vector<std::string> notes; ///< sentences about the place
};

/// The quantity of "mises", "tau_max" or "sxx". Throws InputError for other names.
[[nodiscard]] Quantity greatest_of(std::string_view stress);
/// Returns the greatest mises or tau_max for z >= 0 (of a body of revolution: on its axis, which
/// is proved to be all of the body for a sphere), or the
/// greatest sxx at z = 0, to the digits of the scene. `quantity`: that of greatest_of(). Throws
/// InputError for one that has no greatest value and for mises without a Poisson's ratio,
/// BudgetError where the search does not decide.
[[nodiscard]] GreatestValue greatest_value(const Scene& scene, Quantity quantity, Body body);

/// The stresses near the edges of a plane contact along a ray into a body (docs/stress.md, "Near an
/// edge"): sxx, szz and sxz, in this order. Angles are in degrees, between the ray and the surface
/// of the contact.
inline constexpr std::array ray_stresses{Quantity::sxx, Quantity::szz, Quantity::sxz};

/// Reads an angle. Throws InputError for one that does not lie in 0 to 180.
[[nodiscard]] Exact parse_angle(const std::string& text);

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/value_route.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace edgeproof::scene {

struct PointRow {
    contact::Edge edge = contact::Edge::right;
    formula::Exact u;  ///< unless values.u gives it
    std::string asked; ///< as it was written: "1e-3", "a/2", "x = 0"
    PointValues values;
};

/// The results of a scene in the order of the request, edge by edge.
struct SceneResult {
    Plan plan;
    contact::Work work; ///< the work done
    ContactValues contact;
    std::vector<PointRow> points;
    std::vector<EdgeValues> coefficients;
    std::vector<ExtentValues> extents;
    std::optional<StickValues> stick;
    std::vector<SlipValues> slips;
};

struct RunOptions {
    /// Called with the number of points, coefficients and extents done, and their total.
    std::function<void(std::size_t, std::size_t)> progress = {};
};

/// Carries out the plan of a scene. Throws InputError (with the line of the scene) for a load that
/// no contact carries and for a point outside the contact or on a corner; BudgetError if a
/// quadrature does not reach its digits; Interrupted.
[[nodiscard]] SceneResult run_scene(const Scene& scene, const RunOptions& options = {});

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/value_route.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <utility>
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

/// Returns the scene with a request for these values only. The shear is left out if none of them
/// needs it.
[[nodiscard]] Scene asking(const Scene& scene, const std::vector<AskedValue>& values,
                           const Digits& digits);

/// Single numbers of one scene, by the route that a plan of all of them chooses; a value with
/// `proved` is an enclosure. One object belongs to one thread.
class SceneValues {
public:
    /// Throws as make_plan, make_ball_route and make_real_route do.
    SceneValues(const Scene& scene, const std::vector<AskedValue>& values, const Digits& digits);
    SceneValues(const SceneValues&) = delete; // the route refers to the other members
    SceneValues& operator=(const SceneValues&) = delete;

    /// One of the values, at its place or at another one (to the same tolerance). Throws
    /// DomainError if there is no value: outside the contact, on a corner, no first exit.
    [[nodiscard]] BoundedValue value(const AskedValue& asked);
    /// The coordinate x of an AskedValue at a point. Throws DomainError outside the contact.
    [[nodiscard]] BoundedValue x(const AskedValue& asked);
    [[nodiscard]] const ExtentValues& extent(const AskedValue& asked);

private:
    Scene scene_;
    Plan plan_;
    contact::Work work_;
    std::unique_ptr<ValueRoute> route_;
    std::map<std::pair<contact::Edge, std::size_t>, ExtentValues> extents_;
};

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/value_route.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace edgeproof::scene {

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

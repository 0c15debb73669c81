// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/route/value_route.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace edgeproof::scene {

/// The scene asking for these values and no others, whatever it asks for itself. Shear is left out
/// where none of them needs it.
[[nodiscard]] Scene asking(const Scene& scene, const std::vector<AskedValue>& values,
                           const Digits& digits);

/// Numbers of one scene, one by one, by the route that a plan of all of them chooses: an enclosure
/// where `proved` says so. One object belongs to one thread.
class SceneValues {
public:
    /// Throws as make_plan, make_ball_route and make_real_route do.
    SceneValues(const Scene& scene, const std::vector<AskedValue>& values, const Digits& digits);
    SceneValues(const SceneValues&) = delete; // the route refers to the rest
    SceneValues& operator=(const SceneValues&) = delete;

    /// One of the values, at its place or at another one (to the same tolerance). Throws
    /// DomainError where there is none: outside the contact, on a corner, no first exit.
    [[nodiscard]] BoundedValue value(const AskedValue& asked);
    /// x of an AskedValue at a point. Throws DomainError outside the contact.
    [[nodiscard]] BoundedValue x(const AskedValue& asked);
    /// Of an AskedValue of the group `extent`.
    [[nodiscard]] const ExtentValues& extent(const AskedValue& asked);

private:
    Scene scene_;
    Plan plan_;
    contact::Work work_;
    std::unique_ptr<ValueRoute> route_;
    std::map<std::pair<contact::Edge, std::size_t>, ExtentValues> extents_;
};

} // namespace edgeproof::scene

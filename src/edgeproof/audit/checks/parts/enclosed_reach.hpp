// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"

#include <optional>
#include <string>

namespace edgeproof::audit {

/// The approximation, the edge, the tolerance and the range of a reach.
struct ReachQuestion {
    contact::Edge edge = contact::Edge::right;
    std::size_t terms = 1;
    formula::Exact tolerance;
    contact::ExtentRange range;
};

/// The proved extents in which n terms are within a tolerance in a scene. If no number of bits up
/// to 8 times that of `digits` decides, `extents` is empty and `problem` gives the reason.
struct EnclosedReach {
    std::optional<contact::EnclosedExtents> extents;
    long bits = 0;
    std::string problem;
};
[[nodiscard]] EnclosedReach enclosed_reach(const SceneSpec& scene, const ReachQuestion& question,
                                           unsigned digits);

} // namespace edgeproof::audit

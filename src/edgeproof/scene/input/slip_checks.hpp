// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

namespace edgeproof::scene {

/// Refuses a scene with |Q| >= f P, with the line of the friction; `force` is P.
[[noreturn]] void refuse_sliding(const Scene& scene, const Real& force);
/// Refuses a scene whose stick zone would extend beyond an edge (or reaches it: `reached`), with
/// the line of the bulk tension: sigma_0 has to lie between the two limits.
[[noreturn]] void refuse_tension(const Scene& scene, contact::Edge edge, bool reached,
                                 const Real& least, const Real& most);

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

namespace edgeproof::scene {

/// What partial slip refuses, told with the line of the friction or of the bulk tension.
/// |Q| >= f P: `force` is P.
[[noreturn]] void refuse_sliding(const Scene& scene, const Real& force);
/// The stick zone would reach beyond an edge (or that edge: `reached`): sigma_0 has to lie between
/// the two.
[[noreturn]] void refuse_tension(const Scene& scene, contact::Edge edge, bool reached,
                                 const Real& least, const Real& most);

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

namespace edgeproof::validation {

/// The same scene with a tilt of zero. Throws InputError where the profile has no tilt.
[[nodiscard]] scene::Scene upright(const scene::Scene& scene);

/// The value as Edgeproof prints it: by the route that a plan of the scene chooses, an enclosure
/// where `proved` says so; a residual and a tilt difference, which are made of other values, with
/// as many digits more as cancel. Throws as scene::SceneValues does.
[[nodiscard]] scene::BoundedValue enclosed_value(const scene::Scene& scene,
                                                 const scene::AskedValue& asked, unsigned digits);

} // namespace edgeproof::validation

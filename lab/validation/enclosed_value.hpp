// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/bounded_value.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

namespace edgeproof::validation {

/// Returns the same scene with zero tilt. Throws InputError if the profile has no tilt.
[[nodiscard]] scene::Scene upright(const scene::Scene& scene);

/// Returns the value as Edgeproof prints it: by the route that a plan of the scene chooses; an
/// enclosure if `proved`. A residual and a tilt difference, which are computed from other values,
/// use as many additional digits as cancel. Throws as scene::SceneValues does.
[[nodiscard]] scene::BoundedValue enclosed_value(const scene::Scene& scene,
                                                 const scene::AskedValue& asked, unsigned digits);

} // namespace edgeproof::validation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <vector>

namespace edgeproof::certificate {

/// The values of a scene as theorems, a file for the load, and at each edge one for the
/// coefficients, one for the pressures and one for each extent: that the value printed is the exact
/// one, rounded. What cannot be stated has no theorem, and says why. `verdict` of each is "value".
[[nodiscard]] std::vector<Certificate> certify_scene(const scene::Scene& scene,
                                                     const scene::SceneResult& result);

} // namespace edgeproof::certificate

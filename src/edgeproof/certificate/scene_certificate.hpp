// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/scene/run_scene.hpp"

#include <vector>

namespace edgeproof::certificate {

/// States the values of a scene as theorems: the printed value is the exact value, rounded. There
/// is one file for the load, and at each edge one for the coefficients, one for the pressures and
/// one for each extent. A value that cannot be stated has no theorem, and its certificate gives the
/// reason. The `verdict` of each certificate is "value".
/// @param scene the scene, with all quantities that it asks for
/// @param result the values of those that can be stated
[[nodiscard]] std::vector<Certificate> certify_scene(const scene::Scene& scene,
                                                     const scene::SceneResult& result);

} // namespace edgeproof::certificate

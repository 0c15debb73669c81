// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/scene/input/quantity.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

enum class Panels { all, pressure, errors };

/// Pictures of a scene: the exact pressure (and q, if the scene has shear) along the contact with
/// the sums of the first terms, and for each requested edge the relative errors of these sums on
/// logarithmic axes, with the tolerance and the first exits. The terms are 1, 2, 3 and the
/// tolerance is 1 % unless the scene has its own. `progress` is called with the number of values
/// done, and their total. Throws InputError as run_scene does.
[[nodiscard]] std::vector<Plot>
scene_picture(scene::Scene scene, const std::function<void(std::size_t, std::size_t)>& progress,
              Panels panels = Panels::all);

/// The contours of a stress of a body: sxx, szz, sxz, tau_max or mises, below the contact and
/// around it, as deep as the contact is long. Throws InputError for other names, and as
/// compute_binary64 does.
[[nodiscard]] Plot stress_picture(const scene::Scene& scene, std::string_view stress,
                                  scene::Body body);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/scene/input/quantity.hpp"

namespace edgeproof::report {

/// The contours of a stress of a body: sxx, szz, sxz, tau_max or mises, below the contact and
/// around it, as deep as the contact is long. Throws InputError for other quantities, and as
/// compute_binary64 does.
[[nodiscard]] ScenePicture stress_picture(const scene::Scene& scene, scene::Quantity quantity,
                                          scene::Body body);

} // namespace edgeproof::report

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

/// A stress of the quantities of the group `stress` along the line between two points of a body,
/// from values in balls. Throws InputError if both are one point, if the quantity needs a Poisson's
/// ratio that the scene does not have, and as scene::SceneValues does.
[[nodiscard]] ScenePicture stress_along(const scene::Scene& scene, scene::Quantity quantity,
                                        const scene::BodyPoint& from, const scene::BodyPoint& to);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"

/// Whether a scene is one that a listed theorem is about.
namespace edgeproof::certificate::listed_scenes {

[[nodiscard]] bool tilted_wedge(const audit::SceneSpec& scene);
[[nodiscard]] bool tilted_to_the_left(const audit::SceneSpec& scene);
[[nodiscard]] bool beyond_the_flat(const audit::SceneSpec& scene);
[[nodiscard]] bool within_the_flat(const audit::SceneSpec& scene);
[[nodiscard]] bool force_alone(const audit::SceneSpec& scene);
[[nodiscard]] bool tension_alone(const audit::SceneSpec& scene);
[[nodiscard]] bool tilted_punch(const audit::SceneSpec& scene);
[[nodiscard]] bool power_law(const audit::SceneSpec& scene);
[[nodiscard]] bool symmetric(const audit::SceneSpec& scene);
[[nodiscard]] bool power_law_or_rounded(const audit::SceneSpec& scene);
[[nodiscard]] bool non_symmetric(const audit::SceneSpec& scene);
[[nodiscard]] bool wedge_or_power_law_under_force(const audit::SceneSpec& scene);
[[nodiscard]] bool wedge_under_force(const audit::SceneSpec& scene);
[[nodiscard]] bool under_a_force(const audit::SceneSpec& scene);
[[nodiscard]] bool parabola_in_plane_strain(const audit::SceneSpec& scene);
[[nodiscard]] bool any_contact(const audit::SceneSpec& scene);

} // namespace edgeproof::certificate::listed_scenes

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/scene_options.hpp"

#include <CLI/CLI.hpp>

#include <string>

/// `expand` with --angle: the stresses near an edge along a ray into a body.
namespace edgeproof::cli {

struct RayOptions : SceneOptions {
    std::string angle; ///< empty: the pressure, not the stresses
    std::string body;  ///< empty: A
};
/// Adds --angle and --body.
void add_ray_options(CLI::App& sub, RayOptions& options);
/// True if the stresses are asked for. Refuses --body without --angle, and the options that have no
/// effect with it.
[[nodiscard]] bool along_ray(const RayOptions& options);

/// The coefficients of the stresses: a row for each power of the distance.
int expand_stresses(const RayOptions& options);

} // namespace edgeproof::cli

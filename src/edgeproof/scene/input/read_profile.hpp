// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

namespace edgeproof::scene {

/// Fills in the profile or the punch of a scene from [profile]; with `tilt_unknown`, alpha must be
/// absent.
void read_profile(const io::TomlSection& section, bool tilt_unknown, Scene& scene);

} // namespace edgeproof::scene

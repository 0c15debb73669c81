// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string_view>

namespace edgeproof::scene {

/// Fills in what is asked of a scene, whose contact is known, from [ask]. `profile`: whose keys are
/// names that places may use, beside a and b.
void read_ask(const io::TomlSection& section, const io::TomlSection& profile, Scene& scene);

/// What a scene that does not name its quantities asks for: whatever it gives the means for.
void default_quantities(Ask& ask, bool shear, bool friction);

/// The sign of the value of a key, or of what follows from it.
[[nodiscard]] int sign_of(const io::TomlSection& section, std::string_view key,
                          const formula::Exact& value);

} // namespace edgeproof::scene

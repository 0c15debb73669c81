// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string_view>

namespace edgeproof::scene {

/// Fills in the request of a scene, whose contact is known, from [ask]. Places may use the keys of
/// `profile` as names, in addition to a and b.
void read_ask(const io::TomlSection& section, const io::TomlSection& profile, Scene& scene);

/// Sets the quantities of a scene that does not name them: all for which it gives the data.
void default_quantities(Ask& ask, bool shear, bool friction);

/// Returns the sign of the value of a key, or of a value derived from it.
[[nodiscard]] int sign_of(const io::TomlSection& section, std::string_view key,
                          const formula::Exact& value);

} // namespace edgeproof::scene

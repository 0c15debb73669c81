// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string_view>

namespace edgeproof::scene {

/// Fills in the profile or the punch of a scene from [profile]; with `tilt_unknown`, alpha must be
/// absent.
void read_profile(const io::TomlSection& section, bool tilt_unknown, Scene& scene);

/// Throws InputError, with the line of the key, unless every number of the expression and its value
/// (where it has no names) are 0 or between 1e-10000 and 1e10000 in size: the range of what defines
/// a contact. Beyond it, searches and integrals take endless work. `text`: as it is written.
void check_size(const io::TomlSection& section, std::string_view key, const formula::Expr& e,
                std::string_view text);

/// The constant of a key of [profile], [load] or [shear], of a size within that range.
[[nodiscard]] formula::Exact contact_constant(const io::TomlSection& section, std::string_view key);

} // namespace edgeproof::scene

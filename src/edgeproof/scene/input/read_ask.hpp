// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <string_view>
#include <vector>

namespace edgeproof::scene {

/// Fills in the request of a scene, whose contact is known, from [ask]. Places may use the keys of
/// `profile` as names, in addition to a and b.
void read_ask(const io::TomlSection& section, const io::TomlSection& profile, Scene& scene);

/// Sets the quantities of a scene that does not name them: all for which it gives the data.
void default_quantities(Ask& ask, bool shear, bool friction);

/// Returns the sign of the value of a key, or of a value derived from it.
[[nodiscard]] int sign_of(const io::TomlSection& section, std::string_view key,
                          const formula::Exact& value);

/// The names that places of a scene may use in addition to a and b: the parameters of its profile,
/// a and b themselves if they are given, and b as a if the two are equal.
[[nodiscard]] Place::Names names_of(const io::TomlSection& profile, const Scene& scene);

/// Reads u and x of [ask], if present: lists or ranges. Throws InputError with the line of a
/// malformed value.
[[nodiscard]] std::vector<AskedPoint> read_places(const io::TomlSection& ask,
                                                  const Place::Names& names);

} // namespace edgeproof::scene

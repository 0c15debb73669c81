// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <vector>

namespace edgeproof::scene {

/// The names that places of a scene may use in addition to a and b: the parameters of its profile,
/// a and b themselves if they are given, and b as a if the two are equal.
[[nodiscard]] Place::Names names_of(const io::TomlSection& profile, const Scene& scene);

/// Reads u and x of [ask], if present: lists or ranges. Throws InputError with the line of a
/// malformed value.
[[nodiscard]] std::vector<AskedPoint> read_places(const io::TomlSection& ask,
                                                  const Place::Names& names);

} // namespace edgeproof::scene

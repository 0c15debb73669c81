// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <vector>

namespace edgeproof::scene {

/// The names that places of a scene may use beside a and b: the parameters of its profile, a and b
/// themselves as far as they are given, and b as a where they are the same.
[[nodiscard]] Place::Names names_of(const io::TomlSection& profile, const Scene& scene);

/// u and x of [ask], as far as they are there: lists, or ranges. Throws InputError with the line of
/// what is none.
[[nodiscard]] std::vector<AskedPoint> read_places(const io::TomlSection& ask,
                                                  const Place::Names& names);

} // namespace edgeproof::scene

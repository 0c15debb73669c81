// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <string>
#include <variant>
#include <vector>

namespace edgeproof::scene {

/// One key of a section with its value: a number or a word as text, a yes or no, a list of texts.
struct SceneEntry {
    std::string key;
    std::variant<std::string, bool, std::vector<std::string>> value;
};

/// A scene that no file holds: the keys of a scene file (docs/file-formats.md), section by section.
/// A section without entries is left out.
struct SceneEntries {
    std::string title;
    std::vector<SceneEntry> profile;
    std::vector<SceneEntry> load;
    std::vector<SceneEntry> shear;
    std::vector<SceneEntry> ask = {};
};

/// The scene file that says the same. Throws InputError for a text with a control character.
[[nodiscard]] std::string scene_text(const SceneEntries& entries);

/// The scene, checked as if it was read from a file. Throws InputError, without file and line, for
/// whatever read_scene refuses.
[[nodiscard]] Scene make_scene(const SceneEntries& entries);

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <string>
#include <variant>
#include <vector>

namespace edgeproof::scene {

/// One key of a section with its value: a number or a word as text, a boolean, or a list of texts.
struct SceneEntry {
    std::string key;
    std::variant<std::string, bool, std::vector<std::string>> value;
};

/// A scene that is not read from a file: the keys of a scene file (docs/file-formats.md), section
/// by section. A section without entries is left out.
struct SceneEntries {
    std::string title;
    std::vector<SceneEntry> profile;
    std::vector<SceneEntry> load;
    std::vector<SceneEntry> shear;
    std::vector<SceneEntry> ask = {};
};

/// Returns the text of the equivalent scene file. Throws InputError for a text with a control
/// character.
[[nodiscard]] std::string scene_text(const SceneEntries& entries);

/// Returns the scene, checked as if it was read from a file. Throws InputError, without file and
/// line, in the same cases as read_scene.
[[nodiscard]] Scene make_scene(const SceneEntries& entries);

} // namespace edgeproof::scene

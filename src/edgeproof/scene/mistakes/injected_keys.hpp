// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Mistakes of users in the text of a scene, to test the diagnoses of `edgeproof compare` and
/// `edgeproof check`. They are written without the catalogue (scene_mistakes.hpp), which is under
/// test.
namespace edgeproof::scene {

/// The keys of a scene file, such as "profile.R" -> "2".
using SceneKeys = std::map<std::string, std::string>;
/// Reads "profile.R=2 load.P=3".
[[nodiscard]] SceneKeys keys_of(const std::string& text);
[[nodiscard]] Scene scene_of(const SceneKeys& keys);

struct InjectedKeys {
    std::string name; ///< the name that a diagnosis should give
    bool of_shear = false;
    /// Returns the changed keys; nothing if the mistake is not possible in the contact.
    std::function<std::optional<SceneKeys>(const SceneKeys&)> change;
};
[[nodiscard]] const std::vector<InjectedKeys>& injected_keys();

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace edgeproof::cli {

/// A scene given by its quantities on the command line, in place of a file: --hertz --R 100 --P 120
/// ...
class StatedScene {
public:
    void add_options(CLI::App& sub);
    /// True if an option is given whose key is outside [ask] in a file.
    [[nodiscard]] bool given() const;
    /// Returns the entries of [ask], which may accompany a file as well: points and the process
    /// zone.
    [[nodiscard]] scene::SceneEntries::Section asked() const;
    /// Returns the content of the scene's file. Throws InputError for none or several profiles, and
    /// for a parameter that the profile does not have.
    [[nodiscard]] scene::SceneEntries entries() const;

private:
    std::map<std::string, bool> profiles_;          ///< for each kind
    std::map<std::string, std::string> quantities_; ///< for each key of a scene's file
};

/// Returns the parts of a list such as "1e-3,a/2".
[[nodiscard]] std::vector<std::string> parts_of(const std::string& text);

} // namespace edgeproof::cli

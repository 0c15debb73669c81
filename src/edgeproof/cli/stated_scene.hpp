// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_entries.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace edgeproof::cli {

/// A scene by its quantities on the command line, in place of a file: --hertz --R 100 --P 120 ...
class StatedScene {
public:
    void add_options(CLI::App& sub);
    /// Any of them is given that a file would have outside [ask].
    [[nodiscard]] bool given() const;
    /// What is asked, of a scene by its file as well: its points, its process zone.
    [[nodiscard]] std::vector<scene::SceneEntry> asked() const;
    /// What the scene's file would hold. Throws InputError for none or several profiles, and for a
    /// parameter that the profile does not have.
    [[nodiscard]] scene::SceneEntries entries() const;

private:
    std::map<std::string, bool> profiles_;          ///< by kind
    std::map<std::string, std::string> quantities_; ///< by key of a scene's file
};

/// "1e-3,a/2": its parts.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& text);

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

/// Scenes for the tests, as text.
namespace edgeproof::scenes {

inline Scene parsed(const std::string& text) { return parse_scene(text, "scene.toml"); }

/// Returns the scene with g' = x; for E* = 1 the pressure is sqrt(a^2 - x^2)/2.
inline std::string hertz(const std::string& a, const std::string& ask) {
    return "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\na = \"" + a +
           "\"\ncontact_modulus = \"1\"\n[ask]\n" + ask;
}

inline std::string tilted_wedge(const std::string& more, const std::string& ask) {
    return "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.02\"\n[load]\na = "
           "\"2\"\n"
           "contact_modulus = \"1\"\n" +
           more + "[ask]\n" + ask;
}

/// Returns the scenes that come with the program.
inline std::vector<std::filesystem::path> examples() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(test::source_dir() / "examples" / "scenes")) {
        if (entry.path().extension() == ".toml") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace edgeproof::scenes

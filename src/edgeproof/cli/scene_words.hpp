// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

/// A scene as words: its file, and key=value for the keys of a scene's file.
namespace edgeproof::cli {

struct GivenScene {
    std::string file;                   ///< empty: the words are the whole scene
    std::vector<io::TomlTable> instead; ///< the keys of the words, by sections
};
/// Reads the words. A list is separated by commas, FROM..TO is a range. Throws InputError for two
/// files and for unknown keys. `folder`: the shipped files that a bare name may mean.
[[nodiscard]] GivenScene given_scene(const std::vector<std::string>& words,
                                     std::string_view folder);
/// The value of a key among the words; empty if it is not given.
[[nodiscard]] std::string value_of(const std::vector<std::string>& words, std::string_view key);

/// Returns the command line with words in place of options for keys of a scene, if its command
/// takes a scene: `--R 100` becomes R=100, `--u 1e-3 0.1` u=1e-3,0.1, and `--hertz` kind=hertz.
[[nodiscard]] std::vector<std::string> with_words(const CLI::App& app,
                                                  const std::vector<std::string>& arguments);

/// True if a command takes the words of a scene.
[[nodiscard]] bool takes_words(const CLI::App& sub);
/// Returns "kind=", "R=", ...
[[nodiscard]] std::vector<std::string> keys_of_scene();

} // namespace edgeproof::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/scene/input/quantity.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A scene and its questions as words: a file, and key=value for the keys of a scene's file.
namespace edgeproof::scene {

struct GivenScene {
    std::string file;                   ///< empty: the words are the whole scene
    std::vector<io::TomlTable> instead; ///< the keys of the words, by sections
};
/// Reads the words. A list is separated by commas, FROM..TO is a range. Throws InputError for two
/// files and for unknown keys.
[[nodiscard]] GivenScene given_scene(const std::vector<std::string>& words);

/// The value of a key among the words; empty if it is not given.
[[nodiscard]] std::string value_of(const std::vector<std::string>& words, std::string_view key);
/// The length of the key of KEY=VALUE; npos for the name of a file.
[[nodiscard]] std::size_t key_length(const std::string& word);

/// A key of a scene that has one value, or a list.
struct Key {
    std::string_view name;
    std::string_view section;
    bool list;
    bool word; ///< no number
};
/// The keys of all sections, in the order of the columns of tables.
[[nodiscard]] const std::vector<Key>& keys_of_scene();
/// Null for other names.
[[nodiscard]] const Key* key_named(std::string_view name);
[[nodiscard]] std::vector<std::string_view> keys_of_section(std::string_view section);

/// Reads a question: the symbol of a quantity (p, c_1, extent_2) and the keys of its place: u or x,
/// at (X,Z of a body), edge (right), body (A), tolerance (1%), reference (0). Throws InputError for
/// other names and for a place that is missing. `names`: of the scene, for the places.
[[nodiscard]] AskedValue asked_value(std::string_view quantity,
                                     const std::map<std::string, std::string>& where,
                                     const Place::Names& names);

/// Refuses a number of 1 or more without a percent sign, which is a slip for a percentage.
void refuse_whole_tolerance(const std::string& option, const std::string& text);
/// Returns the parts of a list such as "1e-3,a/2".
[[nodiscard]] std::vector<std::string> parts_of(const std::string& text);

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::conformance {

/// One entry of a scene file's [profile], [load] or [shear], as text: exact, and the same in a
/// recipe, in a question and in an answer. A list (knots, slopes) is joined by "; ".
struct Parameter {
    std::string key;
    std::string text;
    std::size_t line = 0; ///< of the file that it was read from
};

/// The keys that a parameter may have, in the order of columns.
[[nodiscard]] const std::vector<std::string_view>& parameter_keys();
/// "profile", "load" or "shear". The key must be one of parameter_keys().
[[nodiscard]] std::string_view section_of(std::string_view key);
/// knots and slopes.
[[nodiscard]] bool is_list_key(std::string_view key);
/// kind, slopes, symmetric and path: not a number, and the same for every program.
[[nodiscard]] bool is_word_key(std::string_view key);
[[nodiscard]] std::vector<std::string> list_items(std::string_view text);

/// A profile under a load: what questions are asked of. Two contacts of the same parameters are the
/// same contact.
struct AskedContact {
    std::vector<Parameter> parameters; ///< in the order of parameter_keys()
    scene::Scene scene;                ///< `ask` empty
};

/// Reads the parameters as a scene file would be read; what is wrong with one is told with its own
/// line of `file`, else with `line`. Throws InputError.
[[nodiscard]] AskedContact make_asked_contact(std::vector<Parameter> parameters,
                                              const std::string& file, std::size_t line);

/// The parameters with every number replaced by the binary64 nearest to it, written out exactly.
[[nodiscard]] std::vector<Parameter> rounded_to_binary64(std::vector<Parameter> parameters);
/// The number replaced by the binary64 nearest to it.
[[nodiscard]] formula::Exact rounded_to_binary64(const formula::Exact& x);

} // namespace edgeproof::conformance

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::conformance {

/// One entry of [profile], [load] or [shear] of a scene file, as text: exact, and the same in a
/// recipe, in a question and in an answer. The items of a list (knots, slopes) are joined by "; ".
struct Parameter {
    std::string key;
    std::string text;
    std::size_t line = 0; ///< in the file that it was read from
};

/// The allowed keys of parameters, in the order of columns.
[[nodiscard]] const std::vector<std::string_view>& parameter_keys();
/// Returns "profile", "load" or "shear". The key must be one of parameter_keys().
[[nodiscard]] std::string_view section_of(std::string_view key);
/// True for knots and slopes.
[[nodiscard]] bool is_list_key(std::string_view key);
/// True for kind, slopes, symmetric and path: not a number, and the same for every program.
[[nodiscard]] bool is_word_key(std::string_view key);
[[nodiscard]] std::vector<std::string> list_items(std::string_view text);

/// A profile under a load, the subject of questions. Contacts with the same parameters are equal.
struct AskedContact {
    std::vector<Parameter> parameters; ///< in the order of parameter_keys()
    scene::Scene scene;                ///< `ask` empty
};

/// Reads the parameters as in a scene file. Throws InputError with the parameter's own line of
/// `file`, or else with `line`.
[[nodiscard]] AskedContact make_asked_contact(std::vector<Parameter> parameters,
                                              const std::string& file, std::size_t line);

/// Returns the parameters with every number replaced by the exact text of the nearest binary64.
[[nodiscard]] std::vector<Parameter> rounded_to_binary64(std::vector<Parameter> parameters);
[[nodiscard]] formula::Exact rounded_to_binary64(const formula::Exact& x);

} // namespace edgeproof::conformance

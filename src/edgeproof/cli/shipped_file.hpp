// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace edgeproof::cli {

/// The folders of the files that come with the program.
inline constexpr std::string_view shipped_ledgers = "verify";
inline constexpr std::string_view shipped_recipes = "reference";
inline constexpr std::string_view shipped_scenes = "examples/scenes";
inline constexpr std::string_view shipped_designs = "examples/design";

/// Returns the file for a command. A bare name ("moore-hills") that is not a file in the current
/// folder means a file that came with the program, if there is one; anything else is returned
/// unchanged.
[[nodiscard]] std::string file_or_shipped(const std::string& given, std::string_view folder);

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace edgeproof::cli {

/// What comes with the program, by the folder that it is kept in.
inline constexpr std::string_view shipped_ledgers = "verify";
inline constexpr std::string_view shipped_recipes = "reference";
inline constexpr std::string_view shipped_scenes = "examples/scenes";
inline constexpr std::string_view shipped_designs = "examples/design";

/// The file that a command is given. A bare name ("moore-hills") that is no file here is that of a
/// file which came with the program, if there is one; anything else is as it was given.
[[nodiscard]] std::string file_or_shipped(const std::string& given, std::string_view folder);

} // namespace edgeproof::cli

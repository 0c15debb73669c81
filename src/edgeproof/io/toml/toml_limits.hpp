// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace edgeproof::io {

inline constexpr std::size_t most_toml_bytes = 10'000'000;
/// The most names that one key or header may join by dots, and the most open brackets. toml++ and
/// its destructors recurse once per level.
inline constexpr std::size_t most_toml_nesting = 32;

/// Throws InputError with the line for a text of more than most_toml_bytes, or one nested deeper
/// than most_toml_nesting. Checks only brackets and dots outside strings and comments; other errors
/// are left to the parser.
void check_toml_limits(std::string_view text, const std::string& file);

} // namespace edgeproof::io

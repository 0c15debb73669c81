// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace edgeproof::io {

inline constexpr std::size_t most_toml_bytes = 10'000'000;
/// Names that one key or header may join by dots, and brackets that may be open at once. toml++ and
/// its destructors recurse once a level.
inline constexpr std::size_t most_toml_nesting = 32;

/// Throws InputError with the line for a text of more than most_toml_bytes, or one that is nested
/// deeper than most_toml_nesting. Looks at brackets and dots outside strings and comments alone:
/// whatever else is wrong is left to the parser.
void check_toml_limits(std::string_view text, const std::string& file);

} // namespace edgeproof::io

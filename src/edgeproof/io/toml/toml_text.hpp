// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string_view>

/// Functions for the text of a TOML file, in addition to the result of toml++.
namespace edgeproof::io {

[[nodiscard]] std::size_t significant_digits(std::string_view number);
[[nodiscard]] bool is_number_character(char c);
/// Returns the byte at which a column (from 1) begins: toml++ counts characters, not bytes.
[[nodiscard]] std::size_t byte_of_column(std::string_view line, std::size_t column);
/// True if the text has control characters other than tab and newline, which would control a
/// terminal.
[[nodiscard]] bool has_control(std::string_view text);

inline constexpr std::size_t most_toml_bytes = 10'000'000;
/// The most names that one key or header may join by dots: the destructors of toml++ recurse once
/// per level. (It limits brackets by itself.)
inline constexpr std::size_t most_toml_nesting = 32;

/// Throws InputError with the line for a text of more than most_toml_bytes, or with a key or header
/// of more than most_toml_nesting names. Other errors are left to the parser.
void check_toml_limits(std::string_view text, const std::string& file);

} // namespace edgeproof::io

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The text of a TOML file, beside what toml++ made of it.
namespace edgeproof::io {

[[nodiscard]] std::vector<std::string> split_lines(std::string_view text);
[[nodiscard]] std::size_t significant_digits(std::string_view number);
[[nodiscard]] bool is_number_character(char c);
/// Where the character at a column (from 1) begins: toml++ counts characters, not bytes.
[[nodiscard]] std::size_t byte_of_column(std::string_view line, std::size_t column);
/// Control characters other than tab and newline: they steer the terminal that shows them.
[[nodiscard]] bool has_control(std::string_view text);

} // namespace edgeproof::io

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Functions for the text of a TOML file, in addition to the result of toml++.
namespace edgeproof::io {

[[nodiscard]] std::vector<std::string> split_lines(std::string_view text);
[[nodiscard]] std::size_t significant_digits(std::string_view number);
[[nodiscard]] bool is_number_character(char c);
/// Returns the byte at which a column (from 1) begins: toml++ counts characters, not bytes.
[[nodiscard]] std::size_t byte_of_column(std::string_view line, std::size_t column);
/// True if the text has control characters other than tab and newline, which would control a
/// terminal.
[[nodiscard]] bool has_control(std::string_view text);

} // namespace edgeproof::io

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// Splits TeX into tokens: commands with their backslash, whole numbers and decimals, single
/// characters (a non-ASCII letter is one token). Runs of white space become one " ".
[[nodiscard]] std::vector<std::string> tex_tokens(std::string_view tex);

/// The symbol of the command (given without its backslash): an operator, a letter, or a width of
/// space ("" for zero width); nothing for other commands.
[[nodiscard]] std::optional<std::string_view> tex_operator(std::string_view command);
[[nodiscard]] std::optional<std::string_view> tex_letter(std::string_view command);
[[nodiscard]] std::optional<std::string_view> tex_space(std::string_view command);

} // namespace edgeproof::report

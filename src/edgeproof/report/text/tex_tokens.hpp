// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::report {

/// TeX cut into tokens: commands with their backslash, whole numbers and decimals, single
/// characters (a letter beyond ASCII whole). Runs of white space are one " ".
[[nodiscard]] std::vector<std::string> tex_tokens(std::string_view tex);

/// What the command (without its backslash) stands for: an operator, a letter, a width of space (of
/// none: ""), or nothing of the kind.
[[nodiscard]] std::optional<std::string_view> tex_operator(std::string_view command);
[[nodiscard]] std::optional<std::string_view> tex_letter(std::string_view command);
[[nodiscard]] std::optional<std::string_view> tex_space(std::string_view command);

} // namespace edgeproof::report

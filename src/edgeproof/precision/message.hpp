// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Text for messages.
namespace edgeproof {

/// Returns one line without characters that control a terminal: line breaks and tabs become spaces;
/// other control characters (C0, DEL, C1), characters that change the direction of writing, U+FFFE,
/// U+FFFF, and bytes that are not UTF-8 become escapes such as `\x1b`.
[[nodiscard]] std::string printable(std::string_view text);
/// The same for a text of many lines and columns: line breaks and tabs are kept.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// The text with ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Returns a text of more than `most` bytes without its middle; no character is split.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/// Returns the candidate of which `name` is most likely a misspelling: a different case, or a few
/// letters that are missing, additional, changed or swapped (Damerau-Levenshtein distance of at
/// most a third of the longer name). Empty if there is no such candidate.
[[nodiscard]] std::string_view near_name(std::string_view name,
                                         std::span<const std::string_view> candidates);

/// Returns "write one of a, b, c", preceded by "did you mean b? " if a candidate is near.
[[nodiscard]] std::string one_of(std::string_view name,
                                 std::span<const std::string_view> candidates);

} // namespace edgeproof

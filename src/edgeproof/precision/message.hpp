// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Text that is fit for a message.
namespace edgeproof {

/// One line without a character that steers a terminal: line breaks and tabs become spaces, other
/// control characters (C0, DEL, C1), signs that turn the direction of writing, U+FFFE, U+FFFF, and
/// bytes that are no UTF-8 become escapes such as `\x1b`.
[[nodiscard]] std::string printable(std::string_view text);
/// The same of a text of many lines and columns: line breaks and tabs stay.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// A text of more than `most` bytes with its middle left out; whole characters.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/// The candidate that `name` is most likely a slip of the pen for: a wrong case, or few letters
/// missing, too many, changed or swapped (Damerau-Levenshtein distance of at most a third of the
/// longer one's length). Empty where none is near.
[[nodiscard]] std::string_view near_name(std::string_view name,
                                         std::span<const std::string_view> candidates);

/// "write one of a, b, c", headed by "did you mean b? " where one is near.
[[nodiscard]] std::string one_of(std::string_view name,
                                 std::span<const std::string_view> candidates);

} // namespace edgeproof

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

inline constexpr std::size_t most_text_bytes = 1'000'000'000;

/// The name of the file in errors: "stdin" for "-", which is standard input.
[[nodiscard]] std::string input_name(const std::filesystem::path& file);

/// Returns the text of a file, a pipe without a name or a device, or for "-" of standard input,
/// once. Throws InputError that calls the file `what` ("recipe (TOML)") if it does not exist, is a
/// folder or a named pipe, cannot be read, or holds more than `most` bytes; no more bytes are read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, const std::string& what,
                                    std::size_t most = most_text_bytes);

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text, std::string_view blanks = " \t");
/// The parts between blanks and line ends. (clang 14 does not compile std::views.)
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view text);

/// Returns the whole number that the text is; nothing for another text, or beyond the type.
template <std::integral Whole>
[[nodiscard]] std::optional<Whole> read_whole(std::string_view text) {
    Whole value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

/// True if the text begins with a byte order mark of UTF-16, of either order.
[[nodiscard]] bool is_utf16(std::string_view text);
/// Returns a text in UTF-16 with a byte order mark in UTF-8, without the mark; other texts as they
/// are. Throws InputError, with the file, if the text ends within a character, or contains half of
/// a pair.
[[nodiscard]] std::string utf8_text(std::string text, const std::string& file);
[[nodiscard]] bool is_utf8(std::string_view text);
/// Converts a text in Latin-1 (Windows-1252 has the same letters) to UTF-8.
[[nodiscard]] std::string utf8_from_latin1(std::string_view text);

/// Returns the 64-bit FNV-1a hash (Fowler, Noll, Vo; draft-eastlake-fnv). It detects an edited
/// table, but not a forged one. With the hash of a text before, returns the hash of both texts
/// together.
[[nodiscard]] std::uint64_t fnv1a(std::string_view text,
                                  std::uint64_t before = 0xcbf29ce484222325U);

/// Returns SHA-256 (FIPS 180-4) in lower-case hexadecimal, as `sha256sum` prints it.
[[nodiscard]] std::string sha256(std::string_view text);

/// Only for a catch block. An error of this program that names no file becomes an InputError at
/// FILE:LINE; if it has no advice, `instead` is added (or advice that suits its kind). Any other
/// exception, including an interruption, is rethrown unchanged.
[[noreturn]] void rethrow_at(const std::string& file, std::size_t line,
                             std::string_view instead = {});

/// Returns f(); its errors get the file and the line.
template <class F>
decltype(auto) at_place(const std::string& file, std::size_t line, const F& f,
                        std::string_view instead = {}) {
    try {
        return f();
    } catch (...) {
        rethrow_at(file, line, instead);
    }
}

} // namespace edgeproof::io

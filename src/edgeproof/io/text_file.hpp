// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace edgeproof::io {

inline constexpr std::size_t most_text_bytes = 1'000'000'000;

/// The name of the file in errors: "stdin" for "-", which is standard input.
[[nodiscard]] std::string input_name(const std::filesystem::path& file);

/// Reads a file, a pipe without a name or a device, or for "-" standard input, once, as needed.
class TextReader {
public:
    /// Throws InputError that calls the file `what` ("recipe (TOML)") if it does not exist, is a
    /// folder or a named pipe, or cannot be read.
    TextReader(const std::filesystem::path& file, const std::string& what,
               std::size_t most = most_text_bytes);
    /// Appends at most `bytes` more bytes to the text; returns false at the end. Throws InputError
    /// if the file cannot be read or holds more than `most` bytes.
    [[nodiscard]] bool read(std::string& text, std::size_t bytes);
    [[nodiscard]] std::size_t bytes() const { return done_; } ///< bytes read so far

private:
    [[noreturn]] void refuse(const std::string& problem, const std::string& instead) const;

    std::string name_;
    std::string give_;
    std::ifstream opened_;
    std::istream* in_;
    std::size_t most_;
    std::size_t done_ = 0;
};

/// Returns the text of a file, a pipe without a name or a device, or for "-" of standard input,
/// once. Throws InputError that calls the file `what` ("recipe (TOML)") if it does not exist, is a
/// folder or a named pipe, cannot be read, or holds more than `most` bytes; no more bytes are read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, const std::string& what,
                                    std::size_t most = most_text_bytes);

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

} // namespace edgeproof::io

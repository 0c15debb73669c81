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

/// What errors call the file: "stdin" for "-", which is standard input.
[[nodiscard]] std::string input_name(const std::filesystem::path& file);

/// A file, a pipe or a device, or for "-" standard input, once, read as it is needed.
class TextReader {
public:
    /// Throws InputError that calls it `what` ("recipe (TOML)") where there is none, it is a folder
    /// or it cannot be read.
    TextReader(const std::filesystem::path& file, const std::string& what,
               std::size_t most = most_text_bytes);
    /// Adds at most `bytes` more to the text; false where there are none. Throws InputError where
    /// it cannot be read or holds more than `most`.
    [[nodiscard]] bool read(std::string& text, std::size_t bytes);
    [[nodiscard]] std::size_t bytes() const { return done_; } ///< read

private:
    [[noreturn]] void refuse(const std::string& problem, const std::string& instead) const;

    std::string name_;
    std::string give_;
    std::ifstream opened_;
    std::istream* in_;
    std::size_t most_;
    std::size_t done_ = 0;
};

/// The text of a file, a pipe or a device, or for "-" of standard input, once. Throws InputError
/// that calls it `what` ("recipe (TOML)") where there is none, it is a folder, it cannot be read,
/// or it holds more than `most` bytes, of which no more are read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, const std::string& what,
                                    std::size_t most = most_text_bytes);

/// 64-bit FNV-1a (Fowler, Noll, Vo; draft-eastlake-fnv): tells an edited table, not a forged one.
/// With the hash of what came before, that of both.
[[nodiscard]] std::uint64_t fnv1a(std::string_view text,
                                  std::uint64_t before = 0xcbf29ce484222325U);

} // namespace edgeproof::io

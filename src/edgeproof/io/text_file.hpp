// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::io {

inline constexpr std::size_t most_text_bytes = 1'000'000'000;

/// What errors call the file: "stdin" for "-", which is standard input.
[[nodiscard]] std::string input_name(const std::filesystem::path& file);

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

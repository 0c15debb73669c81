// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof {

/// The text of a file. Throws InputError that calls it `what` ("recipe (TOML)") where there is none
/// or it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, const std::string& what);

/// 64-bit FNV-1a (Fowler, Noll, Vo; draft-eastlake-fnv): tells an edited table, not a forged one.
/// With the hash of what came before, that of both.
[[nodiscard]] std::uint64_t fnv1a(std::string_view text,
                                  std::uint64_t before = 0xcbf29ce484222325U);

} // namespace edgeproof

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/file_kind.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::scene {
namespace {

/// The rows are in the order of FileKind.
struct KindOfFile {
    std::array<std::string_view, 3> marks; ///< sections that no other kind has; the rest is empty
    std::string_view name;
    std::string_view wanted;
    std::string_view commands;
};

constexpr std::array file_kinds{
    KindOfFile{{"profile", "load", "ask"},
               "a scene",
               "a scene (TOML with [profile] and [load])",
               "edgeproof pressure, expand, extent or explain"},
    KindOfFile{{"scenes"},
               "a recipe",
               "a recipe (TOML with [scenes.NAME])",
               "edgeproof table, points or check --exec"},
    KindOfFile{{"ledger", "claim", "family"},
               "a ledger",
               "a ledger (TOML with [ledger], [[family]] and [[claim]])",
               "edgeproof verify, mutate or check --ledger"},
    KindOfFile{{"cases"},
               "a file of hard cases",
               "a file of hard cases (TOML with [cases.NAME])",
               "edgeproof bounds hard-cases"},
};
static_assert(file_kinds.size() == static_cast<std::size_t>(FileKind::hard_cases) + 1);

/// The first section of a file that only this kind has; empty if there is none.
std::string_view mark_in(const io::TomlSection& top, const KindOfFile& kind) {
    const auto mark = std::ranges::find_if(
        kind.marks, [&](std::string_view m) { return !m.empty() && top.has(m); });
    return mark == kind.marks.end() ? std::string_view() : *mark;
}

} // namespace

std::optional<FileKind> file_kind(const io::TomlSection& top) {
    for (std::size_t i = 0; i < file_kinds.size(); ++i) {
        if (!mark_in(top, file_kinds[i]).empty()) {
            return static_cast<FileKind>(i);
        }
    }
    return std::nullopt;
}

void expect_file_kind(const io::TomlSection& top, FileKind expected) {
    const KindOfFile& right = file_kinds.at(static_cast<std::size_t>(expected));
    const auto found = file_kind(top);
    if (!found || !mark_in(top, right).empty()) {
        return;
    }
    const KindOfFile& other = file_kinds.at(static_cast<std::size_t>(*found));
    top.reject(mark_in(top, other),
               "this is " + std::string(other.name) + ", not " + std::string(right.name),
               "give " + std::string(right.wanted) + ", or give this file to " +
                   std::string(other.commands));
}

} // namespace edgeproof::scene

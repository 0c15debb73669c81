// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/file_kind.hpp"

#include <array>

namespace edgeproof::scene {
namespace {

struct KindOfFile {
    FileKind kind;
    std::array<std::string_view, 3> marks; ///< sections that no other kind has
    std::string_view name;
    std::string_view wanted;
    std::string_view commands;
};

constexpr std::array file_kinds{
    KindOfFile{FileKind::scene,
               {"profile", "load", "ask"},
               "a scene",
               "a scene (TOML with [profile] and [load])",
               "edgeproof pressure, expand, extent or explain"},
    KindOfFile{FileKind::recipe,
               {"scenes", "scenes", "scenes"},
               "a recipe",
               "a recipe (TOML with [scenes.NAME])",
               "edgeproof table, points or check --exec"},
    KindOfFile{FileKind::ledger,
               {"ledger", "claim", "family"},
               "a ledger",
               "a ledger (TOML with [ledger], [[family]] and [[claim]])",
               "edgeproof verify, mutate or check --ledger"},
    KindOfFile{FileKind::hard_cases,
               {"cases", "cases", "cases"},
               "a file of hard cases",
               "a file of hard cases (TOML with [cases.NAME])",
               "edgeproof bounds hard-cases"},
};

const KindOfFile& of(FileKind kind) { return file_kinds.at(static_cast<std::size_t>(kind)); }

} // namespace

std::optional<FileKind> file_kind(const io::TomlSection& top) {
    for (const KindOfFile& kind : file_kinds) {
        for (const std::string_view mark : kind.marks) {
            if (top.has(mark)) {
                return kind.kind;
            }
        }
    }
    return std::nullopt;
}

void expect_file_kind(const io::TomlSection& top, FileKind expected) {
    for (const std::string_view mark : of(expected).marks) {
        if (top.has(mark)) {
            return;
        }
    }
    for (const KindOfFile& other : file_kinds) {
        for (const std::string_view mark : other.marks) {
            if (top.has(mark)) {
                top.reject(mark,
                           "this is " + std::string(other.name) + ", not " +
                               std::string(of(expected).name),
                           "give " + std::string(of(expected).wanted) + ", or give this file to " +
                               std::string(other.commands));
            }
        }
    }
}

} // namespace edgeproof::scene

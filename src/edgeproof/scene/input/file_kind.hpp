// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"

#include <optional>

namespace edgeproof::scene {

/// The kinds of TOML files that the program reads.
enum class FileKind { scene, recipe, ledger, hard_cases };

/// Returns the kind of a file by its sections; nothing if they do not decide.
[[nodiscard]] std::optional<FileKind> file_kind(const io::TomlSection& top);

/// Throws InputError if the file is certainly of another kind (a scene given for a recipe). The
/// message names both kinds and the commands that take the file.
void expect_file_kind(const io::TomlSection& top, FileKind expected);

} // namespace edgeproof::scene

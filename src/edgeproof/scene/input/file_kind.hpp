// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"

#include <optional>

namespace edgeproof::scene {

/// What the TOML files of this program are.
enum class FileKind { scene, recipe, ledger, hard_cases };

/// What a file is by its sections; none where they do not tell.
[[nodiscard]] std::optional<FileKind> file_kind(const io::TomlSection& top);

/// Throws InputError where the file is plainly of another kind (a scene given for a recipe), naming
/// both and the commands that take what it is.
void expect_file_kind(const io::TomlSection& top, FileKind expected);

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/toml/toml_section.hpp"

namespace edgeproof::scene {

/// What the TOML files of this program are.
enum class FileKind { scene, recipe, ledger, hard_cases };

/// Throws InputError where the file is plainly of another kind (a scene given for a recipe), naming
/// both and the commands that take what it is.
void expect_file_kind(const io::TomlSection& top, FileKind expected);

} // namespace edgeproof::scene

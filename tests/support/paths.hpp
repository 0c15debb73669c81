// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/namespaces.hpp"
#pragma once
#include <filesystem>
#include <optional>

namespace edgeproof::test {

/// The root of the source tree.
[[nodiscard]] std::filesystem::path source_dir();

/// The program `edgeproof` of this build.
[[nodiscard]] std::filesystem::path program();

/// The folder with the paper's TeX source, where it is at hand: the environment variable
/// EDGEPROOF_PAPER, else the CMake option of that name.
[[nodiscard]] std::optional<std::filesystem::path> paper_dir();

} // namespace edgeproof::test

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/namespaces.hpp"
#pragma once
#include <filesystem>
#include <optional>

namespace edgeproof::test {

/// Returns the root of the source tree.
[[nodiscard]] std::filesystem::path source_dir();

/// Returns the program `edgeproof` of this build.
[[nodiscard]] std::filesystem::path program();

/// Returns the folder with the paper's TeX source, if it is available: from the environment
/// variable EDGEPROOF_PAPER, else from the CMake option of that name.
[[nodiscard]] std::optional<std::filesystem::path> paper_dir();

} // namespace edgeproof::test

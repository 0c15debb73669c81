// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/paths.hpp"
#include "tests/support/namespaces.hpp"

#include <cstdlib>

namespace edgeproof::test {

std::filesystem::path source_dir() { return EDGEPROOF_SOURCE_DIR; }

std::filesystem::path program() { return EDGEPROOF_PROGRAM; }

std::optional<std::filesystem::path> paper_dir() {
    const char* named = std::getenv("EDGEPROOF_PAPER");
    const std::filesystem::path folder = named != nullptr ? named : EDGEPROOF_PAPER;
    if (folder.empty() || !std::filesystem::is_directory(folder)) {
        return std::nullopt;
    }
    return folder;
}

} // namespace edgeproof::test

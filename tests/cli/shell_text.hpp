// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <cstdio>

namespace edgeproof::test {

/// Returns what `command`, run in the folder by a shell, writes to both streams.
inline std::string shell_text(const Folder& folder, const std::string& command) {
    const std::string all = "cd '" + folder.path().string() + "' && { " + command + "; } 2>&1";
    std::string out;
    FILE* const pipe = ::popen(all.c_str(), "r");
    char buffer[4096];
    while (pipe != nullptr && std::fgets(buffer, sizeof buffer, pipe) != nullptr) {
        out += buffer;
    }
    if (pipe != nullptr) {
        ::pclose(pipe);
    }
    return out;
}

} // namespace edgeproof::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/namespaces.hpp"
#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace edgeproof::test {

inline std::string read_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace edgeproof::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <sstream>
#include <string>
#include <vector>

namespace edgeproof::test {

/// Returns the texts of a block: each line has one, or several with two blanks or more between
/// them.
inline std::vector<std::string> items(const std::string& block) {
    std::vector<std::string> all;
    std::istringstream lines(block);
    for (std::string line; std::getline(lines, line);) {
        for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos;) {
            const std::size_t end = line.find("  ", at);
            all.push_back(line.substr(at, end - at));
            at = line.find_first_not_of(' ', end);
        }
    }
    return all;
}

} // namespace edgeproof::test

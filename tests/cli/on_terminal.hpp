// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/cli/run_program.hpp"

#include <doctest/doctest.h>

#include <pty.h>

#include <array>
#include <string>
#include <vector>

/// Runs the program in a pseudo-terminal.
namespace edgeproof::test {

/// Returns what the command writes to a terminal, with these variables set (NAME=VALUE) or unset
/// (NAME). The first word is the path of the program.
inline std::string written_to_terminal(const Folder& folder,
                                       const std::vector<std::string>& environment,
                                       const std::vector<std::string>& command) {
    int terminal = -1;
    const ::pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    REQUIRE(child >= 0);
    if (child == 0) {
        for (const std::string& variable : environment) {
            const std::size_t equals = variable.find('=');
            if (equals == std::string::npos) {
                ::unsetenv(variable.c_str());
            } else {
                ::setenv(variable.substr(0, equals).c_str(), variable.c_str() + equals + 1, 1);
            }
        }
        std::vector<char*> words;
        for (const std::string& word : command) {
            words.push_back(const_cast<char*>(word.c_str())); // NOLINT: execv's own type
        }
        words.push_back(nullptr);
        if (::chdir(folder.path().c_str()) == 0) {
            ::execv(words.front(), words.data());
        }
        ::_exit(127);
    }
    std::string text;
    std::array<char, 4096> block{};
    for (::ssize_t n = 0; (n = ::read(terminal, block.data(), block.size())) > 0;) {
        text.append(block.data(), static_cast<std::size_t>(n));
    }
    ::close(terminal);
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFEXITED(status));
    return text;
}

} // namespace edgeproof::test

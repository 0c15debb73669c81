// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/hertz_ledger.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <pty.h>

#include <array>

using namespace edgeproof::test;

namespace {

/// Returns what the program writes to a terminal, with these variables set (NAME=VALUE) or unset
/// (NAME).
std::string on_terminal(const Folder& folder, const std::vector<std::string>& environment,
                        const std::vector<std::string>& arguments) {
    const std::string path = program().string();
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
        std::vector<char*> words{const_cast<char*>(path.c_str())}; // NOLINT: execv's own type
        for (const std::string& argument : arguments) {
            words.push_back(const_cast<char*>(argument.c_str())); // NOLINT
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

} // namespace

TEST_CASE("colours and escapes: on a terminal that obeys them, unless NO_COLOR refuses") {
    const Folder folder;
    folder.write("own.toml", hertz_head + hertz_right);
    const auto verify = [&](const std::vector<std::string>& environment) {
        const std::string text = on_terminal(folder, environment, {"verify", "own.toml"});
        CHECK(has(text, "confirmed"));
        return text;
    };
    CHECK(has(verify({"TERM=xterm", "NO_COLOR"}), "\x1b[32m"));
    CHECK(has(verify({"TERM=xterm", "NO_COLOR="}), "\x1b[32m")); // empty counts as unset
    CHECK_FALSE(has(verify({"TERM=xterm", "NO_COLOR=1"}), "\x1b[32m"));
    CHECK_FALSE(has(verify({"TERM=dumb", "NO_COLOR"}), "\x1b"));
    CHECK_FALSE(has(verify({"TERM", "NO_COLOR"}), "\x1b"));
    CHECK_FALSE(has(verify({"TERM=dumb", "NO_COLOR=1"}), "\x1b"));
}

TEST_CASE("a wide table is wrapped on a terminal, and nowhere else") {
    const Folder folder;
    folder.write("s.toml", "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\n"
                           "contact_modulus = 1\n[ask]\nu = [\"1/10\", \"1/5\"]\nterms = 1\n");
    const std::vector<std::string> arguments{"pressure", "s.toml", "--format", "md"};
    std::size_t tables = 0;
    for (const std::string& line : lines(on_terminal(folder, {}, arguments))) {
        if (line.rfind("| edge", 0) == 0) {
            CHECK(has(line, "| edge  |    u |"));
            ++tables;
        }
        if (line.rfind('|', 0) == 0) {
            CHECK(line.size() <= 101); // 100, and the terminal's \r
        }
    }
    CHECK(tables >= 2);
    CHECK(lines(run(folder, "pressure s.toml --format md").out).back().size() > 150);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/hertz_ledger.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <pty.h>

#include <array>
#include <sstream>

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

// Hertz with a = 1, E* = R = 1 mm: p = sqrt(u (2 - u))/2, 0.3 at u = 1/5; one term is within 1 % up
// to u = 2 (1 - 1.01^-2) = 402/10201 = 0.0394079.
TEST_CASE("a terminal shows a short answer, a pipe and every option of the output CSV") {
    const Folder folder;
    folder.write("s.toml", "title = \"Hertz\"\n[units]\nlength = \"mm\"\npressure = \"MPa\"\n"
                           "[profile]\nkind = \"hertz\"\nR = 1\n[load]\na = 1\n"
                           "contact_modulus = 1\n[ask]\nu = [\"1/5\"]\ntolerance = \"1%\"\n"
                           "terms = 1\ndigits = 30\n");
    const auto shown = [&](const std::vector<std::string>& arguments) {
        std::string text;
        for (const char c : on_terminal(folder, {"TERM=xterm"}, arguments)) {
            text += c == '\r' ? "" : std::string(1, c);
        }
        return text;
    };
    const std::string pressure = shown({"pressure", "s.toml"});
    CHECK(lines(pressure).at(0) == "Hertz");
    CHECK(has(pressure, "\na = b = 1.00000 mm (given)\n"));
    CHECK(has(pressure, "\nright edge  u = 1/5 mm  x = 0.800000 mm  p = 0.300000"));
    CHECK(has(pressure, " MPa  local_1 = 0.316228 MPa"));
    CHECK(has(pressure, "bounds are proved"));
    CHECK_FALSE(has(pressure, "#"));
    CHECK_FALSE(has(pressure, "\x1b")); // no remains of the line of the progress
    CHECK(has(shown({"pressure", "s.toml", "--digits", "9"}), "p = 0.300000000"));
    const std::string extent = shown({"extent", "s.toml"});
    CHECK(has(extent, "\nright edge  n = 1  up to u = 0.0394079 +- "));
    CHECK(has(extent, " mm  0.0197040 of a + b"));
    CHECK(has(extent, "first n terms are within 1% of the pressure\n"));
    // c_0 = sqrt(2)/2 = 0.707107 in MPa mm^(-1/2), c_1 = -c_0/4 in MPa mm^(-3/2)
    const std::string expand = shown({"expand", "s.toml", "--terms", "2"});
    CHECK(has(expand, "right edge  c_0 =  0.707107 "));
    CHECK(has(expand, " MPa mm^(-1/2)\n"));
    CHECK(has(expand, " MPa mm^(-3/2)\n"));
    for (const std::string& line : lines(pressure + extent + expand)) {
        CHECK(line.size() <= 100);
    }
    const std::string piped = run(folder, "pressure s.toml").out;
    CHECK(lines(piped).at(0) == "edge,u,x,p,p_bound,route,local_1,rel_1");
    CHECK(shown({"pressure", "s.toml", "--format", "csv"}) == piped);
    CHECK(shown({"pressure", "s.toml", "--out", "-"}) == piped);
    CHECK(shown({"pressure", "s.toml", "--out", "p.csv"}).empty());
    CHECK(file_text(folder.path() / "p.csv") == piped);
}

TEST_CASE("the first answer of the README is what a terminal shows") {
    const std::string readme = file_text(source_dir() / "README.md");
    const std::string start = "    build/release/bin/edgeproof extent --flat-and-rounded ";
    std::size_t compared = 0;
    for (const std::string& line : lines(readme)) {
        if (!line.starts_with(start)) {
            continue;
        }
        std::vector<std::string> words;
        std::istringstream text(line.substr(line.find("extent")));
        for (std::string word; text >> word;) {
            words.push_back(word);
        }
        const Folder folder;
        for (const std::string& shown : lines(on_terminal(folder, {"TERM=xterm"}, words))) {
            CHECK_MESSAGE(has(readme, "\n" + shown.substr(0, shown.find('\r')) + "\n"), shown);
            ++compared;
        }
    }
    CHECK(compared == 5);
}

TEST_CASE("quantities on a terminal: no echo of the scene unless --show-scene asks for it") {
    const Folder folder;
    const std::vector<std::string> asked{"pressure", "--hertz",           "--R", "1",   "--a",
                                         "1",        "--contact-modulus", "1",   "--u", "1/5"};
    CHECK_FALSE(has(on_terminal(folder, {"TERM=xterm"}, asked), "[profile]"));
    std::vector<std::string> with = asked;
    with.emplace_back("--show-scene");
    CHECK(has(on_terminal(folder, {"TERM=xterm"}, with), "[profile]"));
}

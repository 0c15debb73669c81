// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/inputs.hpp"
#include "tests/cli/on_terminal.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

namespace {

/// Returns what the program writes to a terminal.
std::string on_terminal(const Folder& folder, const std::vector<std::string>& environment,
                        const std::vector<std::string>& arguments) {
    std::vector<std::string> command{program().string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return written_to_terminal(folder, environment, command);
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
            CHECK(has(line, "| edge  |   u |"));
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
    CHECK(has(pressure, "\nright edge  u = 0.2 mm  x = 0.800000 mm  p = 0.300000"));
    CHECK(has(pressure, " MPa  local_1 = 0.316228 MPa"));
    CHECK(has(pressure, "bounds are proved"));
    CHECK_FALSE(has(pressure, "#"));
    CHECK_FALSE(has(pressure, "\x1b")); // no remains of the line of the progress
    CHECK(has(shown({"pressure", "s.toml", "--digits", "9"}), "p = 0.300000000"));
    const std::string extent = shown({"extent", "s.toml"});
    CHECK(has(extent, "\nright edge  n = 1  up to u = 0.0394079 +- "));
    CHECK(has(extent, " mm  0.0197040 of a + b"));
    CHECK(has(extent, "first n terms are within 1 % of the pressure\n"));
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

TEST_CASE("quantities on a terminal: no echo of the scene unless --show-scene asks for it") {
    const Folder folder;
    const std::vector<std::string> asked{"pressure", "--hertz",           "--R", "1",   "--a",
                                         "1",        "--contact-modulus", "1",   "--u", "1/5"};
    CHECK_FALSE(has(on_terminal(folder, {"TERM=xterm"}, asked), "[profile]"));
    std::vector<std::string> with = asked;
    with.emplace_back("--show-scene");
    CHECK(has(on_terminal(folder, {"TERM=xterm"}, with), "[profile]"));
}

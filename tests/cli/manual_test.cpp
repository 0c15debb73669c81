// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/run_program.hpp"

#include <doctest/doctest.h>

#include <regex>
#include <set>
#include <string>

namespace {

using namespace edgeproof::test;

/// Returns the names of long options, or of subcommands, in a help text.
std::set<std::string> matches_in(const std::string& help, const std::regex& what) {
    std::set<std::string> names;
    for (std::sregex_iterator i(help.begin(), help.end(), what), end; i != end; ++i) {
        names.insert((*i)[1]);
    }
    return names;
}

const std::regex long_option("\n  (?:-[a-z],)?--([A-Za-z0-9-]+)");
const std::regex a_subcommand("\n  ([a-z]+[a-z-]*) +[a-z]");

/// Escapes the hyphens as in a manual page.
std::string in_roff(const std::string& name) {
    std::string text;
    for (const char c : name) {
        text += c == '-' ? "\\-" : std::string(1, c);
    }
    return text;
}

} // namespace

TEST_CASE("the manual names every command and option of the help") {
    const Folder folder;
    const Outcome written = run(folder, "--write-manual .");
    REQUIRE(written.code == 0);
    const std::string whole = file_text(folder.path() / "man1/edgeproof.1");
    const std::string help = run(folder, "--help").out;
    CHECK(run(folder, "").out == help);
    for (const char* group : {"\nCompute:\n", "\nTables and checks:\n", "\nFor developers:\n"}) {
        CHECK(has(help, group));
    }
    const auto subcommands = matches_in(help.substr(help.find("\nCompute:")), a_subcommand);
    REQUIRE(subcommands.size() == 14);
    for (const std::string& sub : subcommands) {
        CAPTURE(sub);
        CHECK(has(whole, "edgeproof\\-" + in_roff(sub) + " (1)\n"));
        const std::string page = file_text(folder.path() / ("man1/edgeproof-" + sub + ".1"));
        CHECK(has(page, ".SH NAME\nedgeproof\\-" + in_roff(sub) + " \\- "));
        const auto options = matches_in(run(folder, sub + " --help").out, long_option);
        CHECK(options.size() >= 1);
        CHECK(options.size() <= 25);
        for (const std::string& option : options) {
            CHECK_MESSAGE(has(page, "\\-\\-" + in_roff(option)), option);
        }
    }
}

TEST_CASE("help of the keys of files, by their schemas") {
    const Folder folder;
    for (const auto& [kind, words] :
         {std::pair{"scene", "\n  contact_modulus"}, std::pair{"recipe", "\nscenes"},
          std::pair{"ledger", "\nclaim"}}) {
        const Outcome o = run(folder, std::string("help ") + kind);
        CHECK(o.code == 0);
        CHECK_MESSAGE(has(o.out, words), o.out);
    }
}

TEST_CASE("a file that came with the program is found by its name") {
    const Folder folder;
    CHECK(run(folder, "table power-law --check --every 200").code == 0);
    (void)folder.write("mesh.csv", "x,p\n-0.5,279\n0,321\n0.5,279\n");
    CHECK(has(run(folder, "compare fretting-pad mesh.csv").out, "fretting-pad"));
    // A file of that name in the working folder has precedence.
    (void)folder.write("moore-hills", "[ledger]\n");
    const Outcome own = run(folder, "verify moore-hills");
    CHECK(own.code == 2);
    CHECK(has(own.err, "moore-hills:"));
}

TEST_CASE("help: each command has an example that runs") {
    const Folder folder;
    std::filesystem::create_directory_symlink(source_dir() / "examples",
                                              folder.path() / "examples");
    for (const std::string command :
         {"pressure", "expand", "extent", "slip", "stress", "displacement", "plot", "relations",
          "design", "table", "points", "check", "compare", "verify"}) {
        CAPTURE(command);
        const Outcome help = run(folder, command + " --help");
        CHECK(help.code == 0);
        CHECK(run(folder, "help " + command).out == help.out);
        const std::string start = "\nExample: edgeproof ";
        const std::size_t at = help.out.find(start);
        REQUIRE(at != std::string::npos);
        const std::size_t from = at + start.size();
        const std::string example = help.out.substr(from, help.out.find('\n', from) - from);
        CAPTURE(example);
        CHECK(example.rfind(command + " ", 0) == 0);
        if (command != "check") { // a minute: every claim of the paper
            const Outcome o = run(folder, example);
            CAPTURE(o.err);
            CHECK(o.code == 0);
        }
    }
}

TEST_CASE("the shell's function passes the words on to the program, which completes them") {
    const Folder folder;
    const std::string stub =
        (source_dir() / "share" / "edgeproof" / "completions" / "edgeproof.bash").string();
    folder.write("try.bash", "edgeproof() { '" + program().string() + "' \"$@\"; }\nsource '" +
                                 stub +
                                 "'\nCOMP_WORDS=(edgeproof pressure fret)\nCOMP_CWORD=2\n"
                                 "_edgeproof\nprintf '%s\\n' \"${COMPREPLY[@]}\" >proposed\n");
    REQUIRE(std::system(("cd '" + folder.path().string() + "' && bash try.bash").c_str()) == 0);
    CHECK(file_text(folder.path() / "proposed") == "fretting-pad\n");
}

// SPDX-License-Identifier: GPL-3.0-or-later
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

TEST_CASE("the manual and the completions name every subcommand and option of the help") {
    const Folder folder;
    const Outcome written = run(folder, "--write-manual .");
    REQUIRE(written.code == 0);
    const std::string bash = file_text(folder.path() / "edgeproof.bash");
    const std::string zsh = file_text(folder.path() / "_edgeproof");
    const std::string fish = file_text(folder.path() / "edgeproof.fish");
    const std::string whole = file_text(folder.path() / "man1/edgeproof.1");
    const std::string help = run(folder, "--help").out;
    const auto subcommands = matches_in(help.substr(help.find("Subcommands:")), a_subcommand);
    REQUIRE(subcommands.size() >= 11);
    for (const std::string& sub : subcommands) {
        CAPTURE(sub);
        CHECK(has(whole, "edgeproof\\-" + in_roff(sub) + "\\fR(1)"));
        CHECK(has(bash, "'" + sub + "') words="));
        CHECK(has(zsh, "_edgeproof_" + sub + "() {"));
        CHECK(has(fish, "-a " + sub + " -d '"));
        const std::string page = file_text(folder.path() / ("man1/edgeproof-" + sub + ".1"));
        CHECK(has(page, ".SH NAME\nedgeproof\\-" + in_roff(sub) + " \\- "));
        const auto options = matches_in(run(folder, sub + " --help").out, long_option);
        CHECK(options.size() >= 1);
        for (const std::string& option : options) {
            CAPTURE(option);
            CHECK(has(page, "\\fB\\-\\-" + in_roff(option) + "\\fR"));
            CHECK(has(bash, "--" + option));
            CHECK(has(zsh, "'--" + option + "["));
            CHECK(has(fish, "'__fish_seen_subcommand_from " + sub + "'"));
            CHECK(has(fish, " -l " + option + " "));
        }
    }
}

TEST_CASE("a file that came with the program is found by its name") {
    const Folder folder;
    const Outcome named = run(folder, "verify moore-hills --only EQ18 --digits 20");
    CHECK(named.code == 0);
    CHECK(has(named.out, "as recorded in moore-hills.expected.csv"));
    CHECK(run(folder, "pressure fretting-pad --digits 5").code == 0);
    CHECK(run(folder, "table power-law --check --every 200").code == 0);
    CHECK(run(folder, "cost fretting-pad --digits 16 --points 1").code == 0);
    CHECK(run(folder, "design exponent --digits 4 --gap 1e-1").code == 0);
    (void)folder.write("mesh.csv", "x,p\n-0.5,279\n0,321\n0.5,279\n");
    CHECK(has(run(folder, "compare fretting-pad mesh.csv").out, "fretting-pad"));
    const Outcome none = run(folder, "verify nonesuch");
    CHECK(none.code == 2);
    CHECK(has(none.err, "nonesuch: there is no such file"));
    // A file of that name in the working folder has precedence.
    (void)folder.write("moore-hills", "[ledger]\n");
    const Outcome own = run(folder, "verify moore-hills");
    CHECK(own.code == 2);
    CHECK(has(own.err, "moore-hills:"));
}

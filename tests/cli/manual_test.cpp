// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
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
    CHECK(has(zsh, "'*:file: _alternative \"shipped:"));
    CHECK_FALSE(has(zsh, ":_alternative")); // without the blank it is called with -J
    for (const std::string& sub : subcommands) {
        CAPTURE(sub);
        CHECK(has(whole, "edgeproof\\-" + in_roff(sub) + "\\fR(1)"));
        CHECK(has(bash, "'" + sub + "') words="));
        CHECK(has(zsh, "_edgeproof_" + sub + "() {"));
        CHECK(has(fish, "-a " + sub + " -d '"));
        const std::string page = file_text(folder.path() / ("man1/edgeproof-" + sub + ".1"));
        CHECK(has(page, ".SH NAME\nedgeproof\\-" + in_roff(sub) + " \\- "));
        const Outcome all = run(folder, sub + " --help-all"); // bounds has subcommands instead
        const auto options =
            matches_in(all.code == 0 ? all.out : run(folder, sub + " --help").out, long_option);
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
    CHECK(run(folder, "table power-law --check --every 200").code == 0);
    (void)folder.write("mesh.csv", "x,p\n-0.5,279\n0,321\n0.5,279\n");
    CHECK(has(run(folder, "compare fretting-pad mesh.csv").out, "fretting-pad"));
    // A file of that name in the working folder has precedence.
    (void)folder.write("moore-hills", "[ledger]\n");
    const Outcome own = run(folder, "verify moore-hills");
    CHECK(own.code == 2);
    CHECK(has(own.err, "moore-hills:"));
}

TEST_CASE("help: five usual options and an example that runs; all options on request") {
    const Folder folder;
    std::filesystem::create_directory_symlink(source_dir() / "examples",
                                              folder.path() / "examples");
    std::size_t examples = 0;
    for (const std::string command :
         {"pressure", "expand", "extent", "slip", "stress", "displacement", "plot", "relations",
          "design", "points", "check", "compare", "verify"}) {
        CAPTURE(command);
        const Outcome help = run(folder, command + " --help");
        CHECK(help.code == 0);
        CHECK(run(folder, "help " + command).out == help.out);
        const std::string all = run(folder, command + " --help-all").out;
        const std::set<std::string> shown = matches_in(help.out, long_option);
        const std::set<std::string> every = matches_in(all, long_option);
        CHECK(std::includes(every.begin(), every.end(), shown.begin(), shown.end()));
        CHECK(every.contains("help-all"));
        if (has(help.out, "Usual options:")) {
            CHECK(shown.size() == 5);
            CHECK(every.size() > 7);
        }
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
            ++examples;
        }
    }
    CHECK(examples == 12);
    CHECK(has(run(folder, "help").out, "Subcommands:"));
}

TEST_CASE("bash completes the values of options, and the shipped files of a command") {
    const Folder folder;
    REQUIRE(run(folder, "--write-manual .").code == 0);
    folder.write("mine.toml", "");
    // Prints the proposals for the last of the words.
    folder.write("try.bash",
                 "source edgeproof.bash\nCOMP_WORDS=(\"$@\")\n"
                 "COMP_CWORD=$(($# - 1))\n_edgeproof\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
    const auto proposals = [&](const std::string& words) {
        const std::string command =
            "cd '" + folder.path().string() + "' && bash try.bash " + words + " > proposed";
        REQUIRE(std::system(command.c_str()) == 0);
        const auto list = lines(file_text(folder.path() / "proposed"));
        return std::set<std::string>(list.begin(), list.end());
    };
    using Set = std::set<std::string>;
    CHECK(proposals("edgeproof pressure --format ''") == Set{"csv", "json", "md", "tex"});
    CHECK(proposals("edgeproof pressure --edge r") == Set{"right"});
    CHECK(proposals("edgeproof compare --format ''") == Set{"text", "json"});
    CHECK(proposals("edgeproof pressure fret") == Set{"fretting-pad"});
    CHECK(proposals("edgeproof pressure mi") == Set{"mine.toml"});
    CHECK(proposals("edgeproof verify moore") == Set{"moore-hills"});
    CHECK(proposals("edgeproof design expo") == Set{"exponent"});
    CHECK(proposals("edgeproof pressure --form") == Set{"--format"});
    CHECK(proposals("edgeproof press") == Set{"pressure"});
    CHECK(proposals("edgeproof stress stress --body ''") == Set{"A", "B"});
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

namespace {

bool have(const char* command) {
    const bool there = std::system((std::string(command) + " >/dev/null 2>&1").c_str()) == 0;
    if (!there) {
        MESSAGE("skipped: not here: ", std::string(command));
    }
    return there;
}

std::filesystem::path third_party() { return source_dir() / "examples" / "third-party"; }

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

/// Runs `edgeproof check QUESTIONS --exec COMMAND OPTIONS` in the folder of the programs' copies.
Outcome ask(const Folder& folder, const std::string& command, const std::string& options) {
    return run(folder, "check questions.toml --exec '" + command + "' " + options);
}

/// A copy of the programs' folder, so that nothing is built or cached in the source.
struct Programs {
    Folder folder;
    Programs() {
        for (const auto& entry : std::filesystem::directory_iterator(third_party())) {
            if (entry.is_regular_file()) {
                std::filesystem::copy(entry.path(), folder.path() / entry.path().filename());
            }
        }
    }
    /// Runs a shell command in the folder.
    bool shell(const std::string& command) const {
        return std::system(("cd " + quoted(folder.path()) + " && " + command).c_str()) == 0;
    }
};

const std::string all_pass = "pass: 220 answers, 0 failures";

std::string first_line(const std::string& text) {
    const auto all = edgeproof::test::lines(text);
    return all.empty() ? "" : all.front();
}
std::string last_line(const std::string& text) {
    const auto all = edgeproof::test::lines(text);
    return all.empty() ? "" : all.back();
}

} // namespace

TEST_CASE("third-party programs: C in double") {
    const Programs programs;
    if (have("cc --version")) {
        REQUIRE(programs.shell("cc -std=c99 -O2 -o closed_forms closed_forms.c -lm"));
        CHECK(first_line(ask(programs.folder, "./closed_forms", "--digits 13").out) == all_pass);
        // Doubles do not have 17 digits: the check can fail.
        CHECK(ask(programs.folder, "./closed_forms", "--digits 17").code == 1);
    }
}

TEST_CASE("third-party programs: Fortran, quadrature in real*8") {
    const Programs programs;
    if (have("gfortran --version")) {
        REQUIRE(programs.shell("gfortran -O2 -o quadrature quadrature.f90"));
        const Outcome o = ask(programs.folder, "./quadrature", "--digits 13");
        CAPTURE(o.out);
        CHECK(first_line(o.out) == all_pass);
    }
}

TEST_CASE("third-party programs: 30 digits by mpmath and by PARI/GP") {
    const Programs programs;
    if (have("python3 -c 'import mpmath'")) {
        const Outcome o = ask(programs.folder, "python3 thirty_digits.py", "--digits 30");
        CAPTURE(o.out);
        CHECK(first_line(o.out) == all_pass);
    }
    if (have("gp --version")) {
        const Outcome o = ask(programs.folder, "gp -q closed_forms.gp", "--digits 30");
        CAPTURE(o.out);
        CHECK(first_line(o.out) == all_pass);
    }
}

TEST_CASE("third-party programs: a pipe of the shell") {
    const Programs programs;
    if (!have("python3 -c 'import csv'")) {
        return;
    }
    const std::string program = quoted(edgeproof::test::program());
    CHECK(programs.shell(program + " points questions.toml | python3 closed_forms.py | " + program +
                         " check - --digits 13 >piped"));
    CHECK(first_line(file_text(programs.folder.path() / "piped")) == all_pass);
}

TEST_CASE("third-party programs: each of the six deliberate mistakes of one program is named") {
    const Programs programs;
    if (!have("python3 -c 'import csv'")) {
        return;
    }
    const Outcome o = ask(programs.folder, "python3 wrong_on_purpose.py", "--errors 100");
    CHECK(o.code == 1);
    for (const char* part :
         {"P: yours are 2 times ours, to 15.", "c_1: yours are minus ours, to 15.",
          ": wedge:C=0.1:contact_modulus=1:right:u=0.999:p: nan\n",
          ": wedge:C=0.1:contact_modulus=1:right:u=0.9:p: missing\n",
          ": wedge:C=0.1:contact_modulus=1:left:c_0 is answered twice, first in line 10\n",
          "p: yours are in single precision (binary32), to 7."}) {
        CAPTURE(part);
        CHECK(has(o.out, part));
    }
}

TEST_CASE("check --ledger: the user's own formulas; the wrong one is named and corrected") {
    const Folder folder;
    const Outcome o = run(folder, "check --ledger " + quoted(third_party() / "formulas.toml"));
    CAPTURE(o.out);
    CHECK(o.code == 1);
    CHECK(has(o.out, "pressure  "));
    CHECK(has(o.out, "FAIL: 3 formulas, 1 do not hold"));
    std::string text = file_text(third_party() / "formulas.toml");
    text.resize(text.rfind("[[claim]]"));
    folder.write("right.toml", text);
    const Outcome right = run(folder, "check --ledger right.toml");
    CHECK(right.code == 0);
    CHECK(last_line(right.out) == "pass: 2 formulas, 0 do not hold");
    folder.write("bad.toml",
                 text + "[[claim]]\nid = \"x\"\nkind = \"compare\"\nsays = \"unknown_name\"\n"
                        "of = \"P\"\nover = \"cylinder\"\n");
    const Outcome bad = run(folder, "check --ledger bad.toml");
    CHECK(bad.code == 2);
    CHECK(lines(bad.err).size() == 1);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::test;

namespace {

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

TEST_CASE("third-party programs have the digits that they state, and the check can fail") {
    struct Program {
        const char* needs;
        const char* build;
        const char* run;
        const char* digits;
        const char* too_many; ///< digits that the program does not have
    };
    for (const auto& program :
         {Program{"cc --version", "cc -std=c99 -O2 -o closed_forms closed_forms.c -lm",
                  "./closed_forms", "13", "17"},
          Program{"gfortran --version", "gfortran -O2 -o quadrature quadrature.f90", "./quadrature",
                  "13", "17"},
          Program{"python3 -c 'import mpmath'", "true", "python3 thirty_digits.py", "30", "60"},
          Program{"gp --version", "true", "gp -q closed_forms.gp", "30", "60"}}) {
        const Programs programs;
        CAPTURE(std::string(program.run));
        if (shell_has(program.needs)) {
            REQUIRE(programs.shell(program.build));
            const Outcome o =
                ask(programs.folder, program.run, std::string("--digits ") + program.digits);
            CHECK_MESSAGE(first_line(o.out) == all_pass, o.out);
            CHECK(ask(programs.folder, program.run, std::string("--digits ") + program.too_many)
                      .code == 1);
        }
    }
}

TEST_CASE("third-party programs: a pipe of the shell") {
    const Programs programs;
    if (!shell_has("python3 -c 'import csv'")) {
        return;
    }
    const std::string program = quoted(edgeproof::test::program());
    CHECK(programs.shell(program + " points questions.toml | python3 closed_forms.py | " + program +
                         " check - --digits 13 >piped"));
    CHECK(first_line(file_text(programs.folder.path() / "piped")) == all_pass);
}

TEST_CASE("third-party programs: each of the six deliberate mistakes of one program is named") {
    const Programs programs;
    if (!shell_has("python3 -c 'import csv'")) {
        return;
    }
    const Outcome right =
        run(programs.folder, "check questions.toml --digits 13 -- python3 closed_forms.py");
    CHECK(first_line(right.out) == all_pass); // found in PATH, without a shell that reads the words
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

using namespace edgeproof::test;

namespace {

bool shell_has(const char* command) {
    const bool there = std::system((std::string(command) + " >/dev/null 2>&1").c_str()) == 0;
    if (!there) {
        MESSAGE("skipped: not here: ", command);
    }
    return there;
}

/// A copy of the committed pack.
struct PackCopy {
    Folder folder;
    PackCopy() {
        for (const auto& entry :
             std::filesystem::directory_iterator(source_dir() / "reference" / "pack")) {
            std::filesystem::copy(entry.path(), folder.path() / entry.path().filename());
        }
    }
    /// Runs a shell command in the folder, and returns its exit status.
    int shell(const std::string& command) const {
        const int status = std::system(
            ("cd '" + folder.path().string() + "' && " + command + " >out 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    void edit(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = file_text(folder.path() / name);
        const std::size_t at = text.find(from);
        REQUIRE(at != std::string::npos);
        folder.write(name, text.replace(at, from.size(), to));
    }
};

struct PackLanguage {
    const char* needs;
    const char* build;
    const char* hold_a;
    const char* hold_b;
    const char* hold_c;
    const char* example;
    /// The edit that makes the example compute in binary64, if it does not already.
    std::pair<const char*, const char*> in_double;
    std::pair<const char*, const char*> slightly_wrong; ///< 1e-14: too much for level B
    std::pair<const char*, const char*> grossly_wrong;  ///< 5 %: too much for level A
};

const std::vector<PackLanguage> pack_languages{
    {"cc --version",
     "cc -std=c99 -Wall -Wextra -pedantic -Werror -O2 -o driver driver.c example.c -lm",
     "./driver A level-a.csv",
     "./driver B cases.csv hard-cases.csv",
     "./driver C cases.csv hard-cases.csv",
     "example.c",
     {"", ""},
     {"*value = k * sqrt(c->u", "*value = (1 + 1e-14) * k * sqrt(c->u"},
     {"*value = k * sqrt(c->u", "*value = 1.05 * k * sqrt(c->u"}},
    {"c++ --version",
     "c++ -std=c++17 -Wall -Wextra -Werror -O2 -o driver driver.cpp example.cpp",
     "./driver A level-a.csv",
     "./driver B cases.csv hard-cases.csv",
     "./driver C cases.csv hard-cases.csv",
     "example.cpp",
     {"", ""},
     {"return k * std::sqrt(c.u", "return (1 + 1e-14) * k * std::sqrt(c.u"},
     {"return k * std::sqrt(c.u", "return 1.05 * k * std::sqrt(c.u"}},
    {"gfortran --version",
     "gfortran -std=f2008 -O2 -o driver edgeproof_case.f90 example.f90 driver.f90",
     "./driver A level-a.csv",
     "./driver B cases.csv hard-cases.csv",
     "./driver C cases.csv hard-cases.csv",
     "example.f90",
     {"", ""},
     {"value = k*sqrt(c%u", "value = (1 + 1d-14)*k*sqrt(c%u"},
     {"value = k*sqrt(c%u", "value = 1.05d0*k*sqrt(c%u"}},
    {"python3 --version",
     "true",
     "python3 driver.py A level-a.csv",
     "python3 driver.py B cases.csv hard-cases.csv",
     "python3 driver.py C cases.csv hard-cases.csv",
     "example.py",
     {"return k * (u * (2 * a - u)).sqrt()",
      "return float(k) * (float(u) * (2 * float(a) - float(u))) ** 0.5"},
     {"return k * (u * (2 * a - u)).sqrt()",
      "return k * (u * (2 * a - u)).sqrt() * Decimal('1.00000000000001')"},
     {"return k * (u * (2 * a - u)).sqrt()",
      "return k * (u * (2 * a - u)).sqrt() * Decimal('1.05')"}},
    {"octave-cli --version",
     "true",
     "octave-cli --eval \"exit(run_pack('A', {'level-a.csv'}))\"",
     "octave-cli --eval \"exit(run_pack('B', {'cases.csv', 'hard-cases.csv'}))\"",
     "octave-cli --eval \"exit(run_pack('C', {'cases.csv', 'hard-cases.csv'}))\"",
     "edgeproof_answer.m",
     {"", ""},
     {"value = k * sqrt(c.u", "value = (1 + 1e-14) * k * sqrt(c.u"},
     {"value = k * sqrt(c.u", "value = 1.05 * k * sqrt(c.u"}},
};

} // namespace

TEST_CASE("pack: the committed one is reproduced in every byte; an edited one is reported") {
    const PackCopy copy;
    CHECK(run(copy.folder, "pack . --check").code == 0);
    copy.edit("cases.csv", ",right,", ",left,");
    const Outcome edited = run(copy.folder, "pack . --check");
    CHECK(edited.code == 1);
    CHECK(has(edited.err, "cases.csv:"));
    const PackCopy other;
    other.edit("MANIFEST", "  cases.csv", "  kases.csv");
    CHECK(run(other.folder, "pack . --check").code == 1);
    const Folder empty;
    CHECK(run(empty, "pack made --commit abc --date 2026-01-02").code == 0);
    const std::string manifest_text = file_text(empty.path() / "made" / "MANIFEST");
    CHECK(
        has(manifest_text, "# commit: abc\n# date: 2026-01-02\n# command: edgeproof pack made\n"));
    // sha256sum is an independent program.
    if (shell_has("sha256sum --version")) {
        CHECK(other.shell("sha256sum --quiet -c MANIFEST") == 1); // the manifest has an edited name
        CHECK(PackCopy().shell("sha256sum --quiet --strict -c MANIFEST") == 0);
        CHECK(copy.shell("sha256sum --quiet -c MANIFEST") == 1); // the edited row
    }
}

TEST_SUITE("slow") {
    TEST_CASE("pack: drivers pass a right code, and fail a wrong one, in each language") {
        for (const PackLanguage& language : pack_languages) {
            CAPTURE(language.example);
            if (!shell_has(language.needs)) {
                continue;
            }
            const PackCopy right;
            if (*language.in_double.first != '\0') {
                right.edit(language.example, language.in_double.first, language.in_double.second);
            }
            REQUIRE(right.shell(language.build) == 0);
            CHECK(right.shell(language.hold_a) == 0);
            CHECK(has(file_text(right.folder.path() / "out"), ": 104 answered, 0 wrong,"));
            CHECK(right.shell(language.hold_b) == 0);
            CHECK(has(file_text(right.folder.path() / "out"), ": 77 answered, 0 wrong,"));
            // An error of a few units in the last place passes level B, but is not correctly
            // rounded.
            CHECK(right.shell(language.hold_c) == 1);
            CHECK(has(file_text(right.folder.path() / "out"), "power:m=1:"));
            CHECK(has(file_text(right.folder.path() / "out"), "level C: 77 answered, "));
            const PackCopy slightly;
            slightly.edit(language.example, language.slightly_wrong.first,
                          language.slightly_wrong.second);
            REQUIRE(slightly.shell(language.build) == 0);
            CHECK(slightly.shell(language.hold_a) == 0); // level A tolerates it
            CHECK(slightly.shell(language.hold_b) == 1);
            CHECK(has(file_text(slightly.folder.path() / "out"),
                      "power:m=1:C=1:a=1:right:u=1e-15:p: "));
            const PackCopy grossly;
            grossly.edit(language.example, language.grossly_wrong.first,
                         language.grossly_wrong.second);
            REQUIRE(grossly.shell(language.build) == 0);
            CHECK(grossly.shell(language.hold_a) == 1);
            CHECK(has(file_text(grossly.folder.path() / "out"), ":p: "));
            // A file with another header is refused.
            const PackCopy cut;
            cut.edit("level-a.csv", "id,kind", "id,sort");
            REQUIRE(cut.shell(language.build) == 0);
            CHECK(cut.shell(language.hold_a) == 2);
        }
    }

    TEST_CASE("pack: correctly rounded, and 50 digits") {
        if (!shell_has("python3 --version")) {
            return;
        }
        const PackCopy copy;
        CHECK(copy.shell("python3 driver.py C cases.csv hard-cases.csv") == 0);
        CHECK(copy.shell("python3 driver.py D cases.csv hard-cases.csv") == 0);
        // 40 digits are not 50.
        copy.edit("example.py", "prec = 80", "prec = 40");
        copy.edit("example.py", "context.prec = 1500", "context.prec = 40");
        CHECK(copy.shell("python3 driver.py D cases.csv hard-cases.csv") == 1);
        CHECK(copy.shell("python3 driver.py B cases.csv hard-cases.csv") == 0);
    }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/diagnose/diagnose.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace edgeproof::test;

namespace {

/// A copy of the committed pack.
struct PackCopy {
    Folder folder;
    Folder printed; ///< with the file `out` of the last command
    PackCopy() {
        for (const auto& entry :
             std::filesystem::directory_iterator(source_dir() / "reference" / "pack")) {
            std::filesystem::copy(entry.path(), folder.path() / entry.path().filename());
        }
    }
    /// Runs a shell command in the folder, and returns its exit status.
    int shell(const std::string& command) const {
        const int status = std::system(("cd '" + folder.path().string() + "' && " + command +
                                        " >'" + (printed.path() / "out").string() + "' 2>&1")
                                           .c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    [[nodiscard]] std::string said() const { return file_text(printed.path() / "out"); }
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
    std::string run;                  ///< with the arguments LEVEL and FILES
    const char* example;              ///< a file
    std::string pressure;             ///< its text in the example
    std::string close;                ///< the same with an error of 1e-14: too much for level B
    std::string wrong;                ///< the same with an error of 5 %: too much for level A
    std::string in_double = pressure; ///< the same in binary64

    /// The command that compares the example with a level of the pack.
    [[nodiscard]] std::string level(const std::string& name) const {
        const bool octave = has(run, "octave");
        const auto file = [&](const std::string& f) { return octave ? "'" + f + "'" : f; };
        const std::string files =
            name == "A" ? file("level-a.csv")
                        : file("cases.csv") + (octave ? ", " : " ") + file("hard-cases.csv");
        return std::regex_replace(std::regex_replace(run, std::regex("LEVEL"), name),
                                  std::regex("FILES"), files);
    }
};

const std::vector<PackLanguage> pack_languages{
    {"cc --version",
     "cc -std=c99 -Wall -Wextra -pedantic -Werror -O2 -o driver driver.c example.c -lm",
     "./driver LEVEL FILES", "example.c", "k * sqrt(c->u", "(1 + 1e-14) * k * sqrt(c->u",
     "1.05 * k * sqrt(c->u"},
    {"c++ --version", "c++ -std=c++17 -Wall -Wextra -Werror -O2 -o driver driver.cpp example.cpp",
     "./driver LEVEL FILES", "example.cpp", "k * std::sqrt(c.u", "(1 + 1e-14) * k * std::sqrt(c.u",
     "1.05 * k * std::sqrt(c.u"},
    {"gfortran --version",
     "gfortran -std=f2008 -O2 -o driver edgeproof_case.f90 example.f90 driver.f90",
     "./driver LEVEL FILES", "example.f90", "k*sqrt(c%u", "(1 + 1d-14)*k*sqrt(c%u",
     "1.05d0*k*sqrt(c%u"},
    {"python3 --version", "true", "python3 driver.py LEVEL FILES", "example.py",
     "return k * (u * (2 * a - u)).sqrt()",
     "return k * (u * (2 * a - u)).sqrt() * Decimal('1.00000000000001')",
     "return k * (u * (2 * a - u)).sqrt() * Decimal('1.05')",
     "return float(k) * (float(u) * (2 * float(a) - float(u))) ** 0.5"},
    {"octave-cli --version", "true", "octave-cli --eval \"exit(run_pack('LEVEL', {FILES}))\"",
     "edgeproof_answer.m", "k * sqrt(c.u", "(1 + 1e-14) * k * sqrt(c.u", "1.05 * k * sqrt(c.u"},
};

} // namespace

TEST_CASE("pack: factors.txt has the named factors of the catalogue") {
    std::istringstream lines(file_text(source_dir() / "reference" / "pack" / "factors.txt"));
    std::vector<std::pair<std::string, double>> there;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::pair<std::string, double> factor;
        if (words >> factor.first >> factor.second) {
            there.push_back(factor);
        }
    }
    std::vector<std::pair<std::string, double>> named;
    for (const auto& factor : edgeproof::diagnose::named_factors()) {
        named.emplace_back(factor.name, factor.value.convert_to<double>());
    }
    CHECK(there == named);
}

TEST_SUITE("slow") {
    TEST_CASE("pack: the committed one is as made anew, and edited files are reported") {
        if (!shell_has("python3 --version")) {
            return;
        }
        const std::string check = "EDGEPROOF='" + program().string() + "' '" +
                                  (source_dir() / "scripts" / "pack").string() + "' --check .";
        const PackCopy copy;
        CHECK(copy.shell(check) == 0);
        CHECK(copy.said() == "the pack is as made anew\n");
        copy.edit("cases.csv", "0.45015815807855303477759959550337029133228707497761",
                  "0.45015815807855303477759959550337029133228707497791");
        copy.edit("level-a.csv", "-3,3.17,4", "-3,2.17,4");
        CHECK(copy.shell(check) == 1);
        const std::string said = copy.said();
        for (const char* problem : {"cases.csv: 1 lines differ of ", "level-a.csv: 1 lines differ ",
                                    "MANIFEST: the checksums are not those of the files"}) {
            CHECK(has(said, problem));
        }
        CHECK(!has(said, "hard-cases.csv"));
    }

    TEST_CASE("pack: drivers pass a right code, and fail a wrong one, in each language") {
        for (const PackLanguage& language : pack_languages) {
            CAPTURE(language.example);
            if (!shell_has(language.needs)) {
                continue;
            }
            const auto copy_with = [&](const std::string& pressure) {
                auto copy = std::make_unique<PackCopy>();
                copy->edit(language.example, language.pressure, pressure);
                REQUIRE(copy->shell(language.build) == 0);
                return copy;
            };
            const auto output = [](const PackCopy& copy) { return copy.said(); };
            const auto right = copy_with(language.in_double);
            CHECK(right->shell(language.level("A")) == 0);
            CHECK(has(output(*right), ": 104 answered, 0 wrong,"));
            CHECK(right->shell(language.level("B")) == 0);
            CHECK(has(output(*right), ": 77 answered, 0 wrong,"));
            // An error of a few units in the last place passes level B, but is not correctly
            // rounded.
            CHECK(right->shell(language.level("C")) == 1);
            CHECK(has(output(*right), "power:m=1:"));
            CHECK(has(output(*right), "level C: 77 answered, "));
            const auto close = copy_with(language.close);
            CHECK(close->shell(language.level("A")) == 0);
            CHECK(close->shell(language.level("B")) == 1);
            CHECK(has(output(*close), "power:m=1:C=1:a=1:right:u=1e-15:p: "));
            const auto wrong = copy_with(language.wrong);
            CHECK(wrong->shell(language.level("A")) == 1);
            CHECK(has(output(*wrong), ":p: "));
            // A factor is named, once.
            const auto doubled =
                copy_with(std::regex_replace(language.wrong, std::regex("1\\.05"), "2"));
            CHECK(doubled->shell(language.level("B")) == 1);
            CHECK(has(output(*doubled), " wrong answers for p are 2"));
            CHECK(has(output(*doubled), " times the exact ones: factor-2\n"));
            CHECK(edgeproof::test::parts(output(*doubled), "likely cause").size() == 2);
            // A file with another header is refused, and so is one without its last row.
            doubled->edit("level-a.csv", "id,kind", "id,sort");
            CHECK(doubled->shell(language.level("A")) == 2);
            const std::string cases = file_text(doubled->folder.path() / "cases.csv");
            doubled->folder.write("cases.csv",
                                  cases.substr(0, cases.rfind('\n', cases.size() - 2) + 1));
            CHECK(doubled->shell(language.level("B")) == 2);
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

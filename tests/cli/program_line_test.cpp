// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <mpfr.h>

using namespace edgeproof::test;

namespace {

const std::string hertz_scene = "profile = { kind = 'power-law', m = '1', C = '1' }\n"
                                "load = { a = '1', contact_modulus = '1' }\n"
                                "ask = { u = ['0.1'] }\n";

bool names_program(const std::string& text) { return has(text, program_line()); }

} // namespace

TEST_CASE("--version: the name and version alone on a line, then commit and libraries") {
    const auto out = edgeproof::test::lines(run(Folder(), "--version").out);
    REQUIRE(out.size() >= 2);
    CHECK(out[0] == "edgeproof " + std::string(program_version));
    // The libraries' own headers and calls give their versions.
    CHECK(has(out.back(), std::string("MPFR ") + mpfr_get_version()));
    for (const char* library : {"FLINT ", "Boost "}) {
        CHECK(has(out.back(), library));
    }
    const std::string commit = "commit " + std::string(program_commit);
    CHECK((program_commit.empty() ? out.size() == 2 : out.size() == 3 && out[1] == commit));
}

TEST_CASE("every file names the program, its commit and its libraries") {
    const Folder folder;
    folder.write("s.toml", hertz_scene);
    for (const char* format : {"csv", "json", "md"}) {
        CAPTURE(std::string(format));
        const Outcome o =
            run(folder, std::string("pressure s.toml --format ") + format + " --out t." + format);
        CHECK(o.code == 0);
        CHECK(names_program(file_text(folder.path() / (std::string("t.") + format))));
    }
    CHECK(run(folder, "expand s.toml --format tex --out t.tex").code == 0);
    CHECK(names_program(file_text(folder.path() / "t.tex")));

    folder.write("own.toml", hertz_head + hertz_right);
    REQUIRE(run(folder, "verify own.toml --out out --digits 20").code == 0);
    const std::filesystem::path out = folder.path() / "out";
    for (const char* file : {"verdicts.md", "verdicts.tex", "report.html"}) {
        CAPTURE(std::string(file));
        CHECK(names_program(file_text(out / file)));
    }
    const auto json = nlohmann::json::parse(file_text(out / "verdicts.json"));
    CHECK(json.at("program") == program_line());
    // The program is a column, so that programs that read the columns by name still work.
    const io::Csv csv = io::parse_csv(file_text(out / "verdicts.csv"), "verdicts.csv");
    CHECK(csv.notes.empty());
    CHECK(csv.header.cells.back() == "program");
    REQUIRE(csv.rows.size() == 1);
    CHECK(csv.rows[0].cells.back() == program_line());

    folder.write("a.csv", "id,kind,m,C,a,contact_modulus,quantity,edge,u,value\n"
                          "one,power-law,1,1,1,1,p,right,0.2,0.3\n");
    const Outcome checked = run(folder, "check a.csv --digits 6 --junit j.xml");
    CHECK(checked.code == 0);
    CHECK(names_program(checked.out));
    CHECK(names_program(file_text(folder.path() / "j.xml")));
}

TEST_CASE("files that are compared with a run name no program: recorded verdicts") {
    const Folder folder;
    folder.write("own.toml", hertz_head + hertz_right);
    REQUIRE(run(folder, "verify own.toml --record --digits 20").code == 0);
    CHECK(file_text(folder.path() / "own.expected.csv") ==
          "id,verdict,correct\nright,confirmed,\n");
}

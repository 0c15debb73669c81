// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include <sys/stat.h>

using namespace edgeproof::test;

namespace {

const std::string& head = hertz_head;
const std::string& right = hertz_right;
const std::string& wrong = hertz_wrong;

} // namespace

TEST_CASE("verify: the table, the files, and the JSON that other programs read") {
    const Folder folder;
    folder.write("own.toml", head + right + wrong);
    const Outcome o = run(folder, "verify own.toml --out out");
    CHECK(o.code == 0); // there are no recorded verdicts
    CHECK(o.err.empty());
    for (const char* file :
         {"verdicts.json", "verdicts.csv", "verdicts.md", "verdicts.tex", "report.html"}) {
        CAPTURE(file);
        CHECK(std::filesystem::file_size(folder.path() / "out" / file) > 0);
    }
    const auto json = nlohmann::json::parse(file_text(folder.path() / "out/verdicts.json"));
    CHECK(json.at("ledger") == "own");
    CHECK(json.at("digits") == 50);
    const auto& claims = json.at("claims");
    REQUIRE(claims.size() == 2);
    CHECK(claims[0].at("id") == "right");
    CHECK(claims[0].at("verdict") == "confirmed");
    CHECK(claims[0].at("correct").is_null());
    CHECK(claims[0].at("quoted").is_null());
    CHECK(claims[0].at("computed").is_null());
    CHECK(claims[1].at("verdict") == "refuted");
    CHECK(claims[1].at("printed") == "Es*C/3*sqrt(a^2-x^2)");
    CHECK(claims[1].at("correct") == "Es*C/2*sqrt(a^2 - x^2)");
    CHECK(claims[1].at("evidence").at("ratio") == "2/3");
    CHECK(file_text(folder.path() / "out/report.html").find("id=\"erratum-wrong\"") !=
          std::string::npos);
}

TEST_CASE("verify: a bad list of figures is refused before the audit, with its place") {
    const Folder folder;
    folder.write("own.toml", head + right);
    std::filesystem::create_directory(folder.path() / "figures");
    folder.write("figures/tilted.toml",
                 "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\n[load]\nP = \"1\"\n"
                 "M = \"-0.1\"\ncontact_modulus = \"100\"\n");
    const std::string figure = "[[figure]]\nid = \"f\"\ntitle = \"\"\ncaption = \"\"\n";
    for (const auto& row :
         {std::pair{figure + "panel = \"error\"\nscenes = []\n", "figures/own.toml:5: there is no"},
          {figure + "panel = \"errors\"\nscenes = [\"none.toml\"]\n", "figures/none.toml: "},
          {figure + "panel = \"errors\"\nscenes = []\n" + figure +
               "panel = \"errors\"\nscenes = []\n",
           "figures/own.toml:8: f is there twice"},
          {std::string("residuals = [\"tilted.toml\"]\n"),
           "figures/tilted.toml:5: the tilt of this scene is not given"}}) {
        const std::string& text = row.first;
        CAPTURE(text);
        folder.write("figures/own.toml", text);
        const Outcome o = run(folder, "verify own.toml --out out");
        CHECK(o.code == 2);
        CHECK_MESSAGE(o.err.starts_with(row.second), o.err);
        CHECK(std::ranges::count(o.err, '\n') == 1);
        CHECK_FALSE(std::filesystem::exists(folder.path() / "out"));
    }
}

TEST_CASE("verify: exit 0 if the verdicts are those recorded, 1 if they differ") {
    const Folder folder;
    folder.write("own.toml", head + right);
    REQUIRE(run(folder, "verify own.toml --record").code == 0);
    CHECK(run(folder, "verify own.toml").code == 0);
    folder.write("own.toml", head + hertz_claim("right", "Es*C/3*sqrt(a^2-x^2)"));
    const Outcome changed = run(folder, "verify own.toml");
    CHECK(changed.code == 1);
    CHECK(changed.out.find("differs from the record: own.expected.csv:2: row right has verdict "
                           "confirmed, made anew refuted\n") != std::string::npos);
    folder.write("own.toml", head + right + hertz_claim("new", "Es*C/2*sqrt(a^2-x^2)"));
    CHECK(run(folder, "verify own.toml").code == 1); // a claim has no recorded verdict
}

TEST_CASE("verify: a record that cannot be compared is refused; exit 2") {
    const Folder folder;
    folder.write("own.toml", head + right);
    const std::filesystem::path record = folder.path() / "own.expected.csv";
    for (const char* rows :
         {"right,refuted,\nright,confirmed,\n", // the last row would hide the first
          "other,proved,\nother,proved,\nright,confirmed,\n"}) {
        folder.write("own.expected.csv", std::string("id,verdict,correct\n") + rows);
        const Outcome twice = run(folder, "verify own.toml --only right");
        CHECK(twice.code == 2);
        CHECK(has(twice.err, "own.expected.csv:3: a second row of "));
    }
    std::filesystem::remove(record);
    std::filesystem::create_symlink("none", record);
    const Outcome dangling = run(folder, "verify own.toml");
    CHECK(dangling.code == 2);
    CHECK(has(dangling.err, "own.expected.csv: this is a link to a file that is not there; "));
    std::filesystem::remove(record);
    REQUIRE(::mkfifo(record.c_str(), 0600) == 0);
    const Outcome pipe = run(folder, "verify own.toml");
    CHECK(pipe.code == 2);
    CHECK(has(pipe.err, "own.expected.csv: this is a named pipe, not a file; "));
}

TEST_CASE("verify: the verdict itself says where it rests on samples") {
    const Folder folder;
    folder.write("own.toml",
                 head + right + wrong +
                     "[[claim]]\nid = \"figure\"\nkind = \"compare\"\nover = \"hertz\"\n"
                     "of = \"u/L*0 + 1/3\"\nquoted = \"0.333\"\n");
    const Outcome o = run(folder, "verify own.toml --out out");
    CHECK(has(o.out, "\nright   confirmed at the samples  agrees at "));
    CHECK(has(o.out, "\nwrong   refuted                   "));
    CHECK(has(o.out, "\nfigure  confirmed                 "));
    CHECK(has(file_text(folder.path() / "out/verdicts.md"), "| confirmed at the samples |"));
    CHECK(has(file_text(folder.path() / "out/verdicts.tex"), "& confirmed at the samples &"));
    CHECK(has(file_text(folder.path() / "out/report.html"), ">confirmed at the samples</span>"));
}

TEST_CASE("verify: a claim that cannot be read is named, the others are judged; exit 2") {
    const Folder folder;
    const std::string good = hertz_claim("good", "Es*C/2*sqrt(a^2-x^2)");
    folder.write("own.toml", head + good + hertz_claim("unknown", "Es*K") + wrong +
                                 hertz_claim("key", "Es", "quotd = \"1\"\n") + good +
                                 hertz_claim("cut", "Es*(C/2"));
    for (const char* command : {"verify own.toml --out out", "check --ledger own.toml"}) {
        CAPTURE(std::string(command));
        const Outcome o = run(folder, command);
        CHECK(o.code == 2);
        CHECK(o.out.find("good") != std::string::npos);
        CHECK(o.out.find("refuted") != std::string::npos);
        const std::vector<std::string> all = lines(o.err);
        REQUIRE(all.size() == 4);
        for (const std::string& line : all) {
            CAPTURE(line);
            CHECK(line.starts_with("own.toml:"));
            CHECK(line.find("; ") != std::string::npos);
        }
        CHECK(all[0].find("unknown name 'K'") != std::string::npos);
        CHECK(all[2].find("the id good is given twice") != std::string::npos);
    }
    const auto json = nlohmann::json::parse(file_text(folder.path() / "out/verdicts.json"));
    CHECK(json.at("claims").size() == 2);
    REQUIRE(json.at("errors").size() == 4);
    CHECK(json.at("errors")[0].at("id") == "unknown");
    CHECK(json.at("errors")[0].at("line") == 30);
    CHECK(run(folder, "verify own.toml --only good").code == 2);  // the id occurs twice
    CHECK(run(folder, "verify own.toml --only wrong").code == 0); // no error in the selection
    CHECK(run(folder, "verify own.toml --record").code == 2);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "own.expected.csv"));
}

TEST_CASE("verify --strict: 1 where a claim does not hold, recorded or not") {
    const Folder folder;
    folder.write("own.toml", head + right);
    CHECK(run(folder, "verify own.toml --strict").code == 0);
    folder.write("own.toml", head + right + wrong);
    CHECK(run(folder, "verify own.toml").code == 0);
    CHECK(run(folder, "verify own.toml --strict").code == 1);
    CHECK(run(folder, "verify own.toml --strict --only right").code == 0);
    CHECK(run(folder, "verify own.toml --record").code == 0);
    CHECK(run(folder, "verify own.toml").code == 0);
    CHECK(run(folder, "verify own.toml --strict").code == 1);
}

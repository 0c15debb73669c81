// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/report/well_formed.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

using namespace edgeproof::test;

namespace {

const std::string compared_scene =
    "[units]\nlength = \"mm\"\nforce = \"N\"\npressure = \"MPa\"\n[profile]\n"
    "kind = \"hertz\"\nR = \"2\"\n[load]\nwidth = \"3\"\ncontact_modulus = "
    "\"3\"\n";

/// p = E*/(2R) sqrt(a^2 - x^2) with a = 3/2, E* = 3, R = 2 (Johnson, eq. 4.45), times `factor`.
std::string compared_rows(int n, double factor = 1) {
    std::string text = "x,p\n";
    for (int i = 0; i <= n; ++i) {
        const double x = -2 + 4.0 * i / n;
        const double p = std::abs(x) < 1.5 ? factor * 0.75 * std::sqrt(2.25 - x * x) : 0;
        char row[80];
        std::snprintf(row, sizeof row, "%.17g,%.17g\n", x, p);
        text += row;
    }
    return text;
}

struct ComparedFiles {
    Folder folder;
    ComparedFiles() {
        folder.write("scene.toml", compared_scene);
        folder.write("right.csv", compared_rows(64));
        folder.write("wrong.csv", compared_rows(64, 1.1));
    }
};

} // namespace

TEST_CASE("compare: right numbers pass, wrong ones fail, bad input is told") {
    const ComparedFiles c;
    const Outcome right =
        run(c.folder, "compare scene.toml right.csv --tolerance 1e-9 --tolerance-a "
                      "1e-6 --tolerance-P 1e-9 --tolerance-c0 1e-3");
    CHECK(right.code == 0);
    CHECK(right.err.empty());
    CHECK(lines(right.out).back() == "pass: 1 file");
    CHECK(has(right.out, "largest p [MPa]"));
    CHECK(has(right.out, "lengths in mm, P in N/mm, M in N, pressures in MPa"));
    const Outcome wrong = run(c.folder, "compare scene.toml right.csv wrong.csv");
    CHECK(wrong.code == 1);
    CHECK(lines(wrong.out).back() == "FAIL: 1 of 2 files");
    CHECK(has(wrong.out, "FAIL: the error of p, 10 % of the peak, is more than 3 %: line 34"));
    CHECK(run(c.folder, "compare scene.toml wrong.csv --tolerance 11%").code == 0);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --of local --tolerance 9%").code == 1);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --of L2 --tolerance 9%").code == 1);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --scale p=10/11").code == 2);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --scale p=0.90909090909").code == 0);

    const auto refused = [&](const std::string& arguments, const std::string& message) {
        const Outcome outcome = run(c.folder, "compare " + arguments);
        CAPTURE(arguments);
        CHECK(outcome.code == 2);
        CHECK(outcome.out.empty());
        CHECK(lines(outcome.err).size() == 1);
        CHECK_MESSAGE(has(outcome.err, message), outcome.err);
    };
    refused("scene.toml none.csv", "none.csv");
    refused("scene.toml scene.toml", "scene.toml: there is no row of two numbers");
    refused("right.csv right.csv", "right.csv:1");
    refused("scene.toml right.csv --tolerance 0", "--tolerance 0");
    refused("scene.toml right.csv --tolerance-a x", "--tolerance-a x");
    refused("scene.toml right.csv --of peek", "--of peek");
    refused("scene.toml right.csv --edge-zone 2x", "--edge-zone 2x");
    refused("scene.toml right.csv --origin left", "--origin left");
    refused("scene.toml right.csv --columns x=2", "one column is taken for two");
    c.folder.write("nan.csv", "x,p\n0,1\n1,nan\n");
    refused("scene.toml nan.csv", "nan.csv:3: the row holds 'nan'");
    c.folder.write("bad.toml", "[profile]\nkind = \"hertz\"\n");
    refused("bad.toml right.csv", "bad.toml");
}

TEST_CASE("compare: JSON, JUnit, a page and figures") {
    const ComparedFiles c;
    const Outcome outcome =
        run(c.folder, "compare scene.toml right.csv wrong.csv --json --junit j.xml "
                      "--html page.html --figures figures");
    CHECK(outcome.code == 1);
    const auto j = nlohmann::json::parse(outcome.out);
    CHECK(j["passes"] == false);
    REQUIRE(j["files"].size() == 2);
    const auto& right = j["files"][0];
    CHECK(right["file"] == "right.csv");
    CHECK(right["passes"] == true);
    CHECK(right["nodes"] == 65);
    CHECK(right["a"]["exact"].get<double>() == 1.5);
    CHECK(std::abs(right["a"]["data"].get<double>() - 1.5) < 1e-9);
    CHECK(right["errors"]["peak"].get<double>() < 1e-12);
    CHECK(right["c0"]["spread"].get<double>() > 0);
    const auto& wrong = j["files"][1];
    CHECK(wrong["passes"] == false);
    CHECK(std::abs(wrong["errors"]["local"].get<double>() - 0.1) < 1e-9);
    CHECK(std::abs(wrong["errors"]["l2"].get<double>() - 0.1) < 1e-9);
    // c_0 = p_0 sqrt(2/a), p_0 = 9/8
    CHECK(std::abs(wrong["c0"]["exact"].get<double>() - 1.125 * std::sqrt(2 / 1.5)) < 1e-12);
    CHECK(std::abs(wrong["c0"]["data"].get<double>() / wrong["c0"]["exact"].get<double>() - 1.1) <
          1e-3);
    CHECK(j["orders"].contains("a"));
    CHECK(well_formed(file_text(c.folder.path() / "j.xml")) == "");
    CHECK(has(file_text(c.folder.path() / "j.xml"), "failures=\"1\""));
    const std::string page = file_text(c.folder.path() / "page.html");
    CHECK(has(page, "<h2>wrong.csv</h2>"));
    CHECK(has(page, "</html>"));
    if (std::system("gnuplot --version >/dev/null 2>&1") == 0) {
        for (const char* name : {"right-pressure", "right-error", "wrong-error", "convergence"}) {
            const auto file = c.folder.path() / "figures" / (std::string(name) + ".svg");
            CAPTURE(file.string());
            CHECK(has(file_text(file), "</svg>"));
        }
        CHECK(has(page, "<svg"));
    }
}

TEST_CASE("compare: the table of the self-test in the documentation is what it prints" *
          doctest::test_suite("slow")) {
    const std::string doc = file_text(source_dir() / "docs" / "compare.md");
    const Outcome outcome = run(Folder(), "compare --self-test");
    CHECK(outcome.code == 0);
    CHECK(has(outcome.out, "0 wrongly named"));
    CHECK_MESSAGE(has(doc, outcome.out), outcome.out);
}

TEST_CASE("compare: the example of the documentation is what the program prints") {
    const std::string doc = file_text(source_dir() / "docs" / "compare.md");
    const Folder folder;
    std::filesystem::copy(source_dir() / "examples", folder.path() / "examples",
                          std::filesystem::copy_options::recursive);
    std::size_t commands = 0;
    for (const std::string& line : lines(doc)) {
        const std::string start = "    edgeproof compare examples/";
        if (!line.starts_with(start)) {
            continue;
        }
        ++commands;
        const Outcome outcome = run(folder, line.substr(std::string("    edgeproof ").size()));
        for (const std::string& printed : lines(outcome.out)) {
            CHECK_MESSAGE(has(doc, printed), printed);
        }
    }
    CHECK(commands >= 2);
}

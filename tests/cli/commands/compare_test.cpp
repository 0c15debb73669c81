// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/run_program.hpp"
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

/// Rows of p = E*/(2R) sqrt(a^2 - x^2) with a = 3/2, E* = 3, R = 2 (Johnson, eq. 4.45), times
/// `factor`.
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

TEST_CASE("compare: right numbers pass, wrong ones fail") {
    const ComparedFiles c;
    const Outcome right =
        run(c.folder, "compare scene.toml right.csv --tolerance p=1e-9,a=1e-6 --tolerance-P 1e-9 "
                      "--tolerance-c0 1e-3");
    CHECK(right.code == 0);
    CHECK(right.err.empty());
    CHECK(lines(right.out).back() == "pass: 1 file");
    CHECK(has(right.out, "largest p [MPa]"));
    CHECK(has(right.out, "lengths in mm, P in N/mm, M in N, pressures in MPa"));
    CHECK(has(right.out, "P [N/mm]"));
    // The force of a ball is a whole one.
    std::string ball = compared_scene;
    ball.insert(ball.find("kind ="), "geometry = \"axisymmetric\"\n");
    c.folder.write("ball.toml", ball);
    CHECK(has(run(c.folder, "compare ball.toml right.csv").out, "P [N]"));
    const Outcome wrong = run(c.folder, "compare scene.toml right.csv wrong.csv");
    CHECK(wrong.code == 1);
    CHECK(lines(wrong.out).back() == "FAIL: 1 of 2 files");
    CHECK(has(wrong.out, "FAIL: the error of p, 10 % of the peak, is more than 3 %: line 34"));
    CHECK(run(c.folder, "compare scene.toml wrong.csv --tolerance 11%").code == 0);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --of local --tolerance 9%").code == 1);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --of L2 --tolerance 9%").code == 1);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --scale p=10/11").code == 2);
    CHECK(run(c.folder, "compare scene.toml wrong.csv --scale p=0.90909090909").code == 0);

    CHECK(run(c.folder, "compare scene.toml right.csv --edge-zone 1.4").code == 0);
    c.folder.write("three.csv", "x,p\n-3,0\n-1,0.83853\n0,1.125\n1,0.83853\n3,0\n");
    const Outcome three = run(c.folder, "compare scene.toml three.csv");
    CHECK(three.code == 1); // by the trapezoidal rule P is 3.64 instead of 2.65
    CHECK(has(three.out, "FAIL: P is not determined: "));
    CHECK(run(c.folder, "compare scene.toml three.csv --partial").code == 0);
    CHECK(run(c.folder, "compare scene.toml three.csv --partial --tolerance-P 1%").code == 1);
    c.folder.write("wide.csv", "x,p\n-3,1\n-1,0.83853\n0,1.125\n1,0.83853\n3,1\n");
    CHECK(run(c.folder, "compare scene.toml wide.csv").code == 1);
}

TEST_CASE("compare: a fitted origin passes only if the user requests it") {
    const ComparedFiles c;
    for (const double part : {0.018, 0.02, 0.05, 0.1, 0.3, -0.05}) {
        CAPTURE(part);
        std::string shifted = "x,p\n";
        for (int i = 0; i <= 96; ++i) {
            const double x = -3 + 6.0 * i / 96;
            char row[80];
            std::snprintf(row, sizeof row, "%.17g,%.17g\n", x + 3 * part,
                          std::abs(x) < 1.5 ? 0.75 * std::sqrt(2.25 - x * x) : 0);
            shifted += row;
        }
        c.folder.write("shifted.csv", shifted);
        const Outcome outcome = run(c.folder, "compare scene.toml shifted.csv --json");
        CHECK(outcome.code == 1);
        const auto file = nlohmann::json::parse(outcome.out)["files"][0];
        CHECK(file["passes"] == false);
        CHECK(file["origin"] == 0.0);
        CHECK(file["origin_found"] == false);
        REQUIRE(file["causes"].size() >= 1);
        CHECK(file["causes"][0]["name"] == "shifted-origin");
        char shift[80];
        std::snprintf(shift, sizeof shift, "x is shifted by %.4g: ", 3 * part);
        CHECK_MESSAGE(has(file["causes"][0]["what"].get<std::string>(), shift), file["causes"]);
        char origin[80];
        std::snprintf(origin, sizeof origin, " --origin %.17g", 3 * part);
        CHECK(run(c.folder, "compare scene.toml shifted.csv --tolerance 1e-6" + std::string(origin))
                  .code == 0);
        if (std::abs(part) >= 0.02) { // smaller shifts remain an error with a fitted origin
            CHECK(run(c.folder, "compare scene.toml shifted.csv --origin auto").code == 0);
        }
    }
}

TEST_CASE("compare: JSON") {
    const ComparedFiles c;
    const Outcome outcome = run(c.folder, "compare scene.toml right.csv wrong.csv --json");
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
    CHECK(j["routes"]["p"] == "in closed form");
}

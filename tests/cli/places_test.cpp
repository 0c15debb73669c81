// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace edgeproof::test;

namespace {

/// g' = x and E* = 1, so that p = sqrt(a^2 - x^2)/2 and P = pi a^2/4.
const std::string cylinder = "[profile]\nkind = \"hertz\"\nR = 1\n";
const std::string by_force = "[load]\nP = 1\ncontact_modulus = 1\n";
const std::string by_edge = "[load]\na = 1\ncontact_modulus = 1\n";
const std::string wedge = "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0\"\n";

nlohmann::json pressures(const std::string& scene, const std::string& options = "") {
    const Folder folder;
    folder.write("s.toml", scene);
    const Outcome o = run(folder, "pressure s.toml --format json " + options);
    CAPTURE(o.err);
    REQUIRE(o.code == 0);
    return nlohmann::json::parse(o.out);
}

std::string refused(const std::string& scene) {
    const Folder folder;
    folder.write("s.toml", scene);
    const Outcome o = run(folder, "pressure s.toml --out result.csv");
    CHECK(o.code == 2);
    CHECK(folder.files() == 1);
    const auto said = lines(o.err);
    return said.size() == 1 ? said[0] : "not one line: " + o.err;
}

} // namespace

// a = 2/sqrt(pi): p(a/2) = a sqrt(3)/4 = sqrt(3/(4 pi)), p(0) = a/2 = 1/sqrt(pi). Both constants
// are tabulated (OEIS A244979, A087197).
TEST_CASE("places by the names of a scene, where a is solved for") {
    const auto json = pressures(cylinder + by_force +
                                "[ask]\nu = [\"a/2\", \"50%\", \"a\", \"0.75*b + a/4\", \"R/10\"]\n"
                                "x = [\"a/2\", \"-b/2\", 0]\n");
    const auto& rows = json["rows"];
    REQUIRE(rows.size() == 8);
    const std::string half = "0.48860251190291992158638462283834700457588560819423";
    const std::string middle = "0.56418958354775628694807945156077258584405062932900";
    const char* const asked[] = {"a/2",  "50%",     "a",        "0.75*b + a/4",
                                 "R/10", "x = a/2", "x = -b/2", "x = 0"};
    const std::string* const values[] = {&half,   &middle, &middle, &middle,
                                         nullptr, &half,   &half,   &middle};
    for (std::size_t i = 0; i < 8; ++i) {
        CAPTURE(i);
        if (values[i] == nullptr) {
            CHECK(rows[i]["u"] == "0.1"); // a number, not a name
            continue;
        }
        CHECK(rows[i]["asked"] == asked[i]);
        CHECK(rows[i]["p"] == *values[i]);
        CHECK(rows[i]["route"] == "closed-form");
        CHECK(std::stod(rows[i]["p_bound"].get<std::string>()) <= 1e-50);
    }
    CHECK(rows[0]["u"] == "0.56418958354775628694807945156077258584405062932900"); // a/2
    CHECK(rows[2]["x"] == "0");
}

TEST_CASE("where a is given, the names are numbers") {
    const auto json =
        pressures(cylinder + by_edge + "[ask]\nu = [\"2/5\", \"a/5\", \"10%\"]\nx = \"3/5\"\n");
    REQUIRE(json["rows"].size() == 4);
    const char* const p[] = {"0.4", "0.3", "0.3", "0.4"}; // 3-4-5 triangle
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        CHECK(json["rows"][i]["p"].get<std::string>().rfind(p[i], 0) == 0);
        CHECK(json["rows"][i]["p"].get<std::string>().find_first_not_of('0', 3) ==
              std::string::npos);
    }
    CHECK(json["rows"][3]["u"] == "0.4");
}

TEST_CASE("a place x is the same place, measured from either edge") {
    const auto json = pressures(cylinder + by_force + "[ask]\nedges = [\"right\", \"left\"]\n" +
                                "x = [\"a/3\", \"1/10\"]\nterms = 1\n");
    REQUIRE(json["rows"].size() == 4);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(json["rows"][i]["p"] == json["rows"][i + 2]["p"]);
        CHECK(json["rows"][i]["x"] == json["rows"][i + 2]["x"]);
        CHECK(json["rows"][i]["local_1"] != json["rows"][i + 2]["local_1"]);
    }
}

TEST_CASE("the estimated routes state that the place is known to the digits of a") {
    const auto json = pressures(cylinder + by_force +
                                "[ask]\nu = \"a/2\"\ndigits = 20\nroute = \"singular-integral\"\n");
    const auto& row = json["rows"][0];
    CHECK(row["p"].get<std::string>().rfind("0.4886025119029199", 0) == 0);
    CHECK(has(row["route"].get<std::string>(), "(estimate)"));
    CHECK(std::stod(row["p_bound"].get<std::string>()) > 0);
}

TEST_CASE("places that do not exist: an error in one line") {
    const auto ask = [](const std::string& what) { return "[ask]\n" + what + "\n"; };
    const std::string given = cylinder + by_force;
    const std::pair<std::string, const char*> all[] = {
        {given + ask("u = \"3*a\""),
         "s.toml:8: u = 3*a from the right edge: the point lies outside"},
        {given + ask("u = \"a - b\""), "s.toml:8: u = a - b from the right edge: the point is on"},
        {given + ask("x = \"a\""), "s.toml:8: x = a: the point is on an edge"},
        {given + ask("u = [\"0.1\",\n\"c/2\"]"), "s.toml:9: u = \"c/2\": "},
        {given + ask("u = \"a/0\""), "s.toml:8: "},
        {given + ask("x = \"50%\""), "s.toml:8: x = \"50%\": a percentage is of the length a + b"},
        {given + ask("u = \"-10%\""), "s.toml:8: u = -10% from the right edge: the point lies"},
        {given + ask("u = \"%\""), "s.toml:8: u = \"%\": "},
        {given + ask("u = { from = \"a/10\", to = \"a\", points = 3 }"),
         "s.toml:8: from = a/10 is not a number: it depends on a and b, which are unknown"},
        {given + ask("x = { from = 0, to = 1 }"), "s.toml:8: a range of x needs points"},
        {wedge + by_force + ask("u = \"a\""),
         "s.toml:9: u = a from the right edge: the point is on a corner"},
        {wedge + by_force + ask("x = 0"), "s.toml:9: x = 0: the point is on a corner"},
        {wedge + by_force + ask("u = \"50%\""),
         "s.toml:9: u = 50% from the right edge: the point is on a corner"},
    };
    for (const auto& [text, line] : all) {
        const std::string scene = text; // clang's lambda in CAPTURE takes no structured binding
        CAPTURE(scene);
        const std::string said = refused(scene);
        CAPTURE(said);
        CHECK(said.rfind(line, 0) == 0);
    }
}

// For g' = x^3, E* = a = 1: p = sqrt(1 - x^2)(1 + 2 x^2)/4, with the maximum sqrt(2)/4 at x^2 =
// 1/2.
TEST_CASE("the greatest pressure, by its name") {
    const auto hertz = pressures(cylinder + by_force + "[ask]\nquantities = [\"peak\"]\n");
    CHECK(hertz["p_max"]["value"] == "0.56418958354775628694807945156077258584405062932900");
    CHECK(hertz["p_max"]["route"] == "at the origin");
    REQUIRE(hertz["rows"].size() == 3); // p_max, a, b
    CHECK(std::ranges::any_of(hertz["rows"], [&](const auto& row) {
        return row["quantity"] == "p_max" && row["value"] == hertz["p_max"]["value"];
    }));
    const auto cubic =
        pressures("[profile]\nkind = \"power-law\"\nm = 3\nC = 1\n" + by_edge, "--quantity peak");
    CHECK(cubic["p_max"]["value"] == "0.35355339059327376220042218105242451964241796884424");
    CHECK(cubic["p_max"]["route"] == "branch and bound");
    CHECK(has(refused(wedge + by_edge + "[ask]\nquantities = [\"peak\"]\n"),
              "there is no greatest pressure: it is infinite at the corner x = 0"));
}

TEST_CASE("the greatest pressure is reached, and no pressure is greater") {
    for (const char* profile :
         {"[profile]\nkind = \"flat-and-rounded\"\nt = \"0.6\"\nR = 1\n",
          "[profile]\nkind = \"tilted-flat-and-rounded\"\nalpha = \"0.1\"\nt = \"0.4\"\nR = 1\n"}) {
        CAPTURE(profile);
        const auto json = pressures(std::string(profile) + "[load]\na = 1\ncontact_modulus = 1\n" +
                                        "[ask]\nu = { from = \"1/1000\", to = \"13/10\", points = "
                                        "1300 }\nquantities = [\"pressure\", \"peak\"]\n",
                                    "--digits 15");
        const double peak = std::stod(json["p_max"]["value"].get<std::string>());
        CHECK(std::stod(json["p_max"]["bound"].get<std::string>()) < 1e-14);
        double most = 0;
        for (const auto& row : json["rows"]) {
            most = std::fmax(most, std::stod(row["p"].get<std::string>()));
        }
        CHECK(most <= peak);
        CHECK(most > peak * (1 - 1e-4)); // the places are 1/1000 apart
    }
}

// P = pi/4, Q = 3/4 f P: c = 1/2, and |q|/(f p) = 1 - sqrt(c^2 - x^2)/sqrt(1 - x^2) in the stick
// zone (Cattaneo, Mindlin).
TEST_CASE("stick check: the fraction of the friction that is used") {
    const auto json = pressures(cylinder + by_edge +
                                "[shear]\nQ = \"9*pi/80\"\nfriction = \"0.6\"\n"
                                "[ask]\nx = [\"0\", \"1/4\", \"3/4\"]\ndigits = 18\n");
    REQUIRE(json["rows"].size() == 3);
    CHECK(json["rows"][0]["q_over_fp"] == "0.500000000000000000");
    CHECK(json["rows"][1]["q_over_fp"] == "0.552786404500042061"); // 1 - sqrt(1/5)
    CHECK(json["rows"][2]["q_over_fp"] == "1.00000000000000000");
    CHECK(json["rows"][1]["state"] == "stick");
    CHECK(json["rows"][2]["state"] == "slip");
    bool said = false;
    for (const auto& note : json["notes"]) {
        said = said || has(note.get<std::string>(), "the contact slips outside -stick_b < x");
        CHECK_FALSE(has(note.get<std::string>(), "warning")); // the state is the right one
    }
    CHECK(said);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace edgeproof::test;

namespace {

const std::string flat_scene = "[profile]\nkind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"1\"\n"
                               "[load]\na = \"1\"\ncontact_modulus = \"1\"\n"
                               "[ask]\nu = [\"1e-3\", \"0.1\", \"0.5\"]\n";

} // namespace

TEST_CASE("cost: a scene's own points, in JSON, each with its digits, evaluations and time") {
    const Folder folder;
    folder.write("pad.toml", flat_scene);
    const Outcome o = run(folder, "cost pad.toml --digits 16,30 --points 2 --json");
    CAPTURE(o.err);
    REQUIRE(o.code == 0);
    const auto json = nlohmann::json::parse(o.out);
    std::size_t rule = 0;
    for (const auto& p : json["points"]) {
        CHECK(p["contact"] == "pad");
        CHECK((p["u"] == "1e-3" || p["u"] == "0.5"));
        CHECK(p["seconds"].get<double>() > 0);
        if (p["route"] == "fast Gauss-Legendre" && p["digits"] == 30) {
            ++rule;
            CHECK(p["right"].get<double>() > 29);
            CHECK(p["evaluations"].get<int>() > 10);
        }
    }
    CHECK(rule == 2);
    CHECK(json["growth"].size() >= 4);
    CHECK(json["bounds"].size() == 2);
    CHECK(json["machine"].contains("MPFR"));
}

TEST_CASE("cost: tables, and a page with its data in files next to it") {
    const Folder folder;
    folder.write("pad.toml", flat_scene);
    const Outcome o = run(folder, "cost pad.toml --digits 16,20 --points 1 --out here");
    CHECK(o.code == 0);
    CHECK(o.out.rfind("What a value costs: pad\n", 0) == 0);
    for (const char* text : {"\nGrowth with the digits\n", "\nWhat a proof costs\n",
                             "\nedgeproof 0", "fast Gauss-Legendre  MPFR"}) {
        CHECK(o.out.find(text) != std::string::npos);
    }
    const auto at = folder.path() / "here";
    const std::string page = file_text(at / "cost.html");
    CHECK(page.find("<h2 id=\"first-title\">What a value costs: pad</h2>") != std::string::npos);
    CHECK(page.find("{{") == std::string::npos);
    CHECK(file_text(at / "points.csv").find("pad,fast Gauss-Legendre,MPFR,20,1e-3,") !=
          std::string::npos);
    CHECK(lines(file_text(at / "figures" / "work-precision-time.csv")).size() > 8);
    CHECK(nlohmann::json::accept(file_text(at / "cost.json")));
}

TEST_CASE("cost: bad input is one line") {
    const Folder folder;
    folder.write("pad.toml", flat_scene);
    folder.write("moment.toml", "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\n[load]\n"
                                "P = \"1\"\nM = \"0.1\"\ncontact_modulus = \"1\"\n");
    folder.write("outside.toml", flat_scene.substr(0, flat_scene.find("u =")) + "u = [\"5\"]\n");
    for (const char* bad :
         {"cost pad.toml --digits 16,x", "cost pad.toml --digits 1", "cost pad.toml --points 0",
          "cost nothing.toml", "cost moment.toml", "cost outside.toml --digits 16"}) {
        const Outcome o = run(folder, bad);
        CAPTURE(bad);
        CHECK(o.code == 2);
        CHECK(lines(o.err).size() == 1);
        CHECK(o.out.empty());
    }
    CHECK(run(folder, "cost moment.toml").err.rfind("moment.toml:", 0) == 0);
}

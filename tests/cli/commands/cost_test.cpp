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
        if (p["route"] == "singular integral" && p["digits"] == 30) {
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

TEST_CASE("cost: points outside the contact are refused in one line") {
    const Folder folder;
    folder.write("outside.toml", flat_scene.substr(0, flat_scene.find("u =")) + "u = [\"5\"]\n");
    const Outcome o = run(folder, "cost outside.toml --digits 16");
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(lines(o.err).size() == 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace edgeproof::test;

namespace {

const std::string slipping_hertz = "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\n"
                                   "a = \"1\"\ncontact_modulus = \"1\"\n[shear]\n"
                                   "Q = \"9*pi/80\"\nfriction = \"0.6\"\n";

std::string first_row(const std::string& csv) {
    for (const std::string& line : lines(csv)) {
        if (line.rfind('#', 0) != 0) {
            return line;
        }
    }
    return {};
}

} // namespace

// P = pi/4, so that tau = 3/4: d = a/2, d_1 = 3/8, d_2 = 3/8 + 9/128, and one term is within 1 % up
// to tau = 4 (0.01 - 0.0001).
TEST_CASE("slip: Hertz by hand") {
    const Folder folder;
    folder.write("s.toml", slipping_hertz);
    const Outcome o = run(folder, "slip s.toml --digits 12 --terms 1,2 --tolerance 1%");
    CHECK(o.code == 0);
    CHECK(o.err.empty());
    CHECK(first_row(o.out) == "edge,d,d_bound,route,d_1,rel_1,d_2,rel_2,slip_load_1,"
                              "slip_load_1_bound,slip_load_1_route,slip_load_2,slip_load_2_bound,"
                              "slip_load_2_route");
    const auto json = nlohmann::json::parse(
        run(folder, "slip s.toml --digits 12 --terms 1,2 --tolerance 1% --format json").out);
    REQUIRE(json["rows"].size() == 2);
    for (const auto& row : json["rows"]) {
        CHECK(row["d"] == "0.500000000000");
        CHECK(row["route"] == "stick zone");
        CHECK(row["d_1"] == "0.375000000000");
        CHECK(row["rel_1"] == "0.250000000000");
        CHECK(row["d_2"] == "0.445312500000");
        CHECK(row["rel_2"] == "0.109375000000");
        CHECK(row["slip_load_1"] == "0.0396000000000");
        CHECK(row["slip_load_1_route"] == "sign changes");
    }
    CHECK(json["Q/(f P)"]["value"] == "0.750000000000");
    CHECK(json["stick_a"]["value"] == "0.500000000000");
    // Slip times traction by mpmath: 16 f/pi times the integral over Q and over the slip zone of p
    // arcosh(x/c). A step of Q adds this to the slip if c is the edge of the stick zone (Johnson,
    // 2.7a).
    CHECK(json["cycle_energy"]["value"] == "0.0345445660097");
    folder.write("t.toml", slipping_hertz + "bulk_tension = \"1/100\"\n");
    const Outcome pulled = run(folder, "slip t.toml --digits 12");
    CHECK(pulled.code == 0);
    CHECK(pulled.out.find("cycle_energy") == std::string::npos);
    // At full sliding the error is -1/2 of d: it stays within the tolerance.
    const auto never = nlohmann::json::parse(
        run(folder, "slip s.toml --digits 12 --terms 1 --tolerance 51% --edge left --format json")
            .out);
    REQUIRE(never["rows"].size() == 1);
    CHECK(never["rows"][0]["slip_load_1"] == "1.00000000000");
    CHECK(never["rows"][0]["slip_load_1_route"] == "full sliding");
}

TEST_CASE("pressure of a scene with friction: the state behind q") {
    const Folder folder;
    folder.write("s.toml", slipping_hertz + "[ask]\nterms = 1\nu = [\"0.2\", \"1.2\"]\n");
    const Outcome o = run(folder, "pressure s.toml --digits 10");
    CHECK(o.code == 0);
    CHECK(first_row(o.out) ==
          "edge,u,x,p,p_bound,route,local_1,rel_1,q,q_bound,q_route,q_over_fp,state");
    // p = sqrt(u (2 - u))/2 = 0.3; q = 0.6 p
    CHECK(has(o.out, ",0.1800000000,"));
    CHECK(has(o.out, ",1.000000000,slip\n"));
    CHECK(has(o.out, ",stick\n"));
}

// Hertz with a = R = E* = 1 and f = 1/2: d_1 = Q/(2 f P) + sigma_0 at the right edge, less than 0
// for the first tension, while d = 1 - sqrt(1 - Q/(f P)) + sigma_0 = 0.0003.
TEST_CASE("slip: a negative size by n terms has a remark") {
    const Folder folder;
    const std::string hertz = "[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\na = \"1\"\n"
                              "contact_modulus = \"1\"\n[shear]\nQ = \"0.02\"\n"
                              "friction = \"0.5\"\nbulk_tension = ";
    folder.write("s.toml", hertz + "\"-0.0255\"\n");
    const std::string out = run(folder, "slip s.toml --digits 8 --terms 1,2").out;
    CHECK(has(out, "d_1 is negative at the right edge"));
    CHECK_FALSE(has(out, "d_2 is negative"));
    CHECK_FALSE(has(out, "at the left edge:"));
    folder.write("s.toml", hertz + "\"-0.025\"\n");
    CHECK_FALSE(has(run(folder, "slip s.toml --digits 8 --terms 1,2").out, "negative"));
}

TEST_CASE("slip: bad input") {
    const Folder folder;
    folder.write("none.toml", "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\n"
                              "a = \"1\"\ncontact_modulus = \"1\"\n[shear]\nQ = \"0.1\"\n");
    folder.write("s.toml", slipping_hertz);
    const auto refused = [&](const std::string& arguments, const std::string& line) {
        const Outcome o = run(folder, arguments);
        CHECK(o.code == 2);
        CHECK(o.out.empty());
        REQUIRE(lines(o.err).size() == 1);
        CHECK(lines(o.err)[0].rfind(line, 0) == 0);
    };
    refused("slip none.toml", "none.toml:6: the scene has no friction");
    refused("slip s.toml --tolerance 0", "edgeproof: --tolerance 0: a tolerance of 0");
    refused("slip s.toml --terms 0", "edgeproof: --terms 0 is out of range");
    refused("slip s.toml --terms 61", "s.toml:");
}

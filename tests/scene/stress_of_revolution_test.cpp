// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses inside bodies of revolution with linear pieces, compared with the superposition of flat
// punches that tests/oracles/stress_of_revolution.py integrates.
#include "edgeproof/scene/run_scene.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// The bodies of the program that wrote the values; the second one has a collinear knot, too.
const std::array<const char*, 5> superposed_bodies{
    R"(knots = ["3/10"]
slopes = ["0", "x - 3/10"])",
    R"(knots = ["1/8", "1/2"]
slopes = ["x", "3/4*x + 1/32", "3/4*x + 1/32"])",
    R"(knots = ["1/2"]
slopes = ["x", "3*x - 1"])",
    R"(knots = ["1/3", "4/5"]
slopes = ["x/2", "2*x - 1/2", "x + 3/10"])",
    R"(knots = ["9/10"]
slopes = ["0", "x - 9/10"])"};

void compare_with_superposition(std::size_t most_places) {
    std::ifstream in(test::source_dir() / "tests/oracles/stress_of_revolution.csv");
    std::string line;
    std::getline(in, line);
    std::size_t places = 0;
    for (; places < most_places && std::getline(in, line); ++places) {
        CAPTURE(line);
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) {
            cells.push_back(cell);
        }
        REQUIRE(cells.size() == 7);
        const scene::Scene s = scene::parse_scene(
            std::string("[profile]\ngeometry = \"axisymmetric\"\nkind = \"piecewise\"\n"
                        "symmetric = true\n") +
                superposed_bodies.at(std::stoul(cells[0])) +
                "\n[load]\na = \"1\"\ncontact_modulus = \"1\"\nnu = \"3/10\"\n",
            "stress.toml");
        std::vector<scene::AskedValue> asked;
        for (const scene::Quantity quantity : {scene::Quantity::sxx, scene::Quantity::szz,
                                               scene::Quantity::sxz, scene::Quantity::syy}) {
            asked.push_back({quantity});
            asked.back().in_body = {Exact::parse(cells[1]), Exact::parse(cells[2])};
        }
        scene::SceneValues values(s, asked, {12, Rounding::nearest, false});
        const Real size = abs(Real(cells[4]));
        for (std::size_t k = 0; k < asked.size(); ++k) {
            CAPTURE(k);
            const scene::BoundedValue value = values.value(asked[k]);
            CHECK(value.proved);
            const Real found = at_working_precision(value.value.midpoint());
            CHECK(abs(Real(found - Real(cells[3 + k]))) <= size * Real("1e-11"));
        }
    }
    CHECK(places == most_places);
}

} // namespace

TEST_CASE("stresses inside bodies of revolution are the superposition of flat punches") {
    compare_with_superposition(10);
}

TEST_CASE("stresses at 200 drawn places of bodies of revolution are that superposition" *
          doctest::test_suite("slow")) {
    compare_with_superposition(200);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

CostCell cell(const std::string& route, const std::string& arithmetic, unsigned digits,
              double seconds, double right, bool proves = false) {
    CostCell c{"punch", route, arithmetic, digits, proves, 0, {}};
    for (const double factor : {0.5, 1.0, 3.0}) {
        c.points.push_back({0, right, std::size_t{2} * digits, factor * seconds, 0, {}});
    }
    return c;
}

} // namespace

TEST_CASE("a power law is recovered, and too few or zero values give none") {
    std::vector<std::pair<double, double>> points;
    for (const double d : {16.0, 50.0, 100.0, 1000.0}) {
        points.emplace_back(d, 3e-6 * std::pow(d, 1.75));
    }
    const auto fit = power_law_fit(points);
    REQUIRE(fit);
    CHECK(fit->exponent == doctest::Approx(1.75));
    CHECK(fit->factor == doctest::Approx(3e-6));
    CHECK(fit->points == 4);
    CHECK_FALSE(power_law_fit({{50, 1}}));
    CHECK_FALSE(power_law_fit({{50, 1}, {50, 2}}));
    CHECK_FALSE(power_law_fit({{50, 0}, {100, 0}}));
}

TEST_CASE("growth is fitted route by route, to medians over the points") {
    const std::vector<CostCell> cells{
        cell("a", "MPFR", 50, 1e-5, 60), cell("a", "MPFR", 100, 4e-5, 110),
        cell("a", "double", 16, 1e-7, 15), cell("b", "MPFR", 50, 1e-5, 60),
        cell("b", "MPFR", 100, 1e-5, 110)};
    const auto all = growths(cells);
    REQUIRE(all.size() == 2); // one number of digits gives no growth
    CHECK(all[0].route == "a");
    CHECK(all[0].time.exponent == doctest::Approx(2));
    CHECK(all[0].ten_more() == doctest::Approx(1.44));
    CHECK(all[0].evaluations->exponent == doctest::Approx(1));
    CHECK(all[1].time.exponent == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("a proof is compared with the fastest bare route that has its digits") {
    std::vector<CostCell> cells{cell("slow", "MPFR", 50, 9e-5, 60),
                                cell("right", "MPFR", 50, 2e-5, 55),
                                cell("wrong", "MPFR", 50, 1e-6, 31),
                                cell("machine", "double", 50, 1e-7, 60),
                                cell("enclosure", "balls", 50, 6e-5, 60, true),
                                cell("rounded", "balls", 50, 8e-5, 60, true)};
    cells.push_back(cell("broken", "MPFR", 50, 1e-6, 60));
    cells.back().points.front().failure = "no value";
    const auto costs = bound_costs(cells);
    REQUIRE(costs.size() == 1);
    CHECK(costs[0].bare == "right");
    CHECK(costs[0].enclosure_seconds / costs[0].bare_seconds == doctest::Approx(3));
    CHECK(costs[0].rounded_seconds == doctest::Approx(8e-5));
}

TEST_CASE("a cell counts failed values and leaves them out of the other results") {
    CostCell c = cell("a", "MPFR", 50, 1e-5, 60);
    c.points.push_back({3, 0, {}, 0, 0, "no value"});
    CHECK(c.failed() == 1);
    CHECK(c.right().least == 60);
    CHECK(c.seconds().median == doctest::Approx(1e-5));
    CHECK(c.total_evaluations() == 300);
}

TEST_CASE("an effect adds its own operations and no others") {
    const auto costs = effect_costs(20, false, {});
    const auto counts = [&](const std::string& effect) {
        for (const EffectCost& e : costs) {
            if (e.effect == effect) {
                return e.work.counts;
            }
        }
        return Counts{};
    };
    const Counts base = counts("pressures of a symmetric punch");
    CHECK(base.closed_forms == 10);
    CHECK(base.consistency + base.load_inversions + base.tilts + base.expansions +
              base.shear_points + base.extents ==
          0);
    CHECK(counts("tilt").consistency == 1);
    CHECK(counts("tilt").closed_forms == 10);
    CHECK(counts("P given instead of a").load_inversions == 1);
    CHECK(counts("tilt found from P and M").tilts == 1);
    CHECK(counts("both edges of a tilted punch").closed_forms == 20);
    CHECK(counts("shear under full stick").shear_points == 10);
    CHECK(counts("expansion to 3 terms").expansions == 1);
    CHECK(counts("expansion to 10 terms").closed_forms == 10);
    CHECK(counts("extents of 1 and 3 terms").extents == 2);
    CHECK(counts("extents of 1 and 3 terms").closed_forms == 0);
    CHECK(counts("shear in partial slip").stick_zones == 1);
    CHECK(counts("stresses at ten points").stresses == 10);
    CHECK(counts("stresses at ten points").closed_forms == 0);
    CHECK(counts("gap at ten places").displacements == 10);
    CHECK(counts("slip at ten places").displacements == 10);
    CHECK(counts("displacements of a surface at ten places").displacements == 10);
    CHECK(counts("pressures under a sphere").closed_forms == 10);
    CHECK(counts("gap around a sphere").displacements == 10);
}

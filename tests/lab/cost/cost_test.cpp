// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/roots/power_law_fit.hpp"
#include "lab/cost/cost.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

namespace {

CostCell cell(const std::string& route, unsigned digits, double seconds) {
    CostCell c{"punch", route, "MPFR", digits, 0, {}};
    for (const double factor : {0.5, 1.0, 3.0}) {
        c.points.push_back({.right = 60, .seconds = factor * seconds});
    }
    return c;
}

constexpr double last_digit = 1;

CostCase usual(const std::string& name) {
    for (CostCase& c : usual_cases()) {
        if (c.name == name) {
            return c;
        }
    }
    throw Error("no such case: " + name);
}

std::vector<CostCell> counted(const std::vector<CostCase>& cases, std::vector<unsigned> digits,
                              std::size_t points) {
    CostOptions options;
    options.digits = std::move(digits);
    options.points = points;
    options.timed = false;
    return measure(cases, options);
}

/// Returns total evaluations by route, arithmetic and digits: "singular integral, MPFR, 50".
std::map<std::string, std::size_t> totals(const std::vector<CostCell>& cells) {
    std::map<std::string, std::size_t> all;
    for (const CostCell& c : cells) {
        for (const PointCost& p : c.points) {
            all[c.route + ", " + c.arithmetic + ", " + std::to_string(c.digits)] +=
                static_cast<std::size_t>(p.evaluations);
        }
    }
    return all;
}

/// Returns the differences in words; empty if there are none.
std::string differences(const std::map<std::string, std::size_t>& found,
                        const std::map<std::string, std::size_t>& expected) {
    std::string said;
    for (const auto& [name, count] : expected) {
        const auto at = found.find(name);
        const std::string now = at == found.end() ? "none" : std::to_string(at->second);
        if (now != std::to_string(count)) {
            said += name + ": " + now + ", expected " + std::to_string(count) + "\n";
        }
    }
    return said;
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
    const auto tables =
        cost_tables({{cell("a", 50, 1e-5), cell("a", 100, 4e-5), cell("b", 50, 1e-5),
                      cell("b", 100, 2e-5), cell("c", 50, 1e-5)},
                     {}});
    REQUIRE(tables.size() == 2);
    const std::vector<std::vector<std::string>> growth{
        {"punch", "a", "2.00", "+44 %"},
        {"punch", "b", "1.00", "+20 %"}}; // one number of digits gives no growth
    CHECK(tables.back().rows == growth);
}

TEST_CASE("a cell counts failed values and leaves them out of the other results") {
    CostCell c = cell("a", 50, 1e-5);
    c.points.push_back({.failure = "no value"});
    CHECK(c.failed() == 1);
    CHECK(c.right().least == 60);
    CHECK(c.seconds().median == doctest::Approx(1e-5));
    const auto row = cost_tables({{c}, {}}).front().rows.front();
    CHECK(row ==
          std::vector<std::string>{"a", "MPFR", "50", "4", "60*", "", "10.0 us", "30.0 us", "0 %"});
}

// The counts are recorded, not derived: an unexpected change in either direction must be noticed.
// After a change of a rule, check its effect on the digits (below) and write the new counts here.
TEST_CASE("evaluations by route and digits: five points of a flat-and-rounded punch") {
    const auto found = totals(counted({usual("flat-and-rounded")}, {16, 50}, 5));
    CHECK(differences(found, {{"Barber-Mossakovskii, MPFR, 16", 917},
                              {"Barber-Mossakovskii, MPFR, 50", 2039},
                              {"singular integral, MPFR, 16", 5852},
                              {"singular integral, MPFR, 50", 13980}}) == "");
}

TEST_CASE("evaluations by route and digits: the other contacts") {
    const auto power = totals(counted({usual("power law, m = 1/2")}, {50}, 4));
    CHECK(differences(power, {{"Barber-Mossakovskii, MPFR, 50", 1703},
                              {"singular integral, MPFR, 50", 8371}}) == "");
    const auto tilted = totals(counted({usual("tilted flat-and-rounded")}, {34}, 2));
    CHECK(differences(tilted, {{"Barber-Mossakovskii, MPFR, 34", 1283},
                               {"singular integral, MPFR, 34", 3522}}) == "");
    const auto apex = totals(counted({usual("by the apex of a power law")}, {50}, 2));
    CHECK(differences(apex, {{"singular integral, MPFR, 50", 4794}}) == "");
}

TEST_CASE("evaluations at 100 to 1000 digits" * doctest::test_suite("slow")) {
    const auto found = totals(counted({usual("flat-and-rounded")}, {100, 200}, 5));
    CHECK(differences(found, {{"Barber-Mossakovskii, MPFR, 100", 4446},
                              {"Barber-Mossakovskii, MPFR, 200", 9780},
                              {"singular integral, MPFR, 100", 29750},
                              {"singular integral, MPFR, 200", 58710}}) == "");
}

TEST_CASE(
    "every route in MPFR and in balls reaches the digits that it is asked for, at hard points") {
    std::string short_of;
    std::size_t cells = 0;
    for (const CostCell& c : counted(usual_cases(), {16, 34}, 2)) {
        if (c.arithmetic == "MPFR" || c.arithmetic == "balls") {
            ++cells;
            // An enclosure at a fixed number of bits loses digits near a knot.
            if (c.route != "enclosure" &&
                (c.failed() > 0 || c.right().least + last_digit < c.digits)) {
                short_of += c.scene + ", " + c.route + ", " + std::to_string(c.digits) + "\n";
            }
        }
    }
    CHECK(short_of == "");
    CHECK(cells > 60);
}

TEST_CASE("the points compared are forty, in equal ratios from 1e-8 a to a") {
    const std::vector<CostCase> cases = usual_cases();
    const CostCase& first = cases.front();
    CHECK(first.name == "flat-and-rounded");
    REQUIRE(first.u.size() == 40);
    CHECK(first.u.front() == Exact::parse("1e-8"));
    CHECK(first.u.back() == Exact::parse("1"));
    for (std::size_t i = 1; i < 40; ++i) {
        const Real ratio = first.u[i].to<Real>() / first.u[i - 1].to<Real>();
        CHECK(ratio.convert_to<double>() == doctest::Approx(1.60371874).epsilon(1e-5)); // 10^(8/39)
    }
    CHECK(thinned(40, 40).size() == 40);
    CHECK(thinned(40, 3) == std::vector<std::size_t>{0, 19, 39});
    CHECK(thinned(2, 5) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("quartiles are those of the textbook") {
    const Quartiles q = quartiles({5, 1, 4, 2, 3});
    CHECK(q.least == 1);
    CHECK(q.low == 2);
    CHECK(q.median == 3);
    CHECK(q.high == 4);
    CHECK(q.most == 5);
    CHECK(quartiles({1, 2}).median == 1.5);
    CHECK(quartiles({}).most == 0);
}

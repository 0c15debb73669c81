// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cost/cost.hpp"
#include "edgeproof/roots/roots.hpp"
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

/// Checks the total evaluations of two routes in MPFR for the points of a case; 0: not counted.
void check_counts(const std::string& name, std::size_t points, unsigned digits,
                  std::size_t barber_mossakovskii, std::size_t singular_integral) {
    CAPTURE(name);
    CAPTURE(digits);
    std::map<std::string, std::size_t> found;
    for (const CostCell& c : counted({usual(name)}, {digits}, points)) {
        for (const PointCost& p : c.points) {
            found[c.route + ", " + c.arithmetic] += static_cast<std::size_t>(p.evaluations);
        }
    }
    CHECK((barber_mossakovskii == 0 || found["Barber-Mossakovskii, MPFR"] == barber_mossakovskii));
    CHECK(found["singular integral, MPFR"] == singular_integral);
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
    const auto tables = cost_tables({cell("a", 50, 1e-5), cell("a", 100, 4e-5), cell("b", 50, 1e-5),
                                     cell("b", 100, 2e-5), cell("c", 50, 1e-5)});
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
    const auto row = cost_tables({c}).front().rows.front();
    CHECK(row ==
          std::vector<std::string>{"a", "MPFR", "50", "4", "60*", "", "10.0 us", "30.0 us", "0 %"});
}

// The counts are recorded, not derived: an unexpected change in either direction must be noticed.
// After a change of a rule, check its effect on the digits (below) and write the new counts here.
TEST_CASE("evaluations by route and digits") {
    check_counts("flat-and-rounded", 5, 16, 917, 5852);
    check_counts("flat-and-rounded", 5, 50, 2039, 13980);
    check_counts("power law, m = 1/2", 4, 50, 1703, 8371);
    check_counts("tilted flat-and-rounded", 2, 34, 1283, 3522);
    check_counts("by the apex of a power law", 2, 50, 0, 4794);
}
TEST_CASE("evaluations at 100 and 200 digits" * doctest::test_suite("slow")) {
    check_counts("flat-and-rounded", 5, 100, 4446, 29750);
    check_counts("flat-and-rounded", 5, 200, 9780, 58710);
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

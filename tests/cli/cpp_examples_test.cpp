// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace edgeproof::test;

namespace {

/// Returns the lines that an example of examples/cpp prints.
std::vector<std::string> printed_by(const std::string& example) {
    const Folder folder;
    const std::filesystem::path out = folder.path() / "out";
    const std::filesystem::path built = program().parent_path() / "examples" / example;
    CHECK(std::system(("'" + built.string() + "' >'" + out.string() + "'").c_str()) == 0);
    return edgeproof::test::lines(file_text(out));
}

/// Returns the values of a table in reference/ by the ids of its rows. Other tests show that routes
/// that share no formula give the same tables (docs/independence.md).
std::map<std::string, std::string> reference_values(const std::string& name) {
    const std::filesystem::path file = source_dir() / "reference" / name;
    const io::Csv table = io::parse_csv(file_text(file), file.string());
    const auto& columns = table.header.cells;
    const auto value = std::find(columns.begin(), columns.end(), "value") - columns.begin();
    std::map<std::string, std::string> values;
    for (const io::Csv::Row& row : table.rows) {
        values.emplace(row.cells.front(), row.cells.at(static_cast<std::size_t>(value)));
    }
    return values;
}

} // namespace

TEST_CASE("example proved_pressure: the reference table's digits, and a ball around them") {
    const std::string p = reference_values("flat-and-rounded.csv").at("flat:t=0.4:right:u=1/100:p");
    const auto out = printed_by("proved_pressure");
    REQUIRE(out.size() == 2);
    CHECK(out[0] == "p      " + p);
    const std::string begin = "within ";
    const std::string between = " ... ";
    const std::size_t at = out[1].find(between);
    REQUIRE(out[1].starts_with(begin));
    REQUIRE(at != std::string::npos);
    const Rational lower = parse_decimal(out[1].substr(begin.size(), at - begin.size()));
    const Rational upper = parse_decimal(out[1].substr(at + between.size()));
    CHECK(lower <= parse_decimal(p));
    CHECK(parse_decimal(p) <= upper);
    CHECK(upper - lower < parse_decimal("1e-18"));
}

TEST_CASE("example coefficients: those of the reference table, both edges") {
    const auto values = reference_values("tilted-wedge.csv");
    const auto out = printed_by("coefficients");
    REQUIRE(out.size() == 8);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::string edge = i < 4 ? "right" : "left";
        const std::string name = "c_" + std::to_string(i % 4);
        const Rational value = parse_decimal(values.at("tilted:alpha=pi/64:" + edge + ":" + name));
        CHECK(out[i] == edge + " " + name + " " + to_decimal(value, 30, Rounding::nearest));
    }
}

// p is proportional to sqrt(u (2 - u)). With s = u/2, the ratio of one term to p is 1/sqrt(1 - s),
// of two terms (1 - s/2)/sqrt(1 - s): at 1.01 this is a linear and a quadratic equation. For three
// terms the ratio is (1 - s/2 - s^2/8)/sqrt(1 - s): the equation is not solved, but its sign must
// change.
TEST_CASE("example extent: roots of the equations that Hertz' pressure gives") {
    const auto out = printed_by("extent");
    REQUIRE(out.size() == 3);
    for (std::size_t n = 1; n <= 3; ++n) {
        const std::string before = "extent_" + std::to_string(n) + " = ";
        const std::string after = ", proved";
        const std::string& line = out[n - 1];
        REQUIRE(line.starts_with(before));
        REQUIRE(line.ends_with(after));
        const Rational u =
            parse_decimal(line.substr(before.size(), line.size() - before.size() - after.size()));
        const auto beyond = [n](const Rational& at) { // the terms exceed 1.01 p at this u
            const Rational s = at / 2;
            const Rational sum = n == 1   ? Rational(1)
                                 : n == 2 ? Rational(1 - s / 2)
                                          : Rational(1 - s / 2 - s * s / 8);
            return sum * sum > Rational(10201, 10000) * (1 - s);
        };
        CHECK_FALSE(beyond(u - parse_decimal("1e-19")));
        CHECK(beyond(u + parse_decimal("1e-19")));
    }
}

TEST_CASE("example table_in_threads: the reference table's rows, in order") {
    const auto values = reference_values("power-law.csv");
    std::vector<std::string> rows{"m,u,p"};
    for (const std::string m : {"1", "3/2", "2", "7/3", "3"}) {
        for (const std::string u : {"1e-100", "1e-15", "0.25", "0.999"}) {
            const std::string id = "power:m=" + m + ":right:u=" + u + ":p";
            CAPTURE(id);
            REQUIRE(values.contains(id));
            rows.push_back(m + "," + u + "," + values.at(id));
        }
    }
    CHECK(printed_by("table_in_threads") == rows);
}

// sqrt(2a - u) = sqrt(2a) (1 - u/(4a) - ...): the second coefficient is negative.
TEST_CASE("example ledger: right claims are confirmed, the wrong sign is refuted and corrected") {
    const auto out = printed_by("ledger");
    REQUIRE(out.size() == 3);
    CHECK(out[0] == "pressure: confirmed");
    CHECK(out[1] == "second-coefficient: refuted");
    CHECK(out[2] == "  correct: -(Es*C/(4*sqrt(2*a)))");
}

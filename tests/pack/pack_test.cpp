// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/pack/pack.hpp"

#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

using namespace edgeproof::pack;

namespace {

const std::string small_recipe = R"(digits = 50
[scenes.s]
edges = ["right", "left"]
u = ["0.1", "1e-20"]
quantities = ["P", "M", "c_0", "p"]
[scenes.s.profile]
kind = "power-law"
m = ["0", "1"]
C = "0.1"
[scenes.s.load]
a = "2"
contact_modulus = "2.9"
)";

using PackRow = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

std::vector<PackRow> rows_of(const std::string& text) {
    std::string head = pack_columns();
    head.pop_back();
    const auto names = cells_of(head);
    std::vector<PackRow> rows;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) {
            continue;
        }
        const auto cells = cells_of(line);
        REQUIRE(cells.size() == names.size());
        PackRow row;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            row[names[i]] = cells[i];
        }
        rows.push_back(row);
    }
    return rows;
}

double value_of(const PackRow& row, const std::string& column) {
    return std::strtod(row.at(column).c_str(), nullptr);
}

} // namespace

TEST_CASE("pack: rows are the textbook's values at binary64 numbers") {
    const PackRows made = recipe_rows(small_recipe, "r.toml", true, {});
    const auto rows = rows_of(made.text);
    CHECK(made.rows == rows.size());
    CHECK(rows.size() == 14);  // P, two c_0 and four p for each
    CHECK(made.left_out == 2); // M = 0
    for (const PackRow& row : rows) {
        CAPTURE(row.at("id"));
        const double a = value_of(row, "a");
        const double EC = value_of(row, "E") * value_of(row, "C");
        const double u = value_of(row, "u");
        const bool wedge = value_of(row, "m") == 0;
        // Johnson, eqs. 4.45 (with p_0 = E* a/(2R)) and 5.7.
        double expected = 0;
        if (row.at("quantity") == "p") {
            expected = wedge ? EC / std::numbers::pi *
                                   std::asinh(std::sqrt(u * (2 * a - u)) / std::abs(a - u))
                             : EC / 2 * std::sqrt(u * (2 * a - u));
        } else if (row.at("quantity") == "P") {
            expected = wedge ? EC * a : EC * std::numbers::pi * a * a / 4;
        } else {
            expected = wedge ? EC / std::numbers::pi * std::sqrt(2 / a) : EC / 2 * std::sqrt(2 * a);
        }
        const double exact = value_of(row, "binary64");
        CHECK(exact == doctest::Approx(expected).epsilon(1e-14));
        CHECK(value_of(row, "hex") == exact);
        CHECK(value_of(row, "value") == exact); // strtod rounds to nearest; none of these is a tie
        CHECK(row.at("value").size() >= 50);
        CHECK(value_of(row, "bound") < 1e-45 * std::abs(exact));
        CHECK(row.at("edge") == (row.at("quantity") == "P" ? "none" : row.at("edge")));
        CHECK(value_of(row, "ulps") == 4);
        CHECK(value_of(row, "condition") < 8);
        // The largest pressure is E* C a/2; the wedge's is infinite, and its mean is E* C/2.
        CHECK(value_of(row, "scale") == doctest::Approx(wedge ? EC / 2 : EC * a / 2).epsilon(1e-5));
        CHECK(row.at("phi") == "nan");
    }
}

TEST_CASE("pack: hard cases keep their reasons; those that the columns cannot state are left out") {
    const std::string one =
        "class = \"u = 1e-40 a\"\nreason = \"lost\"\nquantity = \"pressure\"\nedge = \"right\"\n"
        "u = \"1e-40\"\nprofile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n"
        "load = { a = \"1\", contact_modulus = \"1\" }\n";
    const std::string other =
        "class = \"a\"\nreason = \"b\"\nquantity = \"pressure\"\nedge = \"right\"\nu = \"0.1\"\n"
        "profile = { kind = \"piecewise\", symmetric = true, knots = [], slopes = [\"x\"] }\n"
        "load = { a = \"1\", contact_modulus = \"1\" }\n";
    const std::string residual = "class = \"a\"\nreason = \"b\"\nquantity = \"residual\"\nedge = "
                                 "\"right\"\nu = \"0.1\"\nn = "
                                 "1\nprofile = { kind = \"power-law\", m = \"1\", C = \"1\" }\n"
                                 "load = { a = \"1\", contact_modulus = \"1\" }\n";
    const PackRows made = hard_case_rows("[cases.one]\n" + one + "[cases.other]\n" + other +
                                             "[cases.third]\n" + residual,
                                         "h.toml", {});
    CHECK(made.rows == 1);
    CHECK(made.text.starts_with("# u = 1e-40 a: lost\nhard:one,power-law,1,1,"));
    const double p = value_of(rows_of(made.text).front(), "binary64");
    CHECK(p == doctest::Approx(std::sqrt(2e-40) / 2).epsilon(1e-15));
}

TEST_CASE("pack: the whole is the same on any number of threads, and below two megabytes") {
    const auto files = make_pack({1, {}});
    const auto again = make_pack({2, {}});
    REQUIRE(files.size() == again.size());
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        CHECK(files[i].name == again[i].name);
        CHECK(files[i].text == again[i].text);
        bytes += files[i].text.size();
    }
    CHECK(bytes < 2'000'000);
    const std::string text = manifest(files, {"edgeproof 0", "abc", "2026-01-01", "c"});
    CHECK(text.find("# commit: abc\n# date: 2026-01-01\n") != std::string::npos);
    CHECK(text.find("  cases.csv\n") != std::string::npos);
    // Every row of level A has a scale, and is at least a fiftieth of the contact from an edge.
    for (const PackFile& file : files) {
        if (file.name == "level-a.csv") {
            CHECK(file.text.find(",p,nan,") == std::string::npos);
        }
    }
}

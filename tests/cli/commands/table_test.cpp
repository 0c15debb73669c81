// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/foreign_text.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <map>

using namespace edgeproof::test;

namespace {

// p = sqrt(u (2 - u))/2: 3-4-5 at u = 1/5 and 2/5; P = pi/4; c_0 = sqrt(2)/2, c_1 = -sqrt(2)/8.
const std::string hertz_recipe = R"(title = "Hertz"
digits = 20
[scenes.hertz]
edges = ["right", "left"]
u = ["1/5", "2/5"]
quantities = ["p", "P", "c_0", "c_1", "b", "M"]
[scenes.hertz.profile]
kind = "power-law"
m = "1"
C = "1"
[scenes.hertz.load]
a = "1"
contact_modulus = "1"
)";

std::map<std::string, std::string> by_id(const std::string& csv, const char* column) {
    const Csv table = parse_csv(csv, "table");
    std::map<std::string, std::string> values;
    for (const Csv::Row& row : table.rows) {
        values[row.cells.at(0)] = row.cells.at(table.column(column).value());
    }
    return values;
}

/// Changes a digit in the middle of the row's value.
std::string spoilt(std::string text, const std::string& id) {
    const std::size_t row = text.find("\n" + id + ",");
    const std::size_t at = text.find("0.4000", row) + 7;
    text[at] = text[at] == '0' ? '1' : '0';
    return text;
}

} // namespace

TEST_CASE("table: the same bytes on any number of threads, every format, written whole") {
    const Folder folder;
    folder.write("h.toml", hertz_recipe);
    const std::string one = run(folder, "table h.toml --threads 1").out;
    CHECK(one == run(folder, "table h.toml --threads 2").out);
    CHECK(run(folder, "table h.toml --out new/h.csv").code == 0);
    CHECK(file_text(folder.path() / "new" / "h.csv") == one);
    const auto json = nlohmann::json::parse(run(folder, "table h.toml --format json").out);
    REQUIRE(json["rows"].size() == 11);
    CHECK(json["rows"][0]["value"] == by_id(one, "value")["hertz:P"]);
    CHECK(run(folder, "table h.toml --format md").out.find("0.70710678118654752440") !=
          std::string::npos);
    CHECK(run(folder, "table h.toml --format tex").out.find("\\bottomrule") != std::string::npos);
    // One row a contact (a = 1: P = pi/4, c_0 = sqrt(1/2)), and chosen columns.
    const std::string wide = run(folder, "table h.toml --wide").out;
    CHECK(wide.find("c_0") != std::string::npos);
    CHECK(wide.find(",0.70710678118654752440,") != std::string::npos);
    CHECK(wide.find("checksum") == std::string::npos);
    CHECK(run(folder, "table h.toml --columns quantity,value")
              .out.find("\nP,0.78539816339744830962\n") != std::string::npos);
}

TEST_CASE("table --check: a changed digit, a lost row, a row moved or added are named") {
    const Folder folder;
    folder.write("h.toml", hertz_recipe);
    CHECK(run(folder, "table h.toml --out h.csv").code == 0);
    const std::string good = file_text(folder.path() / "h.csv");
    REQUIRE(lines(good).size() > 11);
    const Outcome same = run(folder, "table h.toml --check");
    CHECK(same.code == 0);
    CHECK(same.out == "h.csv: 11 of 11 rows made anew, every digit the same\n");
    CHECK(run(folder, "table h.toml --check --every 4").out ==
          "h.csv: 3 of 11 rows made anew, every digit the same\n");
    const auto said = [&](const std::string& text) {
        folder.write("h.csv", text);
        const Outcome o = run(folder, "table h.toml --check");
        CHECK(o.code == 1);
        CHECK(o.out.empty());
        return o.err;
    };
    const std::string digit = said(spoilt(good, "hertz:left:u=2/5:p"));
    CHECK(digit.find("row hertz:left:u=2/5:p has value 0.4000010000") != std::string::npos);
    CHECK(digit.find("the head has checksum: fnv1a-64 ") != std::string::npos);
    auto all = lines(good);
    auto fewer = all;
    const std::string lost = fewer.back().substr(0, fewer.back().find(','));
    fewer.pop_back();
    CHECK(said(joined(fewer)).find("row " + lost + " is missing") != std::string::npos);
    auto more = all;
    more.push_back("another" + all.back().substr(lost.size()));
    CHECK(said(joined(more)).find("row another is not there any more") != std::string::npos);
    auto moved = all;
    std::swap(moved[all.size() - 1], moved[all.size() - 2]);
    CHECK(said(joined(moved)).find("the head has checksum: ") != std::string::npos);
    auto twice = all;
    twice.push_back(all.back());
    CHECK(said(joined(twice)).find("row " + lost + " occurs twice") != std::string::npos);
    // The head states what the table has, once.
    for (const auto& row : {std::pair{"digits: 20", "digits: 40"},
                            {"rounding: nearest", "rounding: down"},
                            {"estimates: 0", "estimates: 3"},
                            {"rows: 11", "rows: 12"},
                            {"digits: 20", "digits: 20\n# digits: 50"},
                            {"digits: 20", "many digits"}}) {
        const std::string key = row.first;
        const std::string other = row.second;
        CAPTURE(other);
        const std::string wrong =
            said(std::string(good).replace(good.find(key), key.size(), other));
        CHECK(lines(wrong).size() == 1);
        CHECK(wrong.find(std::string(", and the table has ") + key) != std::string::npos);
    }
    // A table with other digits is refused because of its rows.
    folder.write("h.toml", std::string(hertz_recipe).replace(hertz_recipe.find("20"), 2, "21"));
    CHECK(said(good).find("row hertz:P has value 0.78539816339744830962, made anew "
                          "0.785398163397448309616") != std::string::npos);
}

TEST_CASE("table --check --every passes a right table whose sample lacks a column's quantities") {
    const Folder folder;
    folder.write("h.toml", std::string(hertz_recipe)
                               .replace(hertz_recipe.find("\"M\"]"), 4,
                                        "\"M\", \"extent_1\"]\ntolerance = [\"1%\"]"));
    CHECK(run(folder, "table h.toml --out h.csv").code == 0);
    for (const char* every : {"2", "3", "5", "100"}) {
        CAPTURE(std::string(every));
        CHECK(run(folder, std::string("table h.toml --check --every ") + every).code == 0);
    }
}

namespace {

/// Checks every recipe under reference/ against the table next to it.
std::size_t check_reference_tables(const std::string& options) {
    const Folder folder;
    std::size_t rows = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_dir() / "reference")) {
        auto expected = entry.path();
        const bool has_table = std::filesystem::exists(expected.replace_extension(".csv"));
        if (entry.path().extension() != ".toml" || !has_table) {
            continue;
        }
        const Outcome o = run(folder, "table '" + entry.path().string() + "' --check" + options);
        CAPTURE(o.err);
        CHECK(o.code == 0);
        auto table = entry.path();
        rows += parse_csv(file_text(table.replace_extension(".csv")), "table").rows.size();
    }
    return rows;
}

} // namespace

TEST_CASE("the reference tables: a sample is reproduced") {
    CHECK(check_reference_tables(" --every 7") >= 5000);
}

TEST_CASE("the reference tables: all rows are reproduced" * doctest::test_suite("slow")) {
    CHECK(check_reference_tables("") >= 5000);
}

TEST_CASE(
    "table --part and --merge: the bytes of the table made at once; a complete part is kept") {
    const Folder folder;
    folder.write("r.toml", hertz_recipe);
    REQUIRE(run(folder, "table r.toml --out whole.csv").code == 0);
    for (const char* part : {"3/3", "1/3", "2/3"}) {
        const std::string name = std::string("p") + part[0] + ".csv";
        REQUIRE(run(folder, std::string("table r.toml --part ") + part + " --out " + name).code ==
                0);
    }
    REQUIRE(run(folder, "table --merge p2.csv p1.csv p3.csv --out merged.csv").code == 0);
    CHECK(file_text(folder.path() / "merged.csv") == file_text(folder.path() / "whole.csv"));
    CHECK(has(run(folder, "table r.toml --part 1/3 --out p1.csv").err,
              "p1.csv: part 1/3 is complete"));
    // Another recipe, or a changed row: the part is made again.
    const std::string right = file_text(folder.path() / "p1.csv");
    std::string spoilt_part = right;
    spoilt_part.back() = 'x';
    folder.write("p1.csv", spoilt_part + "\n");
    CHECK(run(folder, "table r.toml --part 1/3 --out p1.csv").err.empty());
    CHECK(file_text(folder.path() / "p1.csv") == right);
    folder.write("r.toml", hertz_recipe + "# another text\n");
    CHECK(run(folder, "table r.toml --part 1/3 --out p1.csv").err.empty());

    folder.write("spoilt.csv", spoilt_part);
    for (const auto& row : std::initializer_list<std::pair<const char*, const char*>>{
             {"--merge p1.csv p2.csv p3.csv",
              "p2.csv:1: this is a part of another table than p1.csv"},
             {"--merge p2.csv", "p2.csv:1: part 1 of 3 is not given"},
             {"--merge p2.csv p2.csv", "p2.csv:1: part 2 is given twice"},
             {"--merge whole.csv", "whole.csv:1: this is no part of a table"},
             {"--merge spoilt.csv", "spoilt.csv:1: rows are missing or have changed"}}) {
        const std::string message = row.second;
        CAPTURE(message);
        const Outcome o = run(folder, std::string("table ") + row.first);
        CHECK(o.code == 2);
        CHECK(has(o.err, message));
    }
}

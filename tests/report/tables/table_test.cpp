// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace edgeproof::report;

namespace {

Table table_of_numbers(std::size_t columns, std::size_t rows, std::size_t decimals) {
    Table table;
    table.columns = {{"edge", Column::Kind::text}, {"u"}};
    for (std::size_t i = 0; i < columns; ++i) {
        table.columns.push_back({"c" + std::to_string(i)});
    }
    for (std::size_t j = 0; j < rows; ++j) {
        table.rows.push_back({"right", "0.1"});
        for (std::size_t i = 0; i < columns; ++i) {
            table.rows.back().push_back("0." + std::string(decimals, '1'));
        }
    }
    return table;
}

std::size_t number_of(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) {
        ++n;
    }
    return n;
}

} // namespace

// 455 pt (16 cm) are 91 digits of 5 pt (Computer Modern at 10 pt: half a quad). With "right", "0.1"
// and 12 pt around each column (2 \tabcolsep), 4 columns of 18 digits, a zero and a point need
// 5 (5 + 3 + 4*20) + 6*12 = 512 pt, and 3 of them 400 pt.
TEST_CASE("LaTeX: a table that is too wide is divided, the first two columns stay") {
    const std::string tex = write_table(table_of_numbers(7, 2, 18), TableFormat::latex);
    CHECK(number_of(tex, "\\begin{tabular}") == 3);
    CHECK(number_of(tex, "\\end{tabular}") == 3);
    CHECK(number_of(tex, "edge & u & ") == 3);
    CHECK(number_of(tex, "edge & u & c0 & c1 & c2 \\\\\n") == 1);
    CHECK(number_of(tex, "edge & u & c3 & c4 & c5 \\\\\n") == 1);
    CHECK(number_of(tex, "edge & u & c6 \\\\\n") == 1);
    CHECK(number_of(tex, "0.111111111111111111") == 14);
    const std::string narrow = write_table(table_of_numbers(3, 2, 18), TableFormat::latex);
    CHECK(number_of(narrow, "\\begin{tabular}") == 1);
}

TEST_CASE("LaTeX: a number that is wider than a page is broken after every tenth character") {
    const std::string tex = write_table(table_of_numbers(1, 1, 100), TableFormat::latex);
    CHECK(tex.find("{lrp{") != std::string::npos);
    CHECK(number_of(tex, "\\allowbreak$1111111111$") == 9);
    CHECK(number_of(tex, "$0.11111111$") == 1);
    // Two columns of 50 digits: both are broken, so that they fit next to each other.
    Table two = table_of_numbers(1, 1, 48);
    two.rows[0][1] = two.rows[0][2];
    CHECK(number_of(write_table(two, TableFormat::latex), "p{") == 2);
    // One of them fits next to a short u.
    CHECK(number_of(write_table(table_of_numbers(1, 1, 48), TableFormat::latex), "p{") == 0);
}

TEST_CASE("LaTeX: a table of more rows than a page has is a longtable") {
    const std::string one = write_table(table_of_numbers(1, 40, 5), TableFormat::latex);
    CHECK(number_of(one, "longtable}") == 0);
    const std::string more = write_table(table_of_numbers(1, 41, 5), TableFormat::latex);
    CHECK(number_of(more, "{longtable}") == 2);
    CHECK(number_of(more, "\\endhead") == 1);
    CHECK(number_of(more, "tabular}") == 0);
    CHECK(number_of(more, "0.11111") == 41);
}

TEST_CASE("columns are chosen by name, in the order of the request") {
    const Table table = table_of_numbers(3, 1, 5);
    const Table part = with_columns(table, {"c2", "edge"});
    CHECK(write_table(part, TableFormat::csv, {.notes = false}) == "c2,edge\n0.11111,right\n");
    CHECK_THROWS_WITH_AS((void)with_columns(table, {"c7"}),
                         "--columns: there is no column 'c7'; write one of edge, "
                         "u, c0, c1, c2",
                         edgeproof::InputError);
}

TEST_CASE("a short answer: equal facts in one line, empty cells left out, wide rows continued") {
    Table table;
    table.title = "T";
    table.asked = "what";
    table.facts = {{"digits", "6"},
                   {"a", "1", "2e-7", "from P", "mm"},
                   {"b", "1", "2e-7", "from P", "mm"},
                   {"c", "2"}};
    table.notes = {"long explanation"};
    table.remarks = {"bounds are proved"};
    Column edge{"edge", Column::Kind::text};
    edge.phrase = "{} edge";
    Column bound{"p_bound"};
    bound.role = Column::Role::bound;
    Column route{"route", Column::Kind::text};
    route.role = Column::Role::route;
    Column p{"p"};
    p.unit = "MPa";
    Column none{"none"};
    Column hidden{"hidden"};
    hidden.shown = Column::Shown::not_on_terminal;
    table.columns = {edge, p, bound, route, none, hidden};
    table.rows = {{"right", "0.5", "1e-9", "closed-form", "", "7"},
                  {"left", "0.25", "1e-9", "series (estimate)", "", "7"}};
    CHECK(short_answer(table, 80) == "T\nwhat\na = b = 1 +- 2e-7 mm (from P)\nc = 2\n"
                                     "right edge  p = 0.5 +- 1e-9 MPa\n"
                                     "left edge   p = 0.25 +- 1e-9 MPa (series (estimate))\n"
                                     "bounds are proved\n");
    CHECK(short_answer(table, 30).find("right edge\n      p = 0.5 +- 1e-9 MPa\n") !=
          std::string::npos);
}

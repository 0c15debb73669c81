// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/csv.hpp"
#include "edgeproof/conformance/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <doctest/doctest.h>

using namespace edgeproof;
using Cells = std::vector<std::string>;

TEST_CASE("CSV: notes, quotes, blanks, either line end, ragged rows, each with its line") {
    const Csv csv = parse_csv("# a note\r\nid, value\r\n\r\n1,\"a, \"\"b\"\"\"\r\n# another\n"
                              "2,\"two\nlines\"\n 3 \n4,,x",
                              "f.csv");
    CHECK(csv.notes == Cells{"a note", "another"});
    CHECK(csv.header.cells == Cells{"id", "value"});
    CHECK(csv.column("value") == 1);
    CHECK_FALSE(csv.column("nothing"));
    REQUIRE(csv.rows.size() == 4);
    CHECK(csv.rows[0].cells == Cells{"1", "a, \"b\""});
    CHECK(csv.rows[0].line == 4);
    CHECK(csv.rows[1].cells == Cells{"2", "two\nlines"});
    CHECK(csv.rows[1].line == 6);
    CHECK(csv.rows[2].cells == Cells{"3"});
    CHECK(csv.rows[2].line == 8);
    CHECK(csv.rows[3].cells == Cells{"4", "", "x"});
    CHECK_THROWS_WITH_AS((void)parse_csv("id\n\"1\n2\n", "f.csv"),
                         "f.csv:2: a quote begins here and does not end; close it, or write \"\" "
                         "for one",
                         InputError);
    CHECK_THROWS_AS((void)parse_csv("# notes only\n", "f.csv"), InputError);
}

TEST_CASE("the checksum is FNV-1a, 64 bits") {
    // The test vectors of draft-eastlake-fnv.
    CHECK(fnv1a("") == 0xcbf29ce484222325U);
    CHECK(fnv1a("a") == 0xaf63dc4c8601ec8cU);
    CHECK(fnv1a("foobar") == 0x85944171f73967e8U);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

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
                         "f.csv:2: a quote begins here and does not end; quote a cell as a whole, "
                         "or not at all, and write \"\" for one quote in it",
                         InputError);
    CHECK_THROWS_AS((void)parse_csv("# notes only\n", "f.csv"), InputError);
}

TEST_CASE("CSV: text next to a quote is an error of its row, and the rows after it are read") {
    struct Bad {
        const char* row;
        const char* fault;
    };
    const std::string behind = "something follows a closing quote";
    const std::string within = "a quote stands within a cell that does not begin with one";
    for (const std::pair<const char*, std::string>& wrong : {
             std::pair{"\"0.4\"999,x", behind},
             std::pair{"\"0.4\" NaN (diverged),x", behind},
             std::pair{"\"0.4\"\t\t.5,x", behind},
             std::pair{"x,\"0.4\"\"\"9", behind},
             std::pair{"0.\"4\",x", within},
             std::pair{"x,0.4\"", within},
         }) {
        const std::string row = wrong.first;
        const std::string& fault = wrong.second;
        CAPTURE(row);
        const std::string text = "a,b\n" + row + "\n1,2\n";
        CHECK_THROWS_AS((void)parse_csv(text, "f.csv"), InputError);
        const Csv csv = parse_csv(text, "f.csv", {.keep_faults = true});
        REQUIRE(csv.rows.size() == 2);
        CHECK(csv.rows[0].fault == fault);
        CHECK(csv.rows[0].line == 2);
        CHECK(csv.rows[1].fault.empty());
        CHECK(csv.rows[1].cells == Cells{"1", "2"});
    }
    const Csv open = parse_csv("a,b\n1,2\n3,\"4\n5,6\n", "f.csv", {.keep_faults = true});
    REQUIRE(open.rows.size() == 2);
    CHECK(open.rows[1].fault == "a quote begins here and does not end");
    // Blanks around the quotes are not part of the cell, like those around a bare one.
    CHECK(parse_csv("a,b\n \"1\" ,\t\"2\" \r\n", "f.csv").rows[0].cells == Cells{"1", "2"});
}

TEST_CASE("CSV: byte order mark, tabs, semicolons; notes that a spreadsheet has quoted") {
    for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
        for (const char separator : {',', ';', '\t'}) {
            for (const std::string end : {"\n", "\r\n"}) {
                const std::string s(1, separator);
                const std::string text = mark + "# note" + s + s + end + "\"# a" + s + " b\"" + s +
                                         end + "id" + s + "\"va,l;u\te\"" + s + "c" + end + "1" +
                                         s + "\"2" + s + "\"" + s + end + s + s + end;
                CAPTURE(text);
                const Csv csv = parse_csv(text, "f.csv");
                CHECK(csv.separator == separator);
                CHECK(csv.header.cells == Cells{"id", "va,l;u\te", "c"});
                REQUIRE(csv.notes.size() == 2);
                CHECK(csv.notes[1] == "a" + s + " b");
                REQUIRE(csv.rows.size() == 2);
                CHECK(csv.rows[0].cells == Cells{"1", "2" + s, ""});
                CHECK(csv.rows[1].cells == Cells{"", "", ""});
            }
        }
    }
}

TEST_CASE("CSV: UTF-16 without a mark and lines that end in CR alone are refused with the cause") {
    using namespace std::string_literals;
    for (const std::string& text : {"i\0d\0\n\0"s, "\0i\0d\0\n"s}) {
        CHECK_THROWS_WITH_AS((void)parse_csv(text, "f.csv"),
                             "f.csv:1: the file is in UTF-16 without a byte order mark; save it as "
                             "CSV in UTF-8",
                             InputError);
    }
    for (const std::string& text : {"\xFF\xFEi\0d"s, "\xFE\xFF\0i\xD8\0\0\n"s}) { // half of a pair
        CHECK_THROWS_WITH_AS((void)parse_csv(text, "f.csv"),
                             "f.csv: the file is in UTF-16 with an incomplete character; save it "
                             "in UTF-8",
                             InputError);
    }
    CHECK_THROWS_WITH_AS((void)parse_csv("id,value\r1,2\r", "f.csv"),
                         "f.csv:1: the lines end in CR alone; end them in LF or CR LF", InputError);
    CHECK(parse_csv("id,value\r", "f.csv").header.cells == Cells{"id", "value"});
}

TEST_CASE("CSV: UTF-16 with a byte order mark is read as the same text in UTF-8") {
    std::u16string text = u"id;value\r\n\u00B5\xD835\xDC65;1,5\r\n";
    text += u"n;2\r\n";
    for (const bool big_endian : {false, true}) {
        std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
        for (const char16_t c : text) {
            const char high = static_cast<char>(c >> 8);
            const char low = static_cast<char>(c & 0xFF);
            bytes += big_endian ? high : low;
            bytes += big_endian ? low : high;
        }
        const Csv csv = parse_csv(bytes, "f.csv");
        CHECK(csv.header.cells == Cells{"id", "value"});
        CHECK(csv.separator == ';');
        REQUIRE(csv.rows.size() == 2);
        CHECK(csv.rows[0].cells == Cells{"\xC2\xB5\xF0\x9D\x91\xA5", "1,5"});
        CHECK(csv.rows[1].cells == Cells{"n", "2"});
    }
}

TEST_CASE("CSV: no more rows than requested") {
    const Csv csv = parse_csv("a\n1\n2\n3\n", "f.csv", {.most_rows = 2});
    CHECK(csv.rows.size() == 2);
    CHECK(csv.cut);
    CHECK_FALSE(parse_csv("a\n1\n2\n", "f.csv", {.most_rows = 2}).cut);
}

TEST_CASE("the checksum is FNV-1a, 64 bits") {
    // These are the test vectors of draft-eastlake-fnv.
    CHECK(fnv1a("") == 0xcbf29ce484222325U);
    CHECK(fnv1a("a") == 0xaf63dc4c8601ec8cU);
    CHECK(fnv1a("foobar") == 0x85944171f73967e8U);
}

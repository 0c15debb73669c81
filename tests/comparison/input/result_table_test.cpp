// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/input/result_table.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

ResultTable parsed_result(const std::string& text, const ResultReading& reading = {}) {
    return parse_result(text, "r.csv", reading);
}

/// Checks for x = -1/2, 0, 1/2 and p = 1, 3/2, 1, the content of each of the texts below.
void check_three(const ResultTable& table) {
    REQUIRE(table.rows.size() == 3);
    CHECK(table.rows[0].x == Rational(-1, 2));
    CHECK(table.rows[1].x == 0);
    CHECK(table.rows[2].x == Rational(1, 2));
    CHECK(table.rows[0].p == 1);
    CHECK(table.rows[1].p == Rational(3, 2));
    CHECK(table.rows[2].p == 1);
}

/// Returns the one-line message of a refused text.
std::string refusal(const std::string& text, const ResultReading& reading = {}) {
    try {
        (void)parsed_result(text, reading);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool begins(const std::string& text, const std::string& start) { return text.starts_with(start); }
bool contains_text(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
bool found(const ResultTable& table, const std::string& part) {
    for (const std::string& finding : table.findings) {
        if (contains_text(finding, part)) {
            return true;
        }
    }
    return false;
}

ResultReading with_columns(const std::string& text) {
    ResultReading reading;
    reading.columns = parse_columns(text);
    return reading;
}

ResultReading in_mm_and_MPa() {
    ResultReading reading;
    reading.units = Units{unit_named("mm"), unit_named("N"), unit_named("MPa")};
    return reading;
}

} // namespace

TEST_CASE("results: separators, decimal commas, exponents, line ends") {
    for (const std::string text : {
             "x,p\n-0.5,1\n0,1.5\n0.5,1\n",
             "x, p\r\n-0.5, 1.0\r\n0, 1.5\r\n0.5, 1\r\n",
             "x;p\n-0,5;1\n0;1,5\n0,5;1\n",
             "x\tp\r-0.5\t1\r0\t1.5\r0.5\t1",
             "  x    p\n  -5.0D-01  0.1D+01\n 0.0D+00 1.5d0\n  5.0E-1   1.\n",
             "x | p |\n-0.5 | 1 |\n0 | 1.5 |\n0.5 | 1 |\n",
             "x p\n-0,5 1,0\n0,0 1,5\n0,5 1,0\n",
             "x, p\n-0,5, 1,0\n0,0, 1,5\n0,5, 1,0\n",
             "\"x\",\"p\"\n\"-0,5\",\"1\"\n\"0\",\"1,5\"\n\"0,5\",\"1\"\n",
             "\xEF\xBB\xBFx,p\n-0.5,1\n0,1.5\n0.5,1\n",
             "x,p,\n-0x1p-1,1,\n0,0x1.8p0,\n0x1p-1,1,\n",
             // gfortran with four times the precision; Mathematica; the minus sign and a no-break
             // blank of Unicode.
             "x p\n-5.0Q-1 1.0q+0\n0.0Q0 1.5Q0\n5.Q-1 1\n",
             "x\tp\n-5.*^-1\t1\n0.\t1.5*^0\n5.*^-1\t1\n",
             "x,p\n\xE2\x88\x92"
             "0.5,1\n0,1.5\n0.5,1\n",
             "x\xC2\xA0p\n-0.5\xC2\xA0"
             "1\n0\xC2\xA0"
             "1.5\n0.5\xC2\xA0"
             "1\n",
             // Code_Aster with decimal commas.
             "#TABLE_SDASTER\n COOR_X       LAGS_C\n R            R\n -5,00000E-01  1,00000E+00\n"
             "  0,00000E+00  1,50000E+00\n  5,00000E-01  1,00000E+00\n",
             "\xEF\xBB\xBF"
             "COOR_X;LAGS_C;\r\n-5,0D-01;1,0D+00;\r\n0,0D+00;1,5D+00;\r\n5,0D-01;1,0D+00;\r\n",
         }) {
        CAPTURE(text);
        check_three(parsed_result(text));
    }
    // Fortran drops the letter if the exponent has three digits.
    const ResultTable tiny = parsed_result("x p\n1.0-103 2.5+100\n1 1\n");
    CHECK(tiny.rows[0].x.convert_to<double>() == 1e-103);
    CHECK(tiny.rows[0].p.convert_to<double>() == 2.5e100);
}

TEST_CASE("results: names, other columns, banners, comments, order") {
    for (const std::string text : {
             "# made by a program\n# x p\n-0.5 1\n0 1.5\n0.5 1\n",
             "% x, p\n-0.5, 1\n0, 1.5\n0.5, 1\n",
             "STEP 1, INCREMENT 4\n\n Node  COORD1  CPRESS\n 7 -0.5 1\n 3 0 1.5\n 9 0.5 1\nTotal "
             "3\n",
             "            Node          CPRESS     COORD.COOR1\n           Label          @Loc 1   "
             "  "
             "     @Loc 1\n-----------------\n 7 1. -500.E-03\n 3 1.5 0.\n 9 1. 500.E-03\n\n"
             "  Minimum   1.  -500.E-03\n      At Node  7  7\n\n  Total  3.5  0.\n",
             "p,x\n1,-0.5\n1.5,0\n1,0.5\n",
             "x,p\n0.5,1\n0,1.5\n-0.5,1\n",
             "x,p\n0,1.5\n0.5,1\n-0.5,1\n",
             "set,Points:0,Contact Pressure\nA,-0.5,1\nA,0,1.5\nA,0.5,1\n",
             "x,p\n-0.5,1\nx,p\n0,1.5\n\n0.5,1\n# end\n",
             "-0.5,1\n0,1.5\n0.5,1\n",
             "x [mm]  p [MPa]\n-0.5 1\n0 1.5\n0.5 1\n",
         }) {
        CAPTURE(text);
        check_three(parsed_result(text));
    }
    check_three(parsed_result("1 -0.5 9 1\n2 0 9 1.5\n3 0.5 9 1\n", with_columns("x=2,p=4")));
    check_three(parsed_result("n,place,load\n1,-0.5,1\n2,0,1.5\n3,0.5,1\n",
                              with_columns("x=place,p=load")));
    CHECK(found(parsed_result("x,p\n0.5,1\n0,1.5\n-0.5,1\n"), "from right to left"));
    CHECK(found(parsed_result("x,p\n0,1\n2,1.5\n1,1\n"), "not in the order of x"));
    CHECK(found(parsed_result("0,1\n1,1\n"), "taken to be column 1"));
    CHECK(found(parsed_result("x,p\n0,1\n1,1\nTotal\n"), "1 line of text"));
    // Text in the place of a node's number makes a line of text; a row with an empty number does
    // not count.
    CHECK(found(parsed_result("n,x,p\n1,0,1\n2,1,1\nSum,1,2\n"), "1 line of text"));
    CHECK(parsed_result("n,x,p\n1,0,1\n,1,1\n,,\n3,2,1\n").rows.size() == 3);
    CHECK(found(parsed_result("x,p\n0,1\n0,2\n1,1\n"), "repeat the x"));
    const ResultTable shear = parsed_result("x,cpress,cshear1\n0,1,0.25\n1,2,0.5\n");
    CHECK(*shear.rows[1].q == Rational(1, 2));
}

TEST_CASE("results: units that a file states are converted, exactly") {
    for (const std::string text : {
             "x [m],p [kPa]\n-0.0005,1000\n0,1500\n0.0005,1000\n",
             "x\tp\n[m]\t[kPa]\n-0.0005\t1000\n0\t1500\n0.0005\t1000\n",
             "# x p\n# (m) (kPa)\n-0.0005 1000\n0 1500\n0.0005 1000\n",
             "x_um;p_Pa\n-500;1e6\n0;1,5e6\n500;1e6\n",
             "x,p\nm,GPa\n-0.0005,0.001\n0,0.0015\n0.0005,0.001\n",
             "# units: m, Pa\nx p\n-5e-4 1e6\n0 15e5\n5e-4 1e6\n",
             "x,p\n-0.5,1\n0,1.5\n0.5,1\n",
         }) {
        CAPTURE(text);
        check_three(parsed_result(text, in_mm_and_MPa()));
    }
    CHECK(found(parsed_result("x [m],p [Pa]\n0,1\n1,2\n", in_mm_and_MPa()),
                "converted from m to mm"));
    CHECK(found(parsed_result("x [m],p\n0,1\n1,2\n"), "the scene states no units"));
    // A unit that is not known is refused, wherever it stands.
    for (const auto& [text, line] : std::vector<std::pair<std::string, std::string>>{
             {"x [furlong],p\n0,1\n1,2\n", "r.csv:1: 'furlong'"},
             {"x (mm),p (KPa)\n0,1\n1,2\n", "r.csv:1: 'KPa'"},
             {"x_inches,p_MPa\n0,1\n1,2\n", "r.csv:1: 'inches'"},
             {"x / mm,p / atm\n0,1\n1,2\n", "r.csv:1: 'atm'"},
             {"x,p\ninches,MPa\n0,1\n1,2\n", "r.csv:1: 'inches'"},
             {"x,gap [inches],p\n0,1,1\n1,1,2\n", "r.csv:1: 'inches'"},
             {"# units: mm, KPa\nx,p\n0,1\n1,2\n", "r.csv:1: 'KPa'"},
         }) {
        CAPTURE(text);
        CHECK(begins(refusal(text, in_mm_and_MPa()), line));
        ResultReading scaled = in_mm_and_MPa();
        parse_scale("x=1,p=1", scaled);
        CHECK(parsed_result(text, scaled).rows.size() == 2);
    }
    CHECK(parsed_result("x [-],p [1]\n0,1\n1,2\n", in_mm_and_MPa()).rows.size() == 2);
    CHECK(begins(refusal("x [MPa],p\n0,1\n1,2\n", in_mm_and_MPa()), "r.csv:1: x is in MPa"));
}

TEST_CASE("results: scale") {
    ResultReading scaled;
    parse_scale("x=0.001,p=1e6", scaled);
    check_three(parsed_result("x,p\n-500,1e-6\n0,1.5e-6\n500,1e-6\n", scaled));
    // The user's units have precedence over those in the file.
    ResultReading both = in_mm_and_MPa();
    parse_scale("x=1", both);
    check_three(parsed_result("x [m],p\n-0.5,1\n0,1.5\n0.5,1\n", both));
    for (const char* bad : {"x", "x=", "x=0", "x=-1", "y=2", "x=a", "", "x=1,"}) {
        CAPTURE(bad);
        ResultReading none;
        CHECK_THROWS_AS(parse_scale(bad, none), InputError);
    }
    for (const char* bad : {"x", "x=1,y=2", "x=1,x=2", "", "1,2"}) {
        CAPTURE(bad);
        CHECK_THROWS_AS((void)parse_columns(bad), InputError);
    }
}

TEST_CASE("results: a mark that may stand between thousands is refused, and decimals are not") {
    for (const std::string text : {
             "x\tp\n-0.5\t975\n0\t1,031\n0.5\t975\n",
             "x\tp\n-0.5\t0\n0\t1,031\n0.5\t0\n",
             "x;p\n-0,5;975\n0;1.031\n0,5;975\n",
             "x,p\n-1,975\n0,\"1,031\"\n1,975\n",
         }) {
        CAPTURE(text);
        CHECK(contains_text(refusal(text), "r.csv:3: '1"));
        CHECK(contains_text(refusal(text), "' may be 1031, or a decimal"));
    }
    CHECK(parsed_result("x\tp\n-0,5\t0\n0\t1,125\n0,5\t0\n").rows[1].p == Rational(9, 8));
    CHECK(parsed_result("x p\n-1 1.5\n0 2.125\n1 2\n").rows[1].p == Rational(17, 8));
    CHECK(parsed_result("x;p\n-1;0,000\n0;1,125\n1;0,000\n").rows[1].p == Rational(9, 8));
    CHECK(contains_text(refusal("x;p\n-1;975,5\n0;1.031,5\n1;975,5\n"), "marks between thousands"));
}

TEST_CASE("results: rows without a number before the first complete row are refused") {
    CHECK(contains_text(refusal("x,p\n-1,NaN\n0,1\n1,0\n"), "r.csv:2: the row holds 'NaN'"));
    CHECK(contains_text(refusal("x,p\n\xE2\x80\x93"
                                "1,1\n0,1\n1,0\n"),
                        "r.csv:2: "));
    CHECK(contains_text(refusal("x,p\n-1,-\n0,1\n1,0\n"), "r.csv:2: '-' of p is no number"));
}

TEST_CASE("results: no row is left out because of text in its cells") {
    const std::pair<const char*, const char*> cases[] = {
        {"n,x,p\n1,0,1\nn2,1,1\n3,2,1\n", "r.csv:3: 'n2' of column 1 is no number"},
        {"x,p\n0,1\n1 mm,2 MPa\n2,1\n3,1\n", "r.csv:3: '1 mm' of x is no number"},
        {"x,p\n0 mm,1 MPa\n1,2\n2,1\n", "r.csv:2: '0 mm' of x is no number"},
        {"0 mm,1 MPa\n1,2\n2,1\n", "r.csv:1: '0 mm' of x is no number"},
        {"set,x,p\nA,0,1\nA,1mm,2MPa\nA,2,1\n", "r.csv:3: '1mm' of x is no number"},
        {"x p\n0 1\n1 mm 2 MPa\n2 1\n3 1\n", "r.csv:3: 'mm' of p is no number"},
        {"x p\n0 1\n***** 2\n2 1\n3 1\n", "r.csv:3: '*****' of x is no number"},
    };
    for (const auto& [text, message] : cases) {
        CAPTURE(text);
        const std::string found = refusal(text);
        CHECK_MESSAGE(begins(found, message), found);
    }
}

TEST_CASE("results that cannot be read: one line, with the place") {
    CHECK(begins(refusal(""), "r.csv: the file is empty"));
    CHECK(begins(refusal("\n \n"), "r.csv: the file is empty"));
    CHECK(begins(refusal("just some words\nand more\n"), "r.csv: there is no row of two numbers"));
    CHECK(begins(refusal("x,p\n"), "r.csv: there is no row"));
    CHECK(begins(refusal("x,p\n1,2\n"), "r.csv:2: there is one row"));
    CHECK(begins(refusal("x,p\n1,2\n1,3\n1,1\n"), "r.csv:2: every row has the same x"));
    CHECK(begins(refusal("x\n1\n2\n3\n"), "r.csv: there is no row of two numbers"));
    CHECK(begins(refusal("x,p\n1,2\n2,NaN\n3,1\n"), "r.csv:3: the row holds 'NaN'"));
    CHECK(begins(refusal("x,p\n1,2\ninf,1\n3,1\n"), "r.csv:3: the row holds 'inf'"));
    CHECK(begins(refusal("x,p\n1,2\n2,abc\n3,1\n"), "r.csv:3: 'abc' of p is no number"));
    CHECK(begins(refusal("x,p\n1,2\nabc,2\n3,1\n"), "r.csv:3: 'abc' of x is no number"));
    CHECK(begins(refusal("x,p\n1,2\n2\n3,1\n"), "r.csv:3: the row is cut off"));
    CHECK(begins(refusal("x,p\n1,2\n2,3,4\n3,1\n"), "r.csv:3: the row has 3 cells"));
    CHECK(begins(refusal("x,p\n1,2\n2,1e999\n3,1\n"), "r.csv:3: '1e999' is beyond"));
    CHECK(begins(refusal("1 2 3\n4 5 6\n"), "r.csv: the rows have 3 columns and no header"));
    CHECK(begins(refusal("n,u,v\n1,2,3\n4,5,6\n"), "r.csv:1: no column has the name x"));
    CHECK(
        begins(refusal("x,p,pressure\n1,2,3\n4,5,6\n"), "r.csv:1: columns 2 and 3 may both be p"));
    CHECK(begins(refusal("x,p\n0,5,1,5\n1,5,1,0\n"), "r.csv:1: the header names 2 columns"));
    CHECK(begins(refusal("0,5, 1,5\n1,5, 1,0\n"), "r.csv:1: commas may be decimal"));
    CHECK(contains_text(refusal("n,u,v\n1,2,3\n4,5,6\n"),
                        "--columns x=N, one of 1 (n), 2 (u), 3 (v)"));
    CHECK(contains_text(refusal("x,p,pressure\n1,2,3\n4,5,6\n"), "--columns p=2 or p=3"));
    CHECK(begins(refusal("\xFF\xFEx"), "r.csv: the file is in UTF-16 with an incomplete"));
    // Half of a pair of UTF-16.
    CHECK(begins(refusal(std::string("\xFF\xFE\x00\xD8x\x00", 6)), "r.csv: the file is in UTF-16"));
    CHECK(contains_text(refusal("x,p\n1,2\n2,3\n", with_columns("x=1,p=3")), "no such column"));
    CHECK(
        contains_text(refusal("x,p\n1,2\n2,3\n", with_columns("x=1,p=1")), "one column is taken"));
}

TEST_CASE("results: tables as Workbench, COMSOL and Code_Aster write them") {
    check_three(parsed_result("Node Number\tX Location (mm)\tY Location (mm)\tPressure (MPa)\n"
                              "1\t-0.5\t0\t1\n2\t0\t0\t1.5\n3\t0.5\t0\t1\n",
                              in_mm_and_MPa()));
    check_three(parsed_result("% Model,hertz.mph\n% x (m),solid.Tn (N/m^2)\n"
                              "-5e-4,1e6\n0,1.5e6\n5e-4,1e6\n",
                              in_mm_and_MPa()));
    const ResultTable steps =
        parsed_result("% x (mm)      y      solid.Tn (N/m^2) @ t=0.5   solid.Tn (N/m^2) @ t=1\n"
                      "-0.5  0  2e5  1e6\n0  0  3e5  1.5e6\n0.5  0  2e5  1e6\n",
                      in_mm_and_MPa());
    check_three(steps);
    CHECK(found(steps, "p has 2 steps: the last is compared"));
    check_three(parsed_result("#TABLE\n INST NOEUD COOR_X COOR_Y LAGS_C\n"
                              " 1.0 N1 -0.5 0 1\n 1.0 N2 0 0 1.5\n 1.0 N3 0.5 0 1\n"));
}

TEST_CASE("results: of several load steps at the same places the last is compared") {
    const std::string rows = "1,-0.5,7\n1,0,8\n1,0.5,7\n2,-0.5,1\n2,0,1.5\n2,0.5,1\n";
    const ResultTable last = parsed_result("Step,x,p\n" + rows);
    check_three(last);
    CHECK(found(last, "column 1 has 2 steps: the last, '2', is compared"));
    CHECK(last.rows[1].line == 6);
    // Steps are numbers, in any order, and increments are parts of them.
    check_three(
        parsed_result("Step,x,p\n2,-0.5,1\n2.0,0,1.5\n2,0.5,1\n1,-0.5,7\n1,0,8\n1,0.5,7\n"));
    check_three(parsed_result("x,p,Step\n-0.5,7,Step-9\n0,8,Step-9\n0.5,7,Step-9\n"
                              "-0.5,1,Step-10\n0,1.5,Step-10\n0.5,1,Step-10\n"));
    check_three(parsed_result("inc,step,x,p\n9,1,-0.5,7\n9,1,0,8\n9,1,0.5,7\n"
                              "2,2,-0.5,1\n2,2,0,1.5\n2,2,0.5,1\n1,2,-0.5,3\n1,2,0,3\n"));
    check_three(parsed_result("x,solid.Tn (Pa) @ t=10,solid.Tn (Pa) @ t=9\n-0.5,1,7\n0,1.5,8\n"
                              "0.5,1,7\n"));
    CHECK(begins(refusal("step,x,p\n1,-0.5,1\n2,0,1.5\n1,0.5,1\n2,-0.5,1\n"),
                 "r.csv:4: the steps are mixed"));
    CHECK(begins(refusal("step,x,p\nload,0,1\nload,1,1\nunload,0,2\nunload,1,2\n"),
                 "r.csv:2: 'load' is no number of a step"));
    // A column of another name does not divide the rows, and neither do steps at other places.
    CHECK(parsed_result("part,x,p\n" + rows).rows.size() == 6);
    check_three(parsed_result("time,x,p\n1,-0.5,1\n2,0,1.5\n3,0.5,1\n"));
}

TEST_CASE("results: UTF-16 with a byte order mark is read as the same text in UTF-8") {
    // The micro sign, and a letter beyond 16 bits (U+1D465 is D835 DC65).
    const std::u16string text =
        u"# \u00B5 \u2202 \xD835\xDC65\r\nx,p\r\n-0.5,1\r\n0,1.5\r\n0.5,1\r\n";
    for (const bool big_endian : {false, true}) {
        std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
        for (const char16_t c : text) {
            const char high = static_cast<char>(c >> 8);
            const char low = static_cast<char>(c & 0xFF);
            bytes += big_endian ? high : low;
            bytes += big_endian ? low : high;
        }
        check_three(parsed_result(bytes));
    }
}

TEST_CASE("results: Latin-1, and names in German, French and Italian") {
    // The micro sign is B5 and the raised 2 is B2.
    check_three(parsed_result("x [\xB5m];p [N/mm\xB2]\n-500;1\n0;1,5\n500;1\n", in_mm_and_MPa()));
    check_three(parsed_result("Knotennummer\tX-Position (mm)\tY-Position (mm)\tDruck (MPa)\n"
                              "1\t-0,5\t0,\t1,0\n2\t0,0\t0,\t1,5\n3\t0,5\t0,\t1,0\n",
                              in_mm_and_MPa()));
    for (const std::string name : {"Pression", "Pression de contact", "Pressione", "Presi\xF3n",
                                   "Presi\xC3\xB3n", "Kontaktdruck"}) {
        CAPTURE(name);
        check_three(parsed_result("x," + name + "\n-0.5,1\n0,1.5\n0.5,1\n"));
    }
}

TEST_CASE("results: blanks separate the columns, and a name has several words") {
    const std::string rows = "7 -0.5 1\n3 0 1.5\n9 0.5 1\n";
    for (const std::string header : {
             "Node Label  COORD1  CPRESS",
             "Node Label X Contact Pressure",
             "node number true distance along path contact pressure",
             "Node Label x mm p MPa",
             "# Node Label x Contact Pressure",
             "Element ID X Coordinate [mm] Normal Traction [MPa]",
         }) {
        CAPTURE(header);
        check_three(parsed_result(header + "\n" + rows, in_mm_and_MPa()));
    }
    // Units count if they are words of the header.
    check_three(parsed_result("Node Label x m p kPa\n7 -5e-4 1e3\n3 0 1.5e3\n9 5e-4 1e3\n",
                              in_mm_and_MPa()));
    // Two columns, and one with text.
    check_three(parsed_result("X Contact Pressure\n-0.5 1\n0 1.5\n0.5 1\n"));
    check_three(parsed_result("Part Instance Node Label COORD1 CPRESS\nA 7 -0.5 1\nA 3 0 1.5\n"
                              "A 9 0.5 1\n"));
    // A title of words is not a header: in a table with a header, and in one without.
    check_three(parsed_result("Contact Pressure over x\nNode Label x p\n" + rows));
    const auto is_refused = [&](const std::string& header) {
        const std::string line = refusal(header + "\n" + rows);
        CAPTURE(line);
        return begins(line, "r.csv:1: the header names 4 columns, and the rows have 3") &&
               contains_text(line, "Node_Label") && contains_text(line, "--columns x=1,p=2");
    };
    CHECK(is_refused("Contact Pressure over x"));
    CHECK(is_refused("Gauge Name x p"));
    // This may mean Coord X | Pos | p, or Coord | X Pos | p.
    CHECK(is_refused("Coord X Pos p"));
    // The advice of the message works.
    check_three(parsed_result("Gauge Name x p\n" + rows, with_columns("x=2,p=3")));
    check_three(parsed_result("Gauge_Name x p\n" + rows));
    check_three(parsed_result("'Gauge Name' x p\n" + rows));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/parse.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

namespace {

const Symbols parsed_symbols = [] {
    Symbols s{"a", "b", "m", "P1", "x"};
    s.add_function("slope", 1).add_function("kernel", 2);
    return s;
}();

Rational rational(std::string_view text) {
    const Expr e = parse(text);
    REQUIRE_MESSAGE(e.rational() != nullptr, text);
    return *e.rational();
}

/// Checks items "formula = value".
void check_values(const char* items) {
    test::for_pairs(items, " = ", [](const auto& text, const auto& value) {
        CHECK(rational(text) == Rational(value));
    });
}

/// Returns the error in a text.
FormulaError refusal(const std::string& text, const Symbols& symbols) {
    try {
        (void)parse(text, symbols);
    } catch (const FormulaError& error) {
        return error;
    }
    FAIL("accepted: " << text.substr(0, 80));
    return {"", ""};
}
FormulaError error_of(const std::string& text) { return refusal(text, parsed_symbols); }

bool is_at_column(const FormulaError& error, std::size_t column) {
    return (error.problem() + " ").find(" at column " + std::to_string(column) + " ") !=
               std::string::npos ||
           error.problem().find(" at column ") == std::string::npos;
}

} // namespace

TEST_CASE("operators bind as in mathematics") {
    check_values(R"ITEMS(
        -2^2 = -4   (-2)^2 = 4   2^3^2 = 512   (2^3)^2 = 64   2^-2 = 1/4   2^-1^2 = 1/2
        24/4/3 = 2   24/(4/3) = 18   10-4-3 = 3   10-(4-3) = 9   2+3*4 = 14   -3*-4 = 12
        7 - -2 = 9   --5 = 5   +5 - +2 = 3   6/2*3 = 9   1/2^3 = 1/8
    )ITEMS");
}

TEST_CASE("numbers are exact") {
    check_values(R"ITEMS(
        0.1 + 0.2 - 0.3 = 0   0.1 = 1/10   .5 = 1/2   5. = 5   1.25E2 = 125   00012.50 = 25/2
        1e-30*1e+30 = 1   0.0 = 0   0e99999 = 0   1e100000/1e99999 = 10   sqrt(9/16) = 3/4
        8^(2/3) = 4   max(1/3, 0.3, 1/4) = 1/3
    )ITEMS");
    // A decimal of 60 digits keeps the last digit.
    CHECK(rational("0.123456789012345678901234567890123456789012345678901234567891") -
              rational("0.12345678901234567890123456789012345678901234567890123456789") ==
          rational("1e-60"));
}

TEST_CASE("names") {
    CHECK(parse("Pi").kind() == Expr::Kind::pi);
    CHECK(parse("pi") == parse("Pi"));
    CHECK(parse("a*P1 + slope(x)", parsed_symbols).arg(1).name() == "slope");
    const Expr f = parse("integral(s*x/sqrt(a^2 - s^2), s, 0, a)", parsed_symbols);
    CHECK(f.kind() == Expr::Kind::integral);
    CHECK(free_symbols(f) == std::set<std::string>{"a", "x"});
    CHECK(parse("pv(slope(s)/(s - x), s, -b, a, x)", parsed_symbols).args().size() == 5);
    // The bound variable is known only in the first argument.
    CHECK(error_of("integral(s, s, 0, s)").problem() == "unknown name 's' at column 19");
    CHECK(error_of("integral(s, s, 0, 1) + s").problem() == "unknown name 's' at column 24");
}

TEST_CASE("an unknown name is an error that lists the names that may be used") {
    const FormulaError e = error_of("a + bb");
    CHECK(e.problem() == "unknown name 'bb' at column 5");
    CHECK(e.instead() == "use one of: P1, a, b, m, x, Pi");
    CHECK(std::string(e.what()) == "unknown name 'bb' at column 5; use one of: P1, a, b, m, x, Pi");
    CHECK_THROWS_AS((void)parse("a"), FormulaError);
    for (const char* name : {"E", "e", "I", "inf", "nan", "NaN", "Infinity", "ln", "PI", "c"}) {
        CHECK_THROWS_AS((void)parse(name, parsed_symbols), FormulaError);
        CHECK_THROWS_AS((void)parse("1 + " + std::string(name), parsed_symbols), FormulaError);
    }
    CHECK(error_of("e").instead().find("exp(1)") != std::string::npos);
    CHECK(error_of("arctan(a)").instead() == "write atan(...)");
}

TEST_CASE("names with a meaning of their own cannot be given to variables") {
    Symbols s;
    for (const char* name : {"e", "I", "pi", "Pi", "inf", "nan", "sqrt", "pv", "integral", "", "1a",
                             "a b", "a'", "\xC3\xA9"}) {
        CHECK_THROWS_AS(s.add(name), InputError);
        CHECK_THROWS_AS(s.add_function(name, 1), InputError);
    }
    CHECK(s.variables().empty());
}

TEST_CASE("malformed text is one line of error, with its place") {
    const auto check = [](const std::string& text, std::size_t offset) {
        CAPTURE(text);
        const FormulaError e = error_of(text);
        CHECK(is_at_column(e, offset + 1));
        const std::string line = e.what();
        CHECK(line.find('\n') == std::string::npos);
        CHECK(line.find('\0') == std::string::npos);
        CHECK_FALSE(e.problem().empty());
        CHECK_FALSE(e.instead().empty());
    };
    const std::pair<std::size_t, const char*> by_offset[] = {
        {0, R"(a(b)   Pi(2)   (a   ((a)   * a   sqrt()   sqrt   sqrt(1, 2)   kernel(1)   slope)"},
        {0, R"(1.2.3   .   1..2   [a]   \frac{a}{b}   integral(x, x, 0)   pv(x, x, 0, 1)   #)"},
        {1, R"(2a   2(a+b)   a)   ()   a, b   1e   1e+   0x10   a; b   1,5)"},
        {2, R"(2 a   a b   a ** 2   a = b   a < b   a^   a^^2)"},
        {3, R"((a)(b)   a */ b)"},
        {4, R"(sqrt(a)"},
        {7, R"(sqrt(a,))"},
        {12, R"(integral(x, 2, 0, 1)   integral(x, Pi, 0, 1)   integral(x, e, 0, 1))"},
        {15, R"(pv(x, x, 0, 1, c))"},
    };
    for (const auto& [offset, texts] : by_offset) {
        for (const std::string& text : test::items(texts)) {
            check(text, offset);
        }
    }
    check("", 0);
    check(" ", 0);
    check("a + ", 4);
    check("a + + ", 6);
    check("a\xE2\x88\x92"
          "b",
          1);
    check("\xCF\x80", 0);
    check(std::string("a\0b", 3), 1);
    check("a\x01", 1);
    check("a\xFF", 1);
    CHECK_FALSE(error_of("P'(a)").instead().empty());
    CHECK(error_of("2a").problem() == "a '*' is missing at column 2");
    CHECK(error_of("\xCF\x80 c").problem() == "unexpected '\xCF\x80' at column 1");
    CHECK(error_of("a + \xFF").problem() == "unexpected '\\xff' at column 5");
}

TEST_CASE("the parser does not crash, hang or fill the memory for any text") {
    for (const std::size_t n : {std::size_t{201}, std::size_t{5000}, std::size_t{9999}}) {
        CHECK_THROWS_AS((void)parse(test::repeated("(", n) + "1" + test::repeated(")", n)),
                        FormulaError);
        CHECK_THROWS_AS((void)parse(test::repeated("-", n) + "1"), FormulaError);
        CHECK_THROWS_AS((void)parse(test::repeated("(", n)), FormulaError);
        CHECK_THROWS_AS((void)parse(test::repeated("1^", n) + "1"), FormulaError);
    }
    for (const std::string& text :
         {test::repeated("sqrt(", 3000), test::repeated("(", 100'000),
          test::repeated("1+", 9000) + "1", test::repeated("1e100000+", 1000) + "1",
          test::repeated("9", 20'001), std::string("1e999999999"), std::string("1e-999999999"),
          std::string("1e99999999999999999999999999"), std::string("1e100001"),
          std::string("10e100000"), std::string("0.1e-100000")}) {
        CHECK_THROWS_AS((void)parse(text), FormulaError);
    }
    CHECK(rational("0e999999999") == 0);
    // Powers that would be too large are not computed.
    CHECK(parse("9^9^9^9").rational() == nullptr);
    CHECK(parse("2^1e100000").rational() == nullptr);
    CHECK(parse("(1 + 1e-1000)^100000").rational() == nullptr);
    CHECK(rational("1^9^9") == 1);
    CHECK(rational("(-1)^1e100000") == 1);
    // Texts at the limits are accepted.
    CHECK(rational(test::repeated("(", 200) + "1" + test::repeated(")", 200)) == 1);
    CHECK(rational(test::repeated("-", 200) + "1") == 1);
    CHECK(rational(test::repeated("1+", 1990) + "1") == 1991);
    const std::string tower = test::repeated("1+", 1999) + "1)";
    CHECK_THROWS_AS((void)parse(std::string("-(").append(tower)), FormulaError);
    CHECK_THROWS_AS((void)parse(std::string("(").append(tower).append("^2")), FormulaError);
    CHECK_THROWS_AS((void)parse(std::string("abs(").append(tower)), FormulaError);
}

TEST_CASE("random strings are expressions or errors, nothing else") {
    const std::vector<std::string> pieces{
        "a",  "b",    "x",    "Pi", "pi",  "sqrt", "slope",   "kernel", "integral", "pv", "sum",
        "(",  "(",    "(",    ")",  ")",   ")",    ",",       "+",      "-",        "*",  "/",
        "^",  "**",   " ",    "1",  "2.5", ".",    "1e",      "1e5",    "e",        "s",  "\n",
        "\t", "\xCF", "\x80", "'",  "[",   "=",    "1e99999", "gamma",  "max",      "0",  "\x01"};
    std::mt19937_64 random(20250101);
    int accepted = 0;
    for (int i = 0; i < 40'000; ++i) {
        std::string text;
        for (std::size_t n = 1 + random() % 14; n > 0; --n) {
            text += pieces[random() % pieces.size()];
        }
        CAPTURE(text);
        try {
            const Expr e = parse(text, parsed_symbols);
            ++accepted;
            CHECK(parse(to_text(e), parsed_symbols) == e);
        } catch (const FormulaError& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
        }
    }
    CHECK(accepted > 400);
}

TEST_CASE("places in the text are kept") {
    const std::string text = " 2*sqrt(a ) + (b - 1)^2/3 ";
    const Expr e = parse(text, parsed_symbols);
    const auto slice = [&](const Expr& x) { return text.substr(x.offset(), x.length()); };
    CHECK(slice(e) == "2*sqrt(a ) + (b - 1)^2/3");
    CHECK(slice(e.arg(0)) == "2*sqrt(a )");
    CHECK(slice(e.arg(0).arg(1)) == "sqrt(a )");
    CHECK(slice(e.arg(1)) == "(b - 1)^2/3");
    CHECK(slice(e.arg(1).arg(0)) == "(b - 1)^2");
    CHECK(slice(e.arg(1).arg(0).arg(0)) == "b - 1");
}

TEST_CASE("a number with a unit is refused: numbers have no units") {
    for (const char* text :
         {"70 GPa", "70GPa", "1e3 Pa", "0.5mm", "2.5e-3 m", "(70 GPa)/2", "3 N/mm^2", "1 kN"}) {
        CAPTURE(text);
        CHECK(refusal(text, {}).problem().find("numbers have no units here: '") == 0);
        CHECK(refusal(text, {}).instead().find("write the number alone") == 0);
    }
    CHECK(refusal("70*GPa", Symbols{"a"}).instead().find("numbers have no units here") == 0);
    CHECK(refusal("70 GPa*a", Symbols{"a"}).problem().find("numbers have no units here") == 0);
    // These may be products.
    for (const char* text : {"2pi", "2 sqrt(2)", "2Pi/3"}) {
        CHECK(refusal(text, {}).problem().find("a '*' is missing") == 0);
    }
    for (const char* text : {"2x", "2 y", "3 gamma(x)"}) {
        CHECK(refusal(text, Symbols{"x"}).problem().find("a '*' is missing") == 0);
    }
}

TEST_CASE("a misspelled name in a formula: the near name is suggested") {
    const Symbols symbols{"alpha", "gam", "x"};
    const auto instead = [&](const char* text) { return refusal(text, symbols).instead(); };
    CHECK(instead("alhpa*x").find("did you mean alpha? use one of: ") == 0);
    CHECK(instead("X").find("did you mean x? ") == 0);
    CHECK(instead("sqr(x)").find("did you mean sqrt? ") == 0);
    CHECK(instead("atanh2(x)").find("did you mean atan") == 0);
    CHECK(instead("unrelated").find("use one of: ") == 0);
    CHECK(instead("arcsin(x)") == "write asin(...)");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/toml/toml_section.hpp"

#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

namespace {

TomlSection parsed(const std::string& text) { return TomlSection::parse(text, "some.toml"); }

/// Returns the error that f throws, or an error that states that there was none.
template <class F> InputError error_of(const F& f) {
    try {
        f();
    } catch (const InputError& error) {
        return error;
    }
    return {"nothing was refused", ""};
}
InputError refusal(const std::string& text) {
    return error_of([&] { (void)parsed(text); });
}

} // namespace

TEST_CASE("a bare number is the text of the file, with any text before it on the line") {
    // Characters of one, two, three and four bytes, a tab, escapes, other numbers.
    const std::vector<std::string> before{
        "",       "\"γ\", ",       "\"γγγγ\", ", "'€ uro', ",       "\"😀\", ",     "\t",
        "\t\t  ", "\"\\u03b3\", ", "1.5, ",      "\"\"\"γ\"\"\", ", "'''\tγ''', ", "-7.25e-3, "};
    struct Number {
        const char* written;
        const char* value;
    };
    const Number numbers[] = {
        {"0.25", "0.25"},         {"+0.25", "0.25"},
        {"-0.25", "-0.25"},       {"1e3", "1000"},
        {"2.5E-3", "0.0025"},     {"1_000.5", "1000.5"},
        {"0.1", "0.1"},           {"1e-30", "1e-30"},
        {"1e+22", "1e22"},        {"-0.0", "0"},
        {"6.02e+2_0", "6.02e20"}, {"9.87654321012345e-300", "9.87654321012345e-300"}};
    for (const std::string& mark : {std::string(), std::string("\xEF\xBB\xBF")}) {
        for (const std::string& end : {std::string("\n"), std::string("\r\n"), std::string()}) {
            for (const std::string& text : before) {
                for (const Number& number : numbers) {
                    CAPTURE(text);
                    CAPTURE(number.written);
                    const std::string file = mark + "k = [" + text + number.written + "]" + end;
                    CAPTURE(file);
                    const std::string last = parsed(file).written_list("k").back();
                    CHECK(parse_decimal(last) == parse_decimal(number.value));
                }
            }
        }
    }
}

TEST_CASE("numbers in inline tables, dotted keys, lists over lines and arrays of tables") {
    const TomlSection top = parsed("# γ\r\n"
                                   "t = { name = \"γ\", \"κ\" = 0.25, x.y = 0.125 } # 0.5\r\n"
                                   "\"Γ\".b.c = 0.75\r\n"
                                   "list = [ 'γ',\r\n"
                                   "\t0.1, # γ 0.2\r\n"
                                   "\t+0.3 ]\r\n"
                                   "text = '''\r\n"
                                   "γ = 0.9 \"\"\" '' \r\n"
                                   "''''\r\n"
                                   "[[part]] # γ\r\n"
                                   "v = 1.5\r\n"
                                   "[[part]]\r\n"
                                   "v = \"γ\"\r\n"
                                   "w = 7\r\n");
    CHECK(top.section("t").written("κ") == "0.25");
    CHECK(top.section("t").section("x").written("y") == "0.125");
    CHECK(top.section("Γ").section("b").written("c") == "0.75");
    CHECK(top.written_list("list") == std::vector<std::string>{"γ", "0.1", "0.3"});
    CHECK(top.text("text") == "γ = 0.9 \"\"\" '' \n'");
    const auto parts = top.sections("part");
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].exact("v").rational() == Rational(3, 2));
    CHECK(parts[1].text("v") == "γ");
    CHECK(parts[1].count("w", 0, 9) == 7);
    CHECK(parts[0].line() == 10);
    CHECK(parts[1].line("w") == 14);
    CHECK(top.keys() == std::vector<std::string>{"t", "Γ", "list", "text", "part"});
    CHECK(top.sections_or_none("none").empty());
    CHECK(top.written_or("none", "x") == "x");
}

TEST_CASE("a float that another reader would cut off is refused with its digits, quoted") {
    const InputError error =
        error_of([] { (void)parsed("\n\nk = [\"γ\", 0.12345678901234567]").written_list("k"); });
    CHECK(std::string(error.what()) ==
          "some.toml:3: k = 0.12345678901234567 has more than 15 significant digits as a float; "
          "quote it: \"0.12345678901234567\"");
    for (const char* none : {"inf", "-inf", "nan", "+nan"}) {
        const auto read = [&] { (void)parsed("k = " + std::string(none)).written("k"); };
        CHECK(error_of(read).problem() == "k is not a finite number");
    }
}

TEST_CASE("a missing key, or one of another kind, is refused with the line") {
    const TomlSection top = parsed("a = 1\nb = [1, 2]\n[c]\nd = \"x\"\n[[e]]\n");
    const auto line_of = [](const auto& f) { return error_of(f).line(); };
    CHECK(line_of([&] { (void)top.text("a"); }) == 1);
    CHECK(line_of([&] { (void)top.section("b"); }) == 2);
    CHECK(line_of([&] { (void)top.sections("b"); }) == 2);
    CHECK(line_of([&] { (void)top.sections("c"); }) == 3);
    CHECK(line_of([&] { (void)top.section("c").text("z"); }) == 3);
    CHECK(line_of([&] { (void)top.section("c").count("d", 0, 9); }) == 4);
    CHECK(line_of([&] { (void)top.written("e"); }) == 5);
    CHECK(line_of([&] { top.allow({"a", "b", "c"}); }) == 5);
    CHECK(line_of([&] { (void)top.section("z"); }) == 1);
}

TEST_CASE("depth: names joined by dots, and brackets, that nest too deep are refused") {
    for (const std::size_t deep : {std::size_t{32}, std::size_t{300}, std::size_t{50'000}}) {
        for (const std::string& text :
             {test::repeated("a.", deep) + "a = 1", "[" + test::repeated("a.", deep) + "a]",
              "[[" + test::repeated("a.", deep) + "a]]", test::repeated("\"a\" . ", deep) + "a = 1",
              test::repeated("'.'\t.\t", deep) + "a = 1",
              "k = { " + test::repeated("a.", deep) + "a = 1 }",
              test::repeated("γ-1.", deep) + "a = 1", test::repeated("\"! \\\"\".", deep) + "a = 1",
              "k = [ \"\"\"\"a\"\"\"\"\", { " + test::repeated("\" \".", deep) + "a = 1 } ]",
              "[" + test::repeated("' '.", deep) + "a]"}) {
            CAPTURE(text.substr(0, 40));
            const InputError error = refusal("x = 1 # a comment\n" + text);
            CHECK(error.problem().find("32 levels deep") != std::string::npos);
            CHECK(error.line() == 2);
        }
    }
    for (const char* open : {"[", "[\n# ]]]\n", "{ a = "}) {
        const InputError error = refusal("k = " + test::repeated(open, 50'000));
        CHECK(error.problem().starts_with("not TOML:"));
        CHECK(std::string(error.what()).size() < 300);
    }
}

TEST_CASE("depth: other dots and brackets do not count, and 31 levels are read") {
    const std::string dots =
        test::repeated(".", 200) + test::repeated("[{", 100) + test::repeated("0.5 e.g. a.b.", 100);
    CHECK(parsed("k = \"" + dots + "\"").text("k") == dots);
    CHECK(parsed("k = '" + dots + "' # " + dots + "\nl = 1").written("l") == "1");
    CHECK(parsed("\"" + dots + "\" = 3").written(dots) == "3");
    CHECK(parsed("k = [" + test::repeated("0.5, 0.25,\n", 100) + "]").written_list("k").size() ==
          200);
    TomlSection section = parsed(test::repeated("a.", 31) + "k = 1");
    for (int level = 0; level < 31; ++level) {
        section = section.section("a");
    }
    CHECK(section.written("k") == "1");
    CHECK_NOTHROW((void)parsed("k = " + test::repeated("[", 32) + test::repeated("]", 32)));
}

TEST_CASE("a file of more than 10 MB is refused, one of less is read") {
    CHECK(refusal(test::repeated("# 45678\n", most_toml_bytes / 8 + 1)).problem().find("bytes") !=
          std::string::npos);
    CHECK(parsed(test::repeated("# 4567\n", 100'000) + "k = 1").line("k") == 100'001);
}

TEST_CASE("control characters are refused with their line, as escapes too") {
    for (const char* text : {"k = 1\nl = \"\\u001b[31m\"", "k = 1\nl = [ [ \"\\u0007\" ] ]",
                             "k = 1\n\"\\u009b1m\" = 2", "k = 1\nl = { m = \"\\u007f\" }",
                             "k = 1\nl = \"\\b\"", "k = 1\nl = \"\x1b[31m\""}) {
        CAPTURE(text);
        CHECK(refusal(text).line() == 2);
    }
    CHECK(parsed("k = \"a\\tb\\nγ\\u00a0\"").text("k") == "a\tb\nγ\u00a0");
}

TEST_CASE("text that is not TOML is refused in one line with its place") {
    for (const char* text : {"[a\n", "a = \n", "a = 1\na = 2", "= 1", "a = 'x", "a = \"\\q\"",
                             "a = 99999999999999999999", "a = 1 b = 2", "\xff", "a.b = 1\na = 2"}) {
        CAPTURE(text);
        const InputError error = refusal(text);
        CHECK(error.problem().substr(0, 9) == "not TOML:");
        CHECK(error.line() >= 1);
        CHECK_FALSE(error.instead().empty());
        CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
}

TEST_CASE("tables made in memory are read as those of a file, and errors name the lines given") {
    const TomlSection top = TomlSection::made(
        {{"load", 3, {{"a", "3/2", 5}, {"symmetric", true, 6}}},
         {"profile", 7, {{"knots", std::vector<std::string>{"1/3", "2*"}, 9}, {"kind", "x", 8}}}},
        "row.csv");
    const TomlSection load = top.section("load");
    CHECK(load.exact("a").text() == "3/2");
    CHECK(load.flag("symmetric"));
    CHECK(load.line() == 3);
    CHECK(load.line("symmetric") == 6);
    CHECK(load.line("b") == 3);
    CHECK(load.keys() == std::vector<std::string>{"a", "symmetric"});
    const TomlSection profile = top.section("profile");
    CHECK(profile.texts("knots") == std::vector<std::string>{"1/3", "2*"});
    const auto place = [](const auto& f) {
        try {
            f();
        } catch (const InputError& error) {
            return error.file() + ":" + std::to_string(error.line());
        }
        return std::string("accepted");
    };
    CHECK(place([&] { (void)profile.exacts("knots"); }) == "row.csv:9");
    CHECK(place([&] { profile.allow({"knots"}); }) == "row.csv:8");
    CHECK(place([&] { (void)load.text("kind"); }) == "row.csv:3");
    CHECK(place([&] {
              (void)TomlSection::made({{"load", 1, {{"a", "1\x7f", 2}}}}, "row.csv");
          }) == "row.csv:2");
}

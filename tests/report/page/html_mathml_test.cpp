// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html_mathml.hpp"

#include "edgeproof/formula/parse.hpp"
#include "tests/report/well_formed.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

Symbols symbols() {
    Symbols s{"a",  "b",   "x",   "u", "m", "C", "Es",       "P1", "P2",   "b3",
              "P5", "phi", "gam", "t", "s", "k", "right_c1", "p0", "R_max"};
    s.add_function("Pof", 1);
    s.add_function("binv", 1);
    s.add_function("p", 1);
    return s;
}
std::string mathml(const char* text) { return to_mathml(parse(text, symbols())); }

/// What is left when all tags are taken away: the order in which a reader meets the characters.
std::string text_of(const std::string& markup) {
    std::string out;
    bool tag = false;
    for (const char c : markup) {
        if (c == '<') {
            tag = true;
        } else if (c == '>') {
            tag = false;
        } else if (!tag) {
            out += c;
        }
    }
    for (const std::string invisible : {"&#x2062;", "&#x2061;"}) {
        for (std::size_t at = 0; (at = out.find(invisible)) != std::string::npos;) {
            out.erase(at, invisible.size());
        }
    }
    return out;
}

} // namespace

TEST_CASE("MathML: well formed, whatever the expression") {
    for (const char* text : {"1",
                             "1e-30",
                             "2.5e7",
                             "-x",
                             "-(-x)",
                             "a - (b - x)",
                             "a*(b*x)",
                             "a/b/x",
                             "(a/b)^2",
                             "a^b^x",
                             "(a^b)^x",
                             "(-a)^2",
                             "-a^2",
                             "sqrt(a + b)",
                             "abs(x)",
                             "log(x)^2",
                             "gamma(m/2)",
                             "asin(t/a)",
                             "atan2(x, a)",
                             "max(a, b, x)",
                             "Pof(a)",
                             "binv(-x)",
                             "p(x)^2",
                             "P1^2",
                             "P5",
                             "b3",
                             "Es",
                             "Es^2",
                             "right_c1",
                             "p0",
                             "R_max",
                             "gam^2",
                             "phi",
                             "Pi",
                             "integral(s^m/sqrt(s^2 - x^2), s, x, a)",
                             "pv(p(s), s, -b, a, x)/Pi",
                             "sum(x^k, k, 0, 3)*a",
                             "2*sqrt(2)/(3*a^(3/2)*Pi)*(5*P1/8 - a*P2)"}) {
        CAPTURE(text);
        const std::string whole = math_element(mathml(text), text);
        CHECK(test::well_formed(whole) == "");
    }
}

TEST_CASE("MathML: the tree is set as it is, with the parentheses that it needs and no others") {
    CHECK(text_of(mathml("a - (b - x)")) == "a−(b−x)");
    CHECK(text_of(mathml("(a - b) - x")) == "a−b−x");
    CHECK(text_of(mathml("a*(b + x)")) == "a(b+x)");
    CHECK(text_of(mathml("(a + b)/x")) == "a+bx"); // one block above the other
    CHECK(text_of(mathml("(a + b)^2")) == "(a+b)2");
    CHECK(text_of(mathml("-a^2")) == "−a2");
    CHECK(text_of(mathml("(-a)^2")) == "(−a)2");
    CHECK(text_of(mathml("(a/b)^2")) == "(ab)2");
    CHECK(text_of(mathml("a + -b")) == "a+(−b)");
    CHECK(text_of(mathml("2*3")) == "2·3");
    CHECK(text_of(mathml("2*x")) == "2x");
    CHECK(text_of(mathml("P1^2")) == "(P′(a))2");
    CHECK(text_of(mathml("1e-30")) == "10−30");
    CHECK(text_of(mathml("gam*phi")) == "γφ");
    CHECK(text_of(mathml("gamma(m)")) == "Γ(m)");
    CHECK(text_of(mathml("integral(a + s, s, 0, x)*b")) == "(∫0x(a+s)ds)b");
}

TEST_CASE("MathML: fractions, roots and indices are elements of their own") {
    CHECK(mathml("a/b") ==
          "<mrow><mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac></mrow>");
    CHECK(mathml("sqrt(2)") == "<mrow><msqrt><mn>2</mn></msqrt></mrow>");
    CHECK(mathml("right_c1") ==
          "<mrow><msubsup><mi>c</mi><mn>1</mn><mtext>right</mtext></msubsup></mrow>");
    CHECK(mathml("Es") == "<mrow><msup><mi>E</mi><mo>*</mo></msup></mrow>");
}

TEST_CASE("the check of well-formedness finds what is not") {
    CHECK(test::well_formed("<a><b></b></a>") == "");
    CHECK(test::well_formed("<a><b></a></b>") != "");
    CHECK(test::well_formed("<a>") != "");
    CHECK(test::well_formed("<a x=1></a>") != "");
    CHECK(test::well_formed("<a>5 < 6</a>") != "");
    CHECK(test::well_formed("<a>&nothing</a>") != "");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

const Symbols typed_symbols = [] {
    Symbols s{"a", "b", "C", "Es", "P",       "P1",  "P2", "R",
              "t", "u", "x", "m",  "sigma_0", "phi", "nu1"};
    s.add_function("Pof", 1).add_function("P1of", 1).add_function("bof", 1).add_function("p", 1);
    s.add_function("g1", 1);
    // A function and a name of two bodies, each with the letters of another reading.
    s.add("F").add_function("F", 1).add("R1").add("g").add("d").add_function("gap", 1);
    return s;
}();

std::string products(const std::string& text) { return with_products(text, text, typed_symbols); }
std::string tex(const std::string& text) { return plain_from_tex(text, typed_symbols); }

/// Checks items "typed => plain text".
template <class Read> void check_readings(const Read& read, const char* items) {
    test::for_pairs(items, " => ", [&](const auto& typed, const auto& plain) {
        CHECK(read(typed) == plain);
        CHECK_NOTHROW((void)parse(plain, typed_symbols));
    });
}

/// The message for a text that must be refused: one line, never another exception.
template <class Read> std::string refused(const Read& read, const std::string& text) {
    try {
        const std::string plain = read(text);
        (void)parse(plain, typed_symbols); // the reading of LaTeX is parsed afterwards
    } catch (const FormulaError& e) {
        const std::string line = e.what();
        CHECK(line.find('\n') == std::string::npos);
        CHECK_FALSE(e.instead().empty());
        return line;
    }
    FAIL("accepted: " << text.substr(0, 80));
    return {};
}

} // namespace

TEST_CASE("ln and log10 in formulas") {
    CHECK(parse("ln(x)", typed_symbols) == parse("log(x)", typed_symbols));
    CHECK(parse("log10(x)", typed_symbols) == parse("log(x)/log(10)", typed_symbols));
    CHECK(parse("ln(2) + 3*log10(x + a)", typed_symbols) ==
          parse("log(2) + 3*(log(x + a)/log(10))", typed_symbols));
    Symbols own{"x"};
    own.add_function("ln", 2);
    CHECK(parse("ln(x, 2)", own).name() == "ln");
    CHECK_THROWS_AS((void)parse("ln(x, 2)", typed_symbols), FormulaError);
    CHECK_THROWS_AS((void)parse("log10()", typed_symbols), FormulaError);
}

TEST_CASE("products without a sign are read as people read them") {
    check_readings(products, R"ITEMS(
        2P => 2*P   2 P => 2*P   2P/3 => 2*P/3   2P/(pi a) => 2*P/(pi*a)
        (a+b)(a-b) => (a+b)*(a-b)   (1/2)P => (1/2)*P   2(a + b) C => 2*(a + b)*C
        0.418sqrt(P Es/R) => 0.418*sqrt(P*Es/R)   2P^2 => 2*P^2   -2P + 3 x => -2*P + 3*x
        a*b C => a*b*C   2sin(x)(a + b) => 2*sin(x)*(a + b)
        integral(2 s x, s, 0, 2a) => integral(2*s*x, s, 0, 2*a)   2e3P => 2e3*P   a - b => a - b
        2*P => 2*P
    )ITEMS");
}

TEST_CASE("products that can be read in two ways are refused") {
    for (const char* text : {"1/2P", "a/b C", "P/2(a + b)", "P/2 sqrt(x)", "x^2a", "x^2 a", "2^3x",
                             "(x+a)^2(b)", "2 x^a b"}) {
        CAPTURE(text);
        CHECK(refused(products, text).find("can be read in two ways") != std::string::npos);
    }
    // A name before a bracket may be a function; a number after a factor may be a part of a name.
    for (const char* text : {"P(a + b)", "P (a + b)", "a 2", "2 3", "(a)2", "ab", "Rt", "2 mm",
                             "2 sin x", "sin 2x", "2 *", "2 P)", "((2 P)"}) {
        CAPTURE(text);
        (void)refused(products, text);
    }
    CHECK_THROWS_AS((void)parse("2P", typed_symbols), FormulaError); // other texts need the sign
}

TEST_CASE("a subset of LaTeX is read") {
    check_readings(tex, R"ITEMS(
        \frac{E^{*}C}{2}\sqrt{a^{2}-x^{2}} => Es*C/2*sqrt(a^2-x^2)
        \frac{2P}{\pi a} => 2*P/(Pi*a)   \frac12 P => 1/2*P   2\,\frac{a}{b}x => 2*(a/b)*x
        \sqrt[3]{3PR/E^*} => (3*P*R/Es)^(1/3)   \sqrt[3]{\frac{3PR}{4E^*}} => (3*P*R/(4*Es))^(1/3)
        \left(a+b\right)\left[a-b\right] => (a+b)*(a-b)   P'(a) - aP''(a) => P1-a*P2
        P'(x) => P1of(x)   g'(x)p(x) => g1(x)*p(x)   \sigma_{0}\varphi => sigma_0*phi
        1-\nu_1^2 => 1-nu1^2   \ln\frac{a}{b}+\log_{10} x => log(a/b)+log10(x)
        \sin^2\phi\cos\phi => sin(phi)^2*cos(phi)   \arcsin(x/a) => asin(x/a)
        \left|x\right|a => abs(x)*a   e^{-x/a} => exp(-x/a)   x^{3/2} => x^(3/2)
        x^{-1}a => x^(-1)*a   -x^2 => -x^2   a\cdot b\times C => a*b*C   C(a+b) => C*(a+b)
        \mathrm{Pof}(2a) => Pof(2*a)
        \int_{0}^{a} \frac{s\,ds}{\sqrt{a^2-s^2}} => integral(s/sqrt(a^2-s^2), s, 0, a)
        \frac{1}{\pi}\int_0^a g'(s)\,\mathrm{d}s + x => 1/Pi*integral(g1(s), s, 0, a)+x
        \int_{-b}^{a}(s+x)^2 ds => integral((s+x)^2, s, -b, a)
        \operatorname{sgn}(x)\sqrt{2}a => sgn(x)*sqrt(2)*a   \sin x\cdot\cos x => sin(x)*cos(x)
        \left(\sin x\right)a => (sin(x))*a   \int_0^a \sin s\,ds => integral(sin(s), s, 0, a)
        \int_1^a \frac{dx}{x} => integral(1/x, x, 1, a)   e^{\sin x}a => exp(sin(x))*a
        a\frac12 => a*(1/2)   2\sqrt[3]{2} => 2*2^(1/3)   x^{(3/2)} => x^(3/2)   p[x]\, => p(x)
        F(a+b)\, => F(a+b)   2e^{x} => 2*exp(x)   {(a+b)}^2 => (a+b)^2   \frac{d^2}{4} => d^2/4
    )ITEMS");
}

TEST_CASE("LaTeX that can be read in two ways, or is not of the subset, is refused in one line") {
    for (const std::string& text : test::items(R"ITEMS(
        a/2b\cdot{}   1/2\sqrt{x}   \sin 2x   \sin x y   \sin^{-1}x   \sin(x)^2\,   P(a)\,
        P(a+b)\,   \mathrm{C}(a)   \int_0^a ds\,p(s)   \int_0^a p(s) ds\, x   \sin x/2
        \ln a\cdot b   {\sin x}a   \sin^{(-1)}x   \int_0^a dx/x   \int_0^a dx \sin x
        {\int_0^a s\,ds}b   \int_0^a s\,ds\cdot b   \,exp(x)   a\,exp(x)   \,gap(x)   \,e(x)
        2e-3\,   3e2\,   2\frac12   2{3}   a\mathrm{3}   P^{(2)}   p^{-1}(x)\,   \frac{dP}{da}
        \frac{d^2P}{da^2}   C(-a)\,   C[a]\,   C{(a)}   {C}(a)   C\{a\}
    )ITEMS")) {
        CAPTURE(text);
        CHECK(refused(tex, text).find("can be read in two ways") != std::string::npos);
    }
    for (const std::string& text : test::items(R"ITEMS(
        \frac{a}{b   \frac{a}   \frac   \sqrt   \sqrt[3   \left(a   a}   \foo{a}   a \pm b\,
        x^2^3\,   x_1_2\,   \int_0^a p(s)\,   \int p(s)\,ds   \Pi a   \,y   a=b\,   {a+b}c   \   \\
        |x\,   \sum_{k=0}^{3} k   \partial x   a\,2   \log_2 x   \input{file}   \mathrm{a b^2}   {
        }   \{a   R'\,   {x^2}^3   {\sin x}^2   \int_0^a \frac{s}{ds}   \left.x\right.
    )ITEMS")) {
        CAPTURE(text);
        (void)refused(tex, text);
    }
    (void)refused(tex, "\\frac{a}{\xFF}");
    (void)refused(tex, "\\\x01");
}

TEST_CASE("hostile LaTeX ends soon, with one line") {
    for (const std::size_t n : {400, 3000}) {
        for (const char* piece :
             {"{", "(", "\\frac{", "\\sqrt{", "\\sqrt[", "x^{", "x_{", "\\sin ", "|", "\\int_",
              "\\int_0^a", "\\mathrm{", "C(", "-", "\\left(", "\\{", "P'(", "\\text"}) {
            CAPTURE(piece);
            (void)refused(tex, "\\," + test::repeated(piece, n));
        }
        (void)refused(tex, test::repeated("{", n) + "a" + test::repeated("}", n));
        (void)refused(tex, test::repeated("C(1+", n) + "a" + test::repeated(")", n) + "\\,");
    }
    (void)refused(tex, "\\," + test::repeated("a", 20'000));
}

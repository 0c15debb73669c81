// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/tex_math.hpp"

#include "tests/report/well_formed.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

audit::PrintedSource source() {
    audit::PrintedSource s;
    s.labels = {{"eqn:LI", "5"}, {"fig:one", "2"}};
    s.macros = {{"ve", "\\varepsilon"}, {"loop", "\\loop x"}};
    return s;
}
std::string mathml(const char* tex) {
    const std::string markup = inline_math(math_of_tex(tex, source()));
    CHECK(test::well_formed(markup) == "");
    return markup;
}
using test::has;

} // namespace

TEST_CASE("TeX mathematics as MathML") {
    CHECK(has(mathml("\\frac{a}{b}"), "<mfrac><mi>a</mi><mi>b</mi></mfrac>"));
    CHECK(has(mathml("\\sqrt{2}"), "<msqrt><mn>2</mn></msqrt>"));
    CHECK(has(mathml("L_{I,a}"),
              "<msub><mi>L</mi><mrow><mi>I</mi><mo>,</mo><mi>a</mi></mrow></msub>"));
    CHECK(has(mathml("P''(a)"), "<msup><mi>P</mi><mo>′′</mo></msup>"));
    CHECK(has(mathml("\\ve^{3/2}"), "<mi>ε</mi>")); // a macro of the paper's source
    CHECK(has(mathml("\\mathcal{P}"), "𝒫"));
    CHECK(has(mathml("\\int_{0}^{X} f\\,\\mbox{d}s"), "<msubsup><mo>∫</mo>"));
    CHECK(
        has(mathml("\\begin{cases} 0 & \\mbox{for} \\; x<t \\\\[2mm] 1 \\end{cases}"), "<mtable"));
    CHECK_FALSE(has(mathml("\\begin{cases} 0 \\\\[2mm] 1 \\end{cases}"), "mm"));
    // Brackets that a line of an alignment does not close, or that were never opened, are still
    // set.
    CHECK(has(mathml("\\left[a + \\right. \\nonumber \\\\ & \\left. b\\right]"), "<mi>b</mi>"));
    CHECK(has(mathml("a} \\right) b"), "<mi>b</mi>"));
    CHECK(has(mathml("\\frac"), "<mfrac>"));
    CHECK(has(mathml("\\loop"), "<mi>x</mi>")); // a macro that calls itself ends
    CHECK_FALSE(has(mathml("\\unknown{a}"), "\\"));
}

TEST_CASE("sentences of a source: formulas typeset, numbers in place of labels") {
    const auto html = [](const char* tex) { return sentence_html(tex, source()); };
    CHECK(html("see (\\ref{eqn:LI}) and figure \\ref{fig:one}b") == "see (5) and figure 2b");
    CHECK(html("about 1\\% of it --- or `more' \\cite{Barber2002}") ==
          "about 1% of it — or ‘more&#39; [Barber2002]");
    CHECK(has(html("when $m < 5/8$, see"), "<mo>&lt;</mo>"));
    CHECK_FALSE(has(html("$M_{I}$ grows"), "$"));
    CHECK(html("x < y & z") == "x &lt; y &amp; z");
    CHECK(test::well_formed(html("open $a^{2}")) == "");
    CHECK(is_sentence("both $M_{I}$ grow"));
    CHECK(is_sentence("the coordinate system is aligned"));
    CHECK_FALSE(is_sentence("\\frac{a}{b} & \\mbox{for} \\; a < t"));
    CHECK(left_side("L_{I,a} & \\, = && \\, \\frac{a}{b}") == "L_{I,a}");
    CHECK(left_side("\\frac{a}{b}") == "");
}

TEST_CASE("only the differences between two formulas are marked") {
    MathNode printed = math_of_tex("\\frac{2P}{a}", source());
    MathNode corrected = math_of_tex("\\frac{2P\\sqrt{b}}{4a}", source());
    mark_changes(printed, corrected);
    CHECK_FALSE(has(inline_math(printed), "changed"));
    const std::string marked = inline_math(corrected);
    CHECK(has(marked, "<msqrt class=\"changed\"><mi class=\"changed\">b</mi></msqrt>"));
    CHECK(has(marked, "<mn class=\"changed\">4</mn>"));
    CHECK(has(marked, "<mi>P</mi>"));
    CHECK(has(marked, "<mi>a</mi>"));
}

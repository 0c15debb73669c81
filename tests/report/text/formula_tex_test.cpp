// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/formula_tex.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

Expr read(const char* text) {
    return parse(text, Symbols{"a", "b", "P1", "X", "S", "gam", "eps", "calP", "right_c0"});
}
audit::PrintedSource notation() {
    audit::PrintedSource source;
    source.notation = {{"calP", "\\mathcal{P}"}, {"right_c0", "L_{I}"}};
    source.notation_over["wedge"] = {{"right_c0", "L_{I,a}"}};
    return source;
}
std::string tex(const char* text) { return formula_tex(read(text), notation(), ""); }
std::string tidied(const char* text) { return formula_tex(arranged(read(text)), notation(), ""); }

/// Returns the value at a = 3, b = 7, ...; it is exact, so that equal texts of numbers are equal
/// values.
Real value_of(Expr e) {
    long value = 2;
    for (const char* name : {"a", "b", "P1", "X", "S", "gam", "eps", "calP"}) {
        ++value;
        e = substitute(e, name, Expr::number(Rational(value * value + 1, 3)));
    }
    const PrecisionScope scope(50);
    return formula::Exact(e).to<Real>();
}

} // namespace

TEST_CASE("formulas in the notation of the source") {
    CHECK(tex("P1/a") == "\\frac{P'(a)}{a}");
    CHECK(tex("gam*calP") == "\\gamma \\mathcal{P}");
    CHECK(tex("right_c0") == "L_{I}");
    CHECK(formula_tex(read("right_c0"), notation(), "wedge") == "L_{I,a}");
    CHECK(tex("2*(a+b)") == "2 (a + b)");
    CHECK(tex("2*3") == "2 \\cdot 3");
    CHECK(tex("(Pi/2 - a)*b/X") == "\\left(\\frac{\\pi}{2} - a\\right)\\frac{b}{X}");
}

TEST_CASE("corrections as a person writes them") {
    CHECK(tidied("P1/a*(X+S)/4") == "\\frac{P'(a)}{4 a} (X + S)");
    CHECK(tidied("eps^1.5") == "\\varepsilon^{3/2}");
    CHECK(tidied("sqrt(gam)*(2*calP/(Pi*sqrt(a)))") ==
          "\\frac{2 \\mathcal{P} \\sqrt{\\gamma}}{\\pi \\sqrt{a}}");
}

TEST_CASE("arranging a formula leaves its value") {
    for (const char* text :
         {"P1/a*(X+S)/4", "sqrt(gam)*(2*calP/(Pi*sqrt(a)))", "eps^1.5", "eps^(-0.5)", "a/b/X",
          "-(a*(b+X)/2)*(P1/S)", "P1*sqrt(2)*sqrt(X)/(Pi*sqrt(a))*sqrt(eps)", "a*(b/X)*(1/S)",
          "X^(3/2)*sqrt(2)*(5*P1 - 8*a*S)/(12*Pi*a^(3/2))*eps^1.5", "1/(a*b)", "2*(1/a)", "-a/b"}) {
        CAPTURE(text);
        const Expr e = read(text);
        const PrecisionScope scope(50);
        const Real exact = value_of(e);
        CHECK(abs(value_of(arranged(e)) - exact) <= abs(exact) * pow(Real(10), -45));
        CHECK(abs(value_of(gathered(e)) - exact) <= abs(exact) * pow(Real(10), -45));
    }
}

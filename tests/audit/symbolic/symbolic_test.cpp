// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

Expr formula_of(const std::string& text) {
    Vocabulary v;
    for (const std::string& name : scene_symbols()) {
        v.symbols.add(name);
    }
    for (const char* name : {"C", "m", "t", "R", "gam", "eps", "X", "S", "sigma"}) {
        v.symbols.add(name);
    }
    for (const auto& [name, arity] : scene_functions()) {
        v.symbols.add_function(name, arity);
    }
    return parse_formula(text, v);
}

bool equal(const std::string& x, const std::string& y, const SymbolicCase& under = {}) {
    return proved_equal(formula_of(x), formula_of(y), under);
}

const SymbolicCase symmetric_case{.symmetric = true, .P = {}, .b = {}};

} // namespace

TEST_CASE("identities with roots are decided") {
    CHECK(equal("sqrt(8*a)", "2*sqrt(2)*sqrt(a)"));
    CHECK(equal("sqrt(a+gam*a)", "sqrt(a)*sqrt(1+gam)"));
    CHECK(equal("1/sqrt(a+b)-1/(a+b)^(3/2)*a", "b/(a+b)^(3/2)"));
    CHECK(equal("a^(m+1)/a^(m-1/2)", "a*sqrt(a)"));
    CHECK(equal("(a*C)^m", "a^m*C^m"));
    CHECK(equal("sqrt(a^2-t^2)", "sqrt(a-t)*sqrt(a+t)"));
    CHECK(equal("sqrt(1/(a*b))*b", "sqrt(b/a)"));
    CHECK(equal("sqrt(12)/sqrt(27)", "2/3"));
    CHECK_FALSE(equal("sqrt(a+b)", "sqrt(a)+sqrt(b)"));
    CHECK_FALSE(equal("sqrt(8*a)", "2*sqrt(2)*a"));
    CHECK_FALSE(equal("a^(m+1)", "a^m"));
}

TEST_CASE("the first multipliers of a symmetric contact, by a derivation made on paper") {
    // p = (1/pi) int_x^a P'(s)/sqrt(s^2 - x^2) ds with s = a - u r, expanded by hand:
    CHECK(equal("right.c0", "sqrt(2/a)*P1/Pi", symmetric_case));
    CHECK(equal("right.c1", "2*sqrt(2)/(3*a^(3/2)*Pi)*(5*P1/8-a*P2)", symmetric_case));
    CHECK(equal("left.c1", "right.c1", symmetric_case));
    CHECK(equal("left.c2", "right.c2", symmetric_case));
    CHECK(equal("left.c0", "right.c0/b1"));
    CHECK_FALSE(equal("left.c1", "right.c1/b1"));
    // Hertz: P = k a^2, p = (2k/pi) sqrt(2 a u - u^2)
    const SymbolicCase hertz{.symmetric = true, .P = formula_of("C*a^2"), .b = {}};
    CHECK(equal("right.c0", "2*C*sqrt(2*a)/Pi", hertz));
    CHECK(equal("right.c1", "-C/sqrt(2*a)/Pi", hertz));
    CHECK(equal("right.c2", "-C/(8*sqrt(2)*a^(3/2)*Pi)", hertz));
}

TEST_CASE("expansions, power by power") {
    const ExpansionIn in{"eps", Edge::right, Rational(2)};
    CHECK(compare_expansions(formula_of("1/(1-eps*a)"), formula_of("1+eps*a+eps^2*a^2"), in, {})
              .equal());
    CHECK(compare_expansions(formula_of("sqrt(eps+eps^2)"), formula_of("sqrt(eps)+eps^(3/2)/2"), in,
                             {})
              .equal());
    // The expansion of b^{-1}(b - y) - a to second order, by hand.
    CHECK(compare_expansions(formula_of("binv(b-eps*X)-a"),
                             formula_of("-eps*X/b1-eps^2*X^2*b2/(2*b1^3)"), in, {})
              .equal());
    const auto wrong = compare_expansions(formula_of("P1-eps*S*P2+eps^2*S^2*P3"),
                                          formula_of("P1of(a-eps*S)"), in, {});
    REQUIRE(wrong.first_wrong() != nullptr);
    CHECK(wrong.first_wrong()->exponent == 2);
    CHECK(to_text(wrong.first_wrong()->derived) == "P3*S^2/2");
    // int_0^X S/sqrt(X - S) dS = 4 X^(3/2)/3
    CHECK(compare_expansions(formula_of("integral((1+eps*S)/sqrt(X-S), S, 0, X)"),
                             formula_of("2*sqrt(X)+eps*4*X^(3/2)/3"), in, {})
              .equal());
    // These two derivations of the pressure's expansion share only P' and b.
    const ExpansionIn u{"u", Edge::left, Rational(5, 2)};
    const auto terms = expand(formula_of("p(x)"), u, {});
    REQUIRE(terms.size() == 3);
    CHECK(proved_equal(terms[2].coefficient, formula_of("left.c2"), {}));
    CHECK(compare_expansions(
              formula_of("1/Pi*(a-binv(-x))*integral(P1of(a+(binv(-x)-a)*sigma)/"
                         "sqrt(a-x+(binv(-x)-a)*sigma)/sqrt(x+bof(a+(binv(-x)-a)*sigma)),"
                         "sigma, 0, 1)"),
              formula_of("p(x)"), u, {})
              .equal());
}

TEST_CASE("derived formulas are written out, the same on every run") {
    CHECK(to_text(derive(formula_of("right.c0"), {})) == "2*P1/(Pi*sqrt(a + b))");
    CHECK(to_text(derive(formula_of("right.c1"), {})) ==
          "((2*b1 + 3)*P1 - 4*(a + b)*P2)/(3*Pi*(a + b)^(3/2))");
    CHECK(to_text(derive(formula_of("1/(a-b)-1/(b-a)"), {})) == "2/(a - b)");
}

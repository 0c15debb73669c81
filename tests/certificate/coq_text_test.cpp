// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/theory/theory.hpp"

#include "edgeproof/certificate/certificate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

std::string in_coq(const std::string& text) {
    const certificate::CoqNames names{{"a", "a"}, {"b", "(b a)"}, {"x", "x"}, {"P1", "(P1 a)"}};
    formula::Symbols symbols;
    for (const char* name : {"a", "b", "x", "P1", "m"}) {
        symbols.add(name);
    }
    return certificate::coq_text(formula::parse(text, symbols), names);
}

} // namespace

// Coq reads the tree of the printed formula: its operators bind like those of the ledger, except
// for the leading minus, which binds more strongly than a product in Coq.
TEST_CASE("formulas as terms of Coq") {
    CHECK(in_coq("a - (b - x)") == "a - ((b a) - x)");
    CHECK(in_coq("a - b - x") == "a - (b a) - x");
    CHECK(in_coq("a/(b*x)") == "a / ((b a) * x)");
    CHECK(in_coq("a/b*x") == "a / (b a) * x");
    CHECK(in_coq("-a^2") == "- a ^ 2");
    CHECK(in_coq("(-a)^2") == "(- a) ^ 2");
    CHECK(in_coq("-(a*b)") == "- (a * (b a))");
    CHECK(in_coq("a*(-b)") == "a * (- (b a))");
    CHECK(in_coq("2*P1/Pi") == "2 * (P1 a) / PI");
    CHECK(in_coq("0.25*x") == "(1 / 4) * x");
    CHECK(in_coq("sqrt(a+b)") == "sqrt (a + (b a))");
    CHECK(in_coq("abs(log(x))") == "Rabs (ln x)");
    CHECK(in_coq("max(x, a)") == "Rmax x a");
}

TEST_CASE("powers with whole and other exponents") {
    CHECK(in_coq("(a+b)^2") == "(a + (b a)) ^ 2");
    CHECK(in_coq("sqrt(a)^2") == "sqrt a ^ 2");
    CHECK(in_coq("a^(-2)") == "(/ a ^ 2)");
    CHECK(in_coq("(a+b)^(3/2)") == "Rpower (a + (b a)) (3 / 2)");
    CHECK(in_coq("a^(-1/2)") == "Rpower a (- (1 / 2))");
    CHECK(in_coq("x*a^(5/2)") == "x * Rpower a (5 / 2)");
    CHECK(in_coq("a^(x+1)") == "Rpower a (x + 1)");
}

TEST_CASE("functions that Coq's real numbers do not have are not stated") {
    CHECK_THROWS_AS(in_coq("gamma(a)"), certificate::NotStated);
    CHECK_THROWS_AS(in_coq("m*a"), certificate::NotStated);
    CHECK_THROWS_AS(in_coq("integral(x, x, 0, 1)"), certificate::NotStated);
}

TEST_CASE("ids of claims as names in Coq: no file of the theory, no word of the language") {
    CHECK(certificate::coq_name("EQ30.L") == "EQ30_L");
    CHECK(certificate::coq_name("7-b") == "claim_7_b");
    CHECK(certificate::coq_name("Contact") == "claim_Contact");
    for (const std::string word : // the keywords of Coq's reference manual
         {"Axiom", "CoFixpoint", "Definition", "Fixpoint", "Hypothesis", "Parameter",
          "Prop",  "SProp",      "Set",        "Theorem",  "Type",       "Variable",
          "as",    "at",         "cofix",      "else",     "end",        "fix",
          "for",   "forall",     "fun",        "if",       "in",         "let",
          "match", "return",     "then",       "where",    "with"}) {
        CHECK(certificate::coq_name(word) == "claim_" + word);
    }
    // These names are taken by the library and by share/edgeproof/coq.
    CHECK(certificate::coq_name("R") == "claim_R");
    CHECK(certificate::coq_name("is_load") == "claim_is_load");
    CHECK(certificate::coq_name("is_loaded") == "is_loaded");
    CHECK(certificate::coq_name("sigma") == "sigma");
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/relations/relations.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

const formula::Symbols relation_names{
    "a",        "b",        "L",       "P1",      "P2",       "P3",      "b1",      "b2",
    "b3",       "Q",        "sig0",    "m",       "left_c0",  "left_c1", "left_c2", "right_c0",
    "right_c1", "right_c2", "left_s0", "left_s1", "right_s0", "right_s1"};

std::vector<RelatedQuantity> related(const std::vector<std::string>& texts) {
    std::vector<RelatedQuantity> all;
    for (const std::string& text : texts) {
        all.push_back({text, formula::parse(text, relation_names)});
    }
    return all;
}

std::vector<std::string> relations_of(const std::vector<std::string>& texts, unsigned degree,
                                      const SymbolicCase& under = {}) {
    const auto quantities = related(texts);
    const FoundRelations found = find_relations(quantities, degree, under);
    CHECK(found.complete);
    std::vector<std::string> all;
    for (const PolynomialRelation& r : found.relations) {
        all.push_back(relation_text(r, quantities));
    }
    return all;
}

Rational value_of(const PolynomialRelation& relation, const std::vector<Rational>& at) {
    Rational sum = 0;
    for (const PolynomialRelation::Term& t : relation.terms) {
        Rational product(t.coefficient);
        for (std::size_t i = 0; i < at.size(); ++i) {
            for (unsigned k = 0; k < t.exponents[i]; ++k) {
                product *= at[i];
            }
        }
        sum += product;
    }
    return sum;
}

} // namespace

TEST_CASE("relations of the multipliers of both edges") {
    // moore-hills.tex, line 284.
    CHECK(relations_of({"left_c0", "right_c0", "b1"}, 2) ==
          std::vector<std::string>{"b1*left_c0 - right_c0 = 0"});
    CHECK(relations_of({"left_c1", "right_c0", "right_c1", "b1", "L"}, 4).empty());
    const std::vector<std::string> names{"left_c1", "right_c0", "right_c1", "left_c0",
                                         "b1",      "b2",       "L"};
    const FoundRelations found = find_relations(related(names), 4, {});
    CHECK(found.complete);
    REQUIRE(found.relations.size() >= 2);
    // The printed multipliers (eqn:LI_NonSym_Right to eqn:MI_NonSym_Left), times pi, are evaluated
    // at these numbers: a + b = 4, P' = 3, P'' = 5/7, b' = 2/3, b'' = -1/5.
    const Rational P1 = 3;
    const Rational P2(5, 7);
    const Rational b1(2, 3);
    const Rational b2(-1, 5);
    const Rational D = 4;
    const Rational root = 2;
    const Rational La = 2 * P1 / root;
    const Rational Lb = La / b1;
    const Rational Ma = ((3 + 2 * b1) * P1 - 4 * D * P2) / (3 * D * root);
    const Rational Mb = ((3 * b1 * b1 + 2 * b1 + 4 * b2 * D) * P1 - 4 * D * b1 * P2) /
                        (3 * b1 * b1 * b1 * D * root);
    for (const PolynomialRelation& r : found.relations) {
        CHECK(value_of(r, {Mb, La, Ma, Lb, b1, b2, D}) == 0);
        CHECK(value_of(r, {Mb + 1, La + 2, Ma, Lb, b1, b2, D}) != 0);
    }
    // Derived by hand: b'^2 M_b - M_a = L_a (b' - 1 + 4 b'' D/b')/(6 D), with L_a = b' L_b.
    const auto quantities = related(names);
    CHECK(std::any_of(found.relations.begin(), found.relations.end(),
                      [&](const PolynomialRelation& r) {
                          return solved_text(r, quantities, 0) ==
                                 "left_c1 = (4*L*b2*left_c0 + b1*right_c0 + 6*L*right_c1 - "
                                 "right_c0)/(6*L*b1^2)";
                      }));
}

TEST_CASE("relations with fractions and square roots") {
    CHECK(relations_of({"a/b - 7*b/(3*a)", "b/a"}, 2) ==
          std::vector<std::string>{"3*(b/a)*(a/b - 7*b/(3*a)) + 7*(b/a)^2 - 3 = 0"});
    CHECK(relations_of({"sqrt(a) + sqrt(b)", "sqrt(a*b)", "L"}, 2) ==
          std::vector<std::string>{"(sqrt(a) + sqrt(b))^2 - 2*(sqrt(a*b)) - L = 0"});
    // Modulo the prime, sqrt(2) is a number like the rational ones.
    CHECK_FALSE(find_relations(related({"sqrt(a)", "sqrt(2*a)"}), 1, {}).complete);
}

TEST_CASE("relations under full stick, and of symmetric contacts") {
    // For q from Q and sigma_0: 2 D s_1 = 2 s_0(other edge) - s_0, as there are two loads.
    const auto shear = relations_of({"right_s1", "right_s0", "left_s0", "L"}, 2);
    CHECK(shear == std::vector<std::string>{"2*L*right_s1 + right_s0 - 2*left_s0 = 0"});
    // P and Q are independent of each other.
    CHECK(relations_of({"right_s0", "right_s1", "right_c0", "right_c1"}, 3).empty());
    SymbolicCase symmetric;
    symmetric.symmetric = true;
    CHECK(relations_of({"right_c2", "right_c1", "right_c0", "a"}, 4, symmetric).empty());
    CHECK(relations_of({"left_c1", "right_c1"}, 1, symmetric) ==
          std::vector<std::string>{"left_c1 - right_c1 = 0"});
    // For power laws, one multiplier follows from the others: with mu = 5/8 - m, a c_1/c_0 = 2 mu/3
    // and a^2 c_2/c_0 = (129 - 272 m + 128 m^2)/480 (line 158).
    SymbolicCase power_law = symmetric;
    power_law.names.emplace("P2", formula::parse("m*P1/a", relation_names));
    power_law.names.emplace("P3", formula::parse("m*(m-1)*P1/a^2", relation_names));
    const std::vector<std::string> names{"right_c2", "right_c1", "right_c0", "a"};
    const FoundRelations one = find_relations(related(names), 4, power_law);
    REQUIRE(one.relations.size() == 1);
    for (const Rational& m : {Rational(0), Rational(1), Rational(7, 3)}) {
        const Rational a(3, 2);
        const Rational c1 = Rational(2, 3) * (Rational(5, 8) - m) / a;
        const Rational c2 = (129 - 272 * m + 128 * m * m) / 480 / (a * a);
        CHECK(value_of(one.relations[0], {c2, c1, 1, a}) == 0);
        CHECK(value_of(one.relations[0], {c2 + 1, c1, 1, a}) != 0);
    }
}

TEST_CASE("relations: a search that is too large or has no value is refused") {
    CHECK_THROWS_AS((void)find_relations(related({"exp(a)", "a"}), 2, {}), InputError);
    CHECK_THROWS_AS((void)find_relations(related({"a^m", "a"}), 2, {}), InputError);
    CHECK_THROWS_AS((void)find_relations(related({"1/(L - a - b)", "a"}), 2, {}), Error);
    CHECK_THROWS_AS(
        (void)find_relations(related({"a", "b", "b1", "b2", "b3", "P1", "P2", "P3"}), 10, {}),
        InputError);
}

TEST_CASE("relations: circular definitions, and definitions of derived names, are refused") {
    const auto problem = [](std::vector<std::pair<std::string, std::string>> given) {
        RelationQuestion question;
        question.quantities = {"P2", "right.c1"};
        question.degree = 1;
        question.given = std::move(given);
        try {
            (void)asked_relations(question);
        } catch (const InputError& error) {
            return error.problem();
        }
        return std::string("none");
    };
    CHECK(problem({{"P2", "P2"}}) == "the definitions are circular: P2 -> P2");
    CHECK(problem({{"P2", "P3 + a"}, {"P3", "b1*P2"}}) ==
          "the definitions are circular: P2 -> P3 -> P2");
    CHECK(problem({{"b", "L - a"}}) == "given b=L - a: 'L' follows from others");
    CHECK(problem({{"P1", "right.c0"}}) == "given P1=right.c0: 'right_c0' follows from others");
    CHECK(problem({{"P2", "a"}, {"P2", "b"}}) == "P2 is given twice");
    CHECK(problem({{"P2", "2^(2^64)"}}) == "a power beyond 1000 is not worked out by symbols");
    CHECK(problem({{"P2", "gamma(1e9)"}}) ==
          "gamma of a number beyond 1000 is not worked out by symbols");
    CHECK(problem({{"P2", "a^(1/10^40)"}}) != "none");
    CHECK(problem({{"P2", "P3"}, {"P3", "a"}}) == "none");
}

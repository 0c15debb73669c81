// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <map>

namespace {

constexpr long test_bits = 240;
constexpr unsigned test_digits = 35;

/// The names in these tests; c has the same value as a, but this is not known by symbols.
struct IntegralNames {
    std::map<std::string, Ball, std::less<>> values{{"a", Ball(Rational(3, 2), test_bits)},
                                                    {"c", Ball(Rational(3, 2), test_bits)},
                                                    {"b", Ball(Rational(2, 3), test_bits)},
                                                    {"x", Ball(Rational(1, 7), test_bits)},
                                                    {"t", Ball(Rational(1, 11), test_bits)}};
    [[nodiscard]] Ball number(const Rational& q) const { return {q, test_bits}; }
    [[nodiscard]] Ball pi() const { return Ball::pi(test_bits); }
    [[nodiscard]] Ball symbol(std::string_view name) const {
        const auto it = values.find(name);
        return it != values.end() ? it->second : throw Error(std::string(name) + " has no value");
    }
};

Expr integral_formula(const std::string& text) {
    Symbols symbols{"a", "b", "c", "x", "t", "s"};
    for (const char* f : {"p", "g1", "bof", "binv"}) {
        symbols.add_function(f, 1);
    }
    return parse(text, symbols);
}

Ball integral_ball(const std::string& text) {
    IntegralSurroundings around;
    around.value = [](const Expr& e) { return evaluate<Ball>(e, IntegralNames{}); };
    around.rational = [](const Expr& e) -> std::optional<Rational> {
        const Rational* q = e.rational();
        return q != nullptr ? std::optional(*q) : std::nullopt;
    };
    around.bits = test_bits;
    return enclosed_integral(integral_formula(text), around, test_digits);
}

} // namespace

TEST_CASE("functions that are singular without a proof: no enclosure") {
    // c - a is zero for these numbers, but this is not proved.
    CHECK_FALSE(integral_ball("integral(1/sqrt(c-s), s, 0, a)").is_finite());
    CHECK_THROWS_AS(static_cast<void>(integral_ball("integral(p(s), s, 0, 1)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("integral(2^s, s, 0, 1)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("integral(s, s, a, c)")), BudgetError);
}

TEST_CASE("zero is proved for rational functions, with b and its inverse, and for nothing else") {
    const auto zero = [](const char* text, bool symmetric = false) {
        return surely_zero(integral_formula(text), symmetric ? EdgeLaw::symmetric : EdgeLaw::any);
    };
    CHECK(zero("a-a"));
    CHECK(zero("x^2-(a-(a-x))^2"));
    CHECK(zero("a/b-(a^2-x^2)/(b*(a-x))+x/b"));
    CHECK(zero("bof(binv(x))-x"));
    CHECK(zero("x+bof(a+(binv(-x)-a)*1)"));
    CHECK(zero("x+binv(bof(-x))"));
    CHECK(zero("bof(x)-x", true));
    CHECK(zero("b-a", true));
    CHECK_FALSE(zero("b-a"));
    CHECK_FALSE(zero("bof(x)-x"));
    CHECK_FALSE(zero("a-c"));
    CHECK_FALSE(zero("bof(binv(x)+a)-x"));
    // The first two are zero only for x >= 0.
    CHECK_FALSE(zero("sqrt(x^2)-x"));
    CHECK_FALSE(zero("x^(1/2)-x^(1/2)"));
    CHECK_FALSE(zero("1/(a-a)"));
}

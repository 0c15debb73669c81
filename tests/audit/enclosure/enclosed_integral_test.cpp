// SPDX-License-Identifier: GPL-3.0-or-later
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

Ball constant_ball(const std::string& text) {
    return evaluate<Ball>(integral_formula(text), IntegralNames{});
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

/// Checks that the integral has the value and that its ball is narrow; returns the fault or an
/// empty text.
std::string fault_of_integral(const std::string& integral, const std::string& value) {
    const Ball found = integral_ball(integral);
    const Ball known = constant_ball(value);
    if (!found.is_finite()) {
        return "not finite";
    }
    if (disjoint(found, known)) {
        return "another value";
    }
    const Ball widest(pow(Real(10), -33), test_bits);
    const Ball size = contains_zero(known) ? Ball(1, test_bits) : abs(known);
    return certainly_less(Ball(found.radius(), test_bits), widest * size) ? "" : "wide";
}

} // namespace

TEST_CASE("integrals of regular functions are enclosed, in either direction") {
    CHECK(fault_of_integral("integral(s^2*exp(s), s, 0, 1)", "exp(1) - 2") == "");
    CHECK(fault_of_integral("integral(s^2*exp(s), s, 1, 0)", "2 - exp(1)") == "");
    CHECK(fault_of_integral("integral(atan(s)/(1 + s^2), s, x, a)", "(atan(a)^2 - atan(x)^2)/2") ==
          "");
    CHECK(fault_of_integral("integral(log(s)*sin(s)/log(s), s, 1/3, 1/2)", "cos(1/3) - cos(1/2)") ==
          "");
}

TEST_CASE("roots that vanish at an end are integrated exactly there") {
    const std::map<std::string, std::string> known{
        {"integral(sqrt(1 - s^2), s, 0, 1)", "Pi/4"},
        {"integral(asin(1/s), s, 1, 2)", "acosh(2) - Pi/6"},
        {"integral(1/sqrt((a-s)*(s+b)), s, -b, a)", "Pi"},
        {"integral(s/sqrt((a-s)*(s+b)), s, -b, a)", "Pi*(a-b)/2"},
        {"integral(sqrt((a-s)*(s+b)), s, -b, a)", "Pi*(a+b)^2/8"},
        {"integral(s/sqrt(a^2-s^2), s, x, a)", "sqrt(a^2-x^2)"},
        {"integral(1/sqrt(s^2-x^2), s, x, a)", "acosh(a/x)"},
        {"integral(1/sqrt(s^2-x^2), s, max(x,t), a)", "acosh(a/x)"},
        {"integral(1/sqrt(s^2-t^2), s, max(x,t), a)", "acosh(a/t) - acosh(x/t)"},
        {"integral(1/sqrt(x-s)*(1/sqrt(1-s/x)), s, 0, x/2)", "sqrt(x)*log(2)"},
        {"integral(s^(-1/2), s, 0, a)", "2*sqrt(a)"},
        {"integral((a-s)^(-2/3), s, 0, a)", "3*a^(1/3)"},
        {"integral(s^(5/8)*sqrt(a-s)/a^(17/8), s, 0, a)", "gamma(13/8)*gamma(3/2)/gamma(25/8)"},
        {"integral((a^3-s^3)^(1/2)*s^2, s, 0, a)", "2/9*a^(9/2)"}};
    for (const auto& row : known) {
        CAPTURE(row.first);
        CHECK(fault_of_integral(row.first, row.second) == "");
    }
}

TEST_CASE("functions that are singular without a proof, not real or not integrable: no enclosure") {
    // c - a is zero for these numbers, but this is not proved.
    CHECK_FALSE(integral_ball("integral(1/sqrt(c-s), s, 0, a)").is_finite());
    CHECK_FALSE(integral_ball("integral(1/sqrt(s-1/2), s, 1/2 - 1/10^40, a)").is_finite());
    CHECK_FALSE(integral_ball("integral(1/(a-s), s, 0, a)").is_finite());
    CHECK_FALSE(integral_ball("integral((a-s)^(-3/2), s, 0, a)").is_finite());
    CHECK_FALSE(integral_ball("integral(1/(s - 1/2), s, 0, 1)").is_finite());
    // The integrand is real in one half of the interval, imaginary in the other.
    CHECK_FALSE(integral_ball("integral(sqrt(1 - s), s, 0, 2)").is_finite());
    CHECK_FALSE(integral_ball("integral(1/sqrt(s-a), s, 0, a)").is_finite());
    CHECK_THROWS_AS(static_cast<void>(integral_ball("integral(p(s), s, 0, 1)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("integral(2^s, s, 0, 1)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("integral(s, s, a, c)")), BudgetError);
}

TEST_CASE("principal values are enclosed") {
    const std::map<std::string, std::string> known{
        {"pv(1/(s-x), s, 0, a, x)", "log((a-x)/x)"},
        {"pv(1/(s^2-x^2), s, 0, a, x)", "log((a-x)/(a+x))/(2*x)"},
        {"pv(1/sqrt((a-s)*(s+b))/(s-x), s, -b, a, x)", "0"},
        {"pv(s/sqrt((a-s)*(s+b))*(1/(s-x)), s, -b, a, x)", "Pi"},
        {"pv(sqrt(a^2-s^2)/(x-s), s, -a, a, x)", "Pi*x"},
        {"pv(1/(sqrt(s)*(s-x)), s, 0, a, x)", "log((sqrt(a)-sqrt(x))/(sqrt(a)+sqrt(x)))/sqrt(x)"}};
    for (const auto& row : known) {
        CAPTURE(row.first);
        CHECK(fault_of_integral(row.first, row.second) == "");
    }
}

TEST_CASE("a principal value without a simple pole inside has no enclosure") {
    CHECK_THROWS_AS(static_cast<void>(integral_ball("pv(1/(s-a), s, 0, a, a)")), BudgetError);
    // A pole outside the interval is allowed; by hand, log(1/2).
    CHECK(fault_of_integral("pv(1/(s-a), s, 0, a/2, a)", "-log(2)") == "");
    CHECK_THROWS_AS(static_cast<void>(integral_ball("pv(1/(s-x)^2, s, 0, a, x)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("pv(s, s, 0, a, x)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("pv(sqrt((s-x)^2)/(s-x), s, 0, a, x)")), Error);
    CHECK_THROWS_AS(static_cast<void>(integral_ball("pv(1/(s-c), s, 0, 2*a, a)")), Error);
}

TEST_CASE("zero is proved for rational functions, with b and its inverse, and for nothing else") {
    const auto zero = [](const char* text, bool symmetric = false) {
        return surely_zero(integral_formula(text), symmetric);
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

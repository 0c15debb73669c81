// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/algebra/identity.hpp"
#include "edgeproof/algebra/laurent.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

namespace {

const Symbols& names() {
    static const Symbols all = [] {
        Symbols s{"a", "b", "c", "m", "t", "x", "y", "P1", "P2"};
        s.add_function("p", 1);
        return s;
    }();
    return all;
}

/// x and y may have either sign; the other names are positive.
Form form(const std::string& text) {
    return form_of(parse(text, names()), [](std::string_view name) {
        return Form::name(name, name != "x" && name != "y");
    });
}

std::string tidy(const std::string& text) { return to_text(form(text).expr()); }

/// Calls check(x, y) for each item "x = y".
template <class Check> void for_pairs(const char* items, const Check& check) {
    test::for_pairs(items, " = ", check);
}

} // namespace

TEST_CASE("formulas that are equal: roots, powers, symbolic exponents, other functions") {
    for_pairs(R"ITEMS(
        (a + b)^2 - a^2 = b*(2*a + b)   1/(x - y) - 1/(y - x) = 2/(x - y)
        sqrt(8*a) = 2*sqrt(2)*sqrt(a)   sqrt(2*a)*sqrt(a/2) = a   sqrt(12)/sqrt(27) = 2/3
        1/sqrt(2) = sqrt(2)/2   sqrt(1/(a*b))*b = sqrt(b/a)
        1/sqrt(a + b) - a/(a + b)^(3/2) = b/(a + b)^(3/2)   sqrt(a^2 + 2*a*b + b^2) = a + b
        sqrt(a^2 - t^2) = sqrt(a - t)*sqrt(a + t)   sqrt((x - y)^3) = (x - y)*sqrt(x - y)
        sqrt((x - t)/(a + y)) = 1/sqrt((a + y)/(x - t))   a^(1/3)*sqrt(a) = a^(5/6)
        (a^(1/4))^2 + a^(1/4) = sqrt(a) + a^(1/4)   sqrt(pi^2/4) = pi/2
        sqrt(2)*sqrt(3) = sqrt(6)   (1 + sqrt(2))^2 = 3 + 2*sqrt(2)   2^(1/3)*4^(1/3) = 2
        16^(1/6) = 4^(1/3)   sqrt(1/3) = sqrt(3)/3   sqrt(sqrt(16/81)) = 2/3   (9/4)^(3/2) = 27/8
        (sqrt(5) + sqrt(7))*(sqrt(5) - sqrt(7)) = -2   sqrt(pi)*sqrt(pi*4) = 2*pi
        sqrt(2*1009^2) = 1009*sqrt(2)   sqrt(1009^3/1009) = 1009   (4*1013^6)^(1/3) = 4^(1/3)*1013^2
        sqrt(sqrt(a)) = a^(1/4)   sqrt(a + sqrt(b))^3 = (a + sqrt(b))*sqrt(a + sqrt(b))
        sqrt(4*a + 4*sqrt(b)) = 2*sqrt(a + sqrt(b))   (sqrt(5) - 1)*(sqrt(5) + 1) = 4
        (a - b)/(sqrt(a) - sqrt(b)) = sqrt(a) + sqrt(b)
        a^(m + 1)/a^(m - 1/2) = a*sqrt(a)   (a*b)^m = a^m*b^m
        (a + b)^(m/2)*sqrt((a + b)^m) = (a + b)^m   6^m = 2^m*3^m   sqrt(a)^(2*m) = a^m
        exp(x + y) = exp(x)*exp(y)   exp(2*log(a)) = a^2   log(exp(x)) = x
        log(exp(6)*exp(x/2)/exp(a)) = 6 + x/2 - a
        log(a*b/b) = log(a)   log(1) = 0   log(3/5) = -log(5/3)   abs(y - x) = abs(x - y)
        abs(-2*a/3) = 2*a/3   sin(x - y) = -sin(y - x)   cosh(-x)*sgn(-x) = -cosh(x)*sgn(x)
        acos(x - y) = pi - acos(y - x)   acos(sqrt(3)/2) = pi/6   acos((pi/8)/(-pi/4)) = 2*pi/3
        acos((sqrt(6) + sqrt(2))/4) = pi/12   acos((sqrt(6) - sqrt(2))/4) = 5*pi/12
        acos((sqrt(2) - sqrt(6))/4) = 7*pi/12   acos(-1) = pi   acos(-sqrt(2)/2) = 3*pi/4
        asin(-1/2) = -pi/6   atan(1/sqrt(3)) = pi/6   cos(5*pi/3) = 1/2   sin(7*pi/6) = -1/2
        tan(3*pi/4) = -1   sin(asin(x)) + cos(acos(x)) = 2*x   gamma(9/2) = 105*sqrt(pi)/16
        gamma(6) = 120   p(a*(x + y)) = p(a*x + a*y)
        integral(p(x), x, 0, a)*2/4 = integral(p(x), x, 0, a)/2
    )ITEMS",
              [](const std::string& x, const std::string& y) {
                  CHECK(form(x) == form(y));
                  CHECK(form("(" + x + ")*a - (" + y + ")*a").is_zero());
              });
}

TEST_CASE("formulas that differ, where x and y may be negative") {
    for_pairs(R"ITEMS(
        sqrt(a) = sqrt(2*a)   sqrt(a + b) = sqrt(a) + sqrt(b)   sqrt(8*a) = 2*sqrt(2)*a
        a^(m + 1) = a^m   a^(1/3) = a^(1/2)   sqrt(x^2) = x   sqrt(x^2*y) = x*sqrt(y)
        sqrt(x*y) = sqrt(-x)*sqrt(-y)   sqrt(2) = 99/70   pi = 22/7   log(2) = log(1)
        sqrt(10) + sqrt(11) = sqrt(5) + sqrt(18)   2^(1/3) = sqrt(2)   acos(1/3) = pi*2/5
        sqrt(2) = 1.41421356237309504880168872420969807856967187537694807317667
        cos(5*pi/3) = -1/2   acos(-1/3) = acos(1/3)   sin(x - y) = sin(y - x)   exp(x) = exp(-x)
        p(a) = p(b)   p(a - b) = p(b - a)   integral(p(x), x, 0, a) = integral(p(x), x, 0, b)
    )ITEMS",
              [](const std::string& x, const std::string& y) { CHECK_FALSE(form(x) == form(y)); });
}

TEST_CASE("tidy formulas: one fraction in separate factors, sums collected by P1, P2") {
    for_pairs(R"ITEMS(
        0 = 0   -1/(a - b) + 1/(b - a) = -(2/(a - b))
        a*P1/(2*sqrt(a + b)) + b*P1/sqrt(4*(a + b)) = P1*sqrt(a + b)/2
        P1*(3 + 2*m)/(3*a^(3/2)) - 4*P2/sqrt(9*a) = ((2*m + 3)*P1 - 4*a*P2)/(3*a^(3/2))
        sqrt(a/b) = sqrt(a)/sqrt(b)   sqrt(x - a)/(a - x) = -(1/sqrt(x - a))
        a^m*a^m/a = a^(2*m - 1)   1/(a^m*2^m) = 1/(2^m*a^m)   pi*sqrt(pi)^(b + 7) = Pi^((9 + b)/2)
        exp(x/2)*exp(x) = exp(3*x/2)   pi*a^2*b/4/2*2 = b*Pi*a^2/4
    )ITEMS",
              [](const std::string& text, const std::string& expected) {
                  CHECK(tidy(text) == expected);
                  CHECK(form(tidy(text)) == form(text));
              });
}

TEST_CASE("derivatives") {
    for_pairs(R"ITEMS(
        a^3/(a + b) = (2*a^3 + 3*a^2*b)/(a + b)^2   sqrt(a^2 + x^2) = a/sqrt(a^2 + x^2)
        a^m = m*a^(m - 1)   m^a = m^a*log(m)   a^a = a^a*(log(a) + 1)   exp(a^2) = 2*a*exp(a^2)
        sin(a)*cos(a) = cos(a)^2 - sin(a)^2   tan(a) + log(a) = 1/cos(a)^2 + 1/a
        asin(a/b) = 1/sqrt(b^2 - a^2)   acos(a/b) = -1/sqrt(b^2 - a^2)
        atan(b*a) = b/(1 + a^2*b^2)   p(b)*a = p(b)
    )ITEMS",
              [](const std::string& text, const std::string& expected) {
                  CHECK(form(text).derivative("a") == form(expected));
              });
    CHECK_THROWS_AS((void)form("p(a)").derivative("a"), Error);
    CHECK_THROWS_AS((void)form("integral(a*x, x, 0, b)").derivative("a"), Error);
}

TEST_CASE("polynomials in a name") {
    const auto c = form("(x*sqrt(a) + b)^2/a").coefficients("x");
    REQUIRE(c);
    REQUIRE(c->size() == 3);
    CHECK((*c)[0] == form("b^2/a"));
    CHECK((*c)[1] == form("2*b/sqrt(a)"));
    CHECK((*c)[2] == form("1"));
    CHECK_FALSE(form("1/(x + a)").coefficients("x"));
    CHECK_FALSE(form("x*sqrt(x + a)").coefficients("x"));
}

TEST_CASE("what has no value, and what is too large, is refused") {
    for (const char* text : {"1/((a + b)^2 - a^2 - b*(2*a + b))", "(a - a)^(-1/2)", "sqrt(-a)"}) {
        CAPTURE(text);
        CHECK_THROWS_AS((void)form(text), DomainError);
    }
    for (const char* text : {"a^1001", "a^(1/10^40)", "gamma(10^9)",
                             "(a + b + c + m + t)^60*(a + x + y + P1 + P2)^60"}) {
        CAPTURE(text);
        CHECK_THROWS_AS((void)form(text), Error);
    }
}

// The factors are linear in a variable of their own, with coprime coefficients, and are therefore
// irreducible.
TEST_CASE("products of polynomials in many variables are split into their factors") {
    std::mt19937_64 draw(20261123);
    const auto drawn = [&](unsigned below) { return std::to_string(draw() % below + 1); };
    for (int round = 0; round < 50; ++round) {
        std::vector<std::string> factors;
        std::string product = drawn(30) + "/12";
        for (const char* own : {"a", "b", "c", "m"}) {
            factors.push_back(std::string(own) + "*(x + " + drawn(5) + ") + y*P1 + " + drawn(7) +
                              "*y^2 + 1");
            product += "*(" + factors.back() + ")";
        }
        const Expr found = form(product).expr();
        CAPTURE(to_text(found));
        CHECK(form(to_text(found)) == form(product));
        for (const std::string& factor : factors) {
            CHECK(to_text(found).find(tidy(factor)) != std::string::npos);
        }
    }
}

TEST_CASE("zeros that the algebra proves, and numbers that it does not decide") {
    const auto zero = [](const char* text) { return proved_zero(parse(text, Symbols{"x"})); };
    for (const char* text :
         {"pi/8 - 2*pi/16", "sqrt(2)*sqrt(3) - sqrt(6)", "acos(-1/3) + acos(1/3) - pi",
          "(x + 1)*(x - 1) - x^2 + 1", "sqrt(x + 1)^2 - x - 1", "abs(-2/3) - 2/3",
          "log(abs((sqrt(2) - sqrt(3))/(sqrt(2) - sqrt(3))))", "atan(x^3) + atan((-x)^3)"}) {
        CAPTURE(text);
        CHECK(zero(text));
    }
    // Numbers that are not zero but tiny; one that cannot be proved; some without a value.
    for (const char* text :
         {"pi - 3141592653589793238462643383279502884197/10^39", "sqrt(2) - 99/70",
          "acos(1/3) - atan(sqrt(8))", "sqrt(x^2) - x", "1/(sqrt(2) - sqrt(2))*0",
          "log(abs((sqrt(2) - sqrt(3))/(sqrt(2) + sqrt(3))))", "abs(-2) + 2",
          "sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2)", "0/(sqrt(3 + 2*sqrt(2)) - 1 - sqrt(2))",
          "log(abs((sqrt(2) - sqrt(2))/(sqrt(2) - sqrt(2))))"}) {
        CAPTURE(text);
        CHECK_FALSE(zero(text));
    }
    CHECK(decided_sign(parse("sqrt(2) - 99/70")) == -1);
    CHECK(decided_sign(parse("pi/8 - 2*pi/16")) == 0);
    CHECK_FALSE(decided_sign(parse("acos(1/3) - atan(sqrt(8))")).has_value());
}

TEST_CASE("elementary functions of an expansion invert each other to the last term") {
    using L = Laurent;
    const L b(Form::name("b", true), 9);
    const auto of = [](Builtin f, const L& y) { return L::call(f, {&y, 1}); };
    using enum Builtin;
    for (const auto& both :
         {std::pair{exp, log}, {log, exp}, {sin, asin}, {cos, acos}, {tan, atan}}) {
        const Builtin outer = both.first;
        const Builtin inner = both.second;
        const Form start(Rational(1, outer == tan ? 1 : 2)); // whose angle is known
        const L x = L(start, 9) + L::power(1, 9) * b - L::power(3, 8);
        const L same = of(outer, of(inner, x));
        for (long k = 0; k < 9; ++k) {
            CHECK_MESSAGE(same[k] == x[k], name_of(outer), k);
        }
    }
    // exp(w) by its factorials
    const L e = of(exp, L::power(1, 8));
    CHECK(e[0] == 1);
    CHECK(e[5] * 120 == 1);
    CHECK_THROWS_AS((void)of(log, L::power(1, 8)), DomainError);
}

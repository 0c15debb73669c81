// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include "edgeproof/formula/parse.hpp"
#include "tests/formula/items.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

const Symbols value_symbols{"x", "y", "n"};

template <class T> T value(std::string_view text, const Values<T>& values = {}) {
    return evaluate<T>(parse(text, value_symbols), values);
}

/// True if |x| < 10^-digits.
bool vanishes(const Real& x, int digits) { return abs(x) < pow(Real(10), -digits); }

// Digits of pi and of the square root of 2 as in OEIS A000796 and A002193.
const char* const pi_100 = "3.141592653589793238462643383279502884197169399375105820974944592307816"
                           "406286208998628034825342117068";
const char* const sqrt2_100 =
    "1.41421356237309504880168872420969807856967187537694807317667973799073"
    "2478462107038850387534327641573";

} // namespace

TEST_CASE("known digits") {
    const PrecisionScope scope(100);
    CHECK(vanishes(value<Real>("Pi") - Real(pi_100), 98));
    CHECK(vanishes(value<Real>("sqrt(2)") - Real(sqrt2_100), 98));
    CHECK(vanishes(value<Real>("2^(1/2)") - Real(sqrt2_100), 98));
}

TEST_CASE_TEMPLATE("identities hold in every arithmetic", T, double, Real) {
    const PrecisionScope scope(200);
    Values<T> values;
    values.set("x", from_rational<T>(Rational(3, 7))).set("y", from_rational<T>(Rational(-11, 13)));
    const T tolerance = T(64) * unit_roundoff<T>();
    for (const std::string& zero : test::items(R"ITEMS(
        6*asin(1/2) - Pi   gamma(1/2)^2 - Pi   3*acos(1/2) - Pi   4*atan(1) - Pi
        16*atan(1/5) - 4*atan(1/239) - Pi   atan2(1, -1) - 3*Pi/4   atan2(-1, -1) + 3*Pi/4
        exp(log(x)) - x   sin(x)^2 + cos(x)^2 - 1   tan(x) - sin(x)/cos(x)
        cosh(x)^2 - sinh(x)^2 - 1   tanh(x) - sinh(x)/cosh(x)   asinh(x) - log(x + sqrt(x^2 + 1))
        acosh(1 + x) - log(1 + x + sqrt((1 + x)^2 - 1))   atanh(x) - log((1 + x)/(1 - x))/2
        gamma(x + 1) - x*gamma(x)   gamma(6) - 120   hypot(3*x, 4*x) - 5*x   abs(y) + y   sgn(y) + 1
        sgn(x) - 1   sgn(x - x)   step(x) - 1   step(y)   step(x - x) - 1/2   max(y, x, 0) - x
        min(y, x, 0) - y   x^(3/2) - x*sqrt(x)   x^(-5/2)*x^3/sqrt(x) - 1   x^-3*x*x*x - 1
        (x^(1/3))^3 - x   y^3 - y*y*y   y^-2 - 1/(y*y)   y^20*y^-20 - 1   x^0 - 1   0^0 - 1
        x^y - exp(y*log(x))   sum(n, n, 1, 10) - 55   sum(x^n, n, 0, 20)*(1 - x) - 1 + x^21
        sum(y^n/n, n, 3, 2)
    )ITEMS")) {
        CAPTURE(zero);
        const T error = value<T>(zero, values);
        CHECK(error <= tolerance);
        CHECK(-error <= tolerance);
    }
}

TEST_CASE("rational parts are rounded once") {
    // In binary64 arithmetic 0.1 + 0.2 - 0.3 is 5.6e-17.
    CHECK(value<double>("0.1 + 0.2 - 0.3") == 0.0);
    CHECK(value<double>("1/3 + 1/3 + 1/3") == 1.0);
    Values<double> values{{"x", 2.0}};
    CHECK(value<double>("x^(1/3 + 1/6)", values) == std::sqrt(2.0));
}

TEST_CASE("outside its domain a function throws, and the error names it and the argument") {
    Values<double> values{{"x", -1.0}, {"y", 0.0}, {"n", 2.0}};
    for (const std::string& text : test::items(R"ITEMS(
        log(x)   log(y)   sqrt(x)   asin(n)   acos(-n)   acosh(y)   atanh(x)   atanh(n)   gamma(x)
        gamma(y)   1/y   y^-1   y^(-1/2)   x^(1/2)   x^(1/3)   x^(n/4)   y^x   atan2(y, y)
        1/(x + n - 1)   1e400*x   1e-400 + x
    )ITEMS")) {
        CAPTURE(text);
        CHECK_THROWS_AS((void)value<double>(text, values), DomainError);
    }
    CHECK_THROWS_WITH_AS((void)value<double>("2 + 3*log(x - 1)", values),
                         "log of a number that is not positive in log(x - 1)", DomainError);
    CHECK_THROWS_WITH_AS((void)value<double>("1 + n/(x + 1)", values),
                         "division by zero in n/(x + 1)", DomainError);
}

TEST_CASE("what the environment does not have is an error") {
    Symbols s = value_symbols;
    s.add_function("f", 2);
    const Expr e = parse("f(x, 2)*3", s);
    Values<double> values{{"x", 5.0}};
    CHECK_THROWS_AS((void)evaluate<double>(e, values), Error);
    struct Difference : Values<double> {
        [[nodiscard]] double call(const Expr& node, std::span<const double> args) const {
            return node.name() == "f" ? args[0] - args[1] : 0;
        }
    };
    Difference with_f;
    with_f.set("x", 5.0);
    CHECK(evaluate<double>(e, with_f) == 9.0);
    CHECK_THROWS_AS((void)value<double>("y", values), Error);
    CHECK_THROWS_AS((void)value<double>("integral(n, n, 0, 1)", values), Error);
}

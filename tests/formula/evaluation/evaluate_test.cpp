// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/evaluation/evaluate.hpp"

#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

namespace {

/// Names with values in balls, for formula::evaluate.
struct BallValues : formula::BallConstants {
    std::map<std::string, Ball, std::less<>> values{};
    [[nodiscard]] Ball symbol(std::string_view name) const {
        const auto it = values.find(name);
        return it != values.end() ? it->second : BallConstants::symbol(name);
    }
};

const Symbols value_symbols{"x", "y", "n"};

Ball value(std::string_view text, const BallValues& values = {{200}}) {
    return evaluate<Ball>(parse(text, value_symbols), values);
}
BallValues with(long x, long y, long n) {
    return {{200}, {{"x", Ball(x, 200)}, {"y", Ball(y, 200)}, {"n", Ball(n, 200)}}};
}

} // namespace

TEST_CASE("identities hold") {
    const long bits = 660;
    const BallValues values{
        {bits}, {{"x", Ball(Rational(3, 7), bits)}, {"y", Ball(Rational(-11, 13), bits)}}};
    for (const std::string& zero : test::items(R"ITEMS(
        6*asin(1/2) - Pi   gamma(1/2)^2 - Pi   3*acos(1/2) - Pi   4*atan(1) - Pi
        16*atan(1/5) - 4*atan(1/239) - Pi   atan2(1, -1) - 3*Pi/4   atan2(-1, -1) + 3*Pi/4
        exp(log(x)) - x   sin(x)^2 + cos(x)^2 - 1   tan(x) - sin(x)/cos(x)
        cosh(x)^2 - sinh(x)^2 - 1   tanh(x) - sinh(x)/cosh(x)   asinh(x) - log(x + sqrt(x^2 + 1))
        acosh(1 + x) - log(1 + x + sqrt((1 + x)^2 - 1))   atanh(x) - log((1 + x)/(1 - x))/2
        gamma(x + 1) - x*gamma(x)   gamma(6) - 120   hypot(3*x, 4*x) - 5*x   abs(y) + y   sgn(y) + 1
        sgn(x) - 1   sgn(0*1)   step(x) - 1   step(y)   step(0) - 1/2   max(y, x, 0) - x
        min(y, x, 0) - y   x^(3/2) - x*sqrt(x)   x^(-5/2)*x^3/sqrt(x) - 1   x^-3*x*x*x - 1
        (x^(1/3))^3 - x   y^3 - y*y*y   y^-2 - 1/(y*y)   y^20*y^-20 - 1   x^0 - 1   0^0 - 1
        x^y - exp(y*log(x))   sum(n, n, 1, 10) - 55   sum(x^n, n, 0, 20)*(1 - x) - 1 + x^21
        sum(y^n/n, n, 3, 2)
    )ITEMS")) {
        CAPTURE(zero);
        const Ball error = value(zero, values);
        CHECK(contains_zero(error));
        CHECK(certainly_less(abs(error), pow_int(Ball(2, bits), 40 - bits)));
    }
}

TEST_CASE("rational parts are rounded once") {
    // In binary64 arithmetic 0.1 + 0.2 - 0.3 is 5.6e-17.
    CHECK(value("0.1 + 0.2 - 0.3").is_exact());
    CHECK(value("1/3 + 1/3 + 1/3").is_exact());
    CHECK(contains(value("x^(1/3 + 1/6)", with(4, 0, 0)), Real(2)));
}

TEST_CASE("outside its domain a function has no finite ball") {
    for (const std::string& text : test::items(R"ITEMS(
        log(x)   log(y)   sqrt(x)   asin(n)   acos(-n)   acosh(y)   atanh(x)   atanh(n)   gamma(x)
        gamma(y)   1/y   y^-1   y^(-1/2)   x^(1/2)   x^(1/3)   x^(n/4)   y^x   atan2(y, y)
        1/(x + n - 1)   2 + 3*log(x - 1)   atan2(Pi - Pi, y)
    )ITEMS")) {
        CAPTURE(text);
        CHECK_FALSE(value(text, with(-1, 0, 2)).is_finite());
    }
}

TEST_CASE("what the environment does not have is an error") {
    Symbols s = value_symbols;
    s.add_function("f", 2);
    const Expr e = parse("f(x, 2)*3", s);
    const BallValues values = with(5, 0, 0);
    CHECK_THROWS_AS((void)evaluate<Ball>(e, values), Error);
    struct Difference : BallValues {
        [[nodiscard]] static Ball call(const Expr& node, std::span<const Ball> args) {
            return node.name() == "f" ? args[0] - args[1] : Ball();
        }
    };
    CHECK(contains(evaluate<Ball>(e, Difference{values}), Real(9)));
    CHECK_THROWS_AS((void)value("y"), Error);
    CHECK_THROWS_AS((void)value("integral(n, n, 0, 1)", values), Error);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/functions.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/evaluation/program.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

/// A type of number that is unknown to the formulas: a value with its derivative. It has some of
/// the functions, but not all.
namespace elsewhere {

struct Dual {
    double v;
    double d;
};
Dual operator-(Dual x) { return {-x.v, -x.d}; }
Dual operator+(Dual x, Dual y) { return {x.v + y.v, x.d + y.d}; }
Dual operator-(Dual x, Dual y) { return {x.v - y.v, x.d - y.d}; }
Dual operator*(Dual x, Dual y) { return {x.v * y.v, x.d * y.v + x.v * y.d}; }
Dual operator/(Dual x, Dual y) { return {x.v / y.v, (x.d - x.v / y.v * y.d) / y.v}; }
Dual sqrt(Dual x) { return {std::sqrt(x.v), x.d / (2 * std::sqrt(x.v))}; }
Dual exp(Dual x) { return {std::exp(x.v), x.d * std::exp(x.v)}; }
Dual log(Dual x) { return {std::log(x.v), x.d / x.v}; }
Dual sin(Dual x) { return {std::sin(x.v), x.d * std::cos(x.v)}; }
Dual cos(Dual x) { return {std::cos(x.v), -x.d * std::sin(x.v)}; }
Dual sgn(Dual x) { return {x.v < 0 ? -1.0 : 1.0, 0}; }

struct Environment {
    double x;
    static Dual number(const edgeproof::Rational& q) { return {q.convert_to<double>(), 0}; }
    static Dual pi() { return {std::acos(-1.0), 0}; }
    [[nodiscard]] Dual symbol(std::string_view) const { return {x, 1}; }
};

} // namespace elsewhere

using elsewhere::Dual;
using elsewhere::Environment;

namespace {

Dual dual(const char* text, double x) {
    return evaluate<Dual>(parse(text, Symbols{"x"}), Environment{x});
}

} // namespace

TEST_CASE("a foreign kind of number brings its own functions") {
    struct Case {
        const char* text;
        double value;
        double derivative;
    };
    const double x = 0.7;
    const double r = std::sqrt(x);
    for (const Case& c : {
             Case{"x^3", x * x * x, 3 * x * x},
             Case{"x^-2", 1 / (x * x), -2 / (x * x * x)},
             Case{"x^0", 1, 0},
             Case{"x^(1/2)", r, 0.5 / r},
             Case{"x^(-3/2)", 1 / (x * r), -1.5 / (x * x * r)},
             Case{"x^(1/3)", std::cbrt(x), std::cbrt(x) / (3 * x)},
             Case{"x^x", std::pow(x, x), std::pow(x, x) * (std::log(x) + 1)},
             Case{"tan(x)", std::tan(x), 1 + std::tan(x) * std::tan(x)},
             Case{"step(x)*x + step(-x)", x, 1},
             Case{"hypot(3*x, 4*x)", 5 * x, 5},
             Case{"Pi*sin(x)/cos(x)", std::acos(-1.0) * std::tan(x),
                  std::acos(-1.0) * (1 + std::tan(x) * std::tan(x))},
         }) {
        CAPTURE(c.text);
        const Dual y = dual(c.text, x);
        CHECK(y.v == doctest::Approx(c.value).epsilon(1e-14));
        CHECK(y.d == doctest::Approx(c.derivative).epsilon(1e-14));
        const Program program(parse(c.text, Symbols{"x"}), {"x"});
        const std::vector<Dual> at{{x, 1}};
        const Dual z = run<Dual>(program, at, constants_of<Dual>(program, Environment{0}));
        CHECK(z.v == y.v);
        CHECK(z.d == y.d);
    }
}

TEST_CASE("a function that it lacks is an error with a name, not a wrong value") {
    CHECK_THROWS_WITH_AS((void)dual("gamma(x)", 0.5),
                         "'gamma' is not defined for the kind of number that a formula is "
                         "evaluated in",
                         Error);
    CHECK_THROWS_AS((void)dual("atan(x)", 0.5), Error);
    CHECK_THROWS_AS((void)dual("max(x, 1)", 0.5), Error);
    CHECK_THROWS_AS((void)dual("abs(x)", 0.5), Error);
    CHECK_THROWS_AS((void)dual("integral(s, s, 0, x)", 0.5), Error);
}

TEST_CASE("a Real result has the digits of the working precision or of its argument") {
    const PrecisionScope low(20);
    const auto half_at = [](unsigned digits) {
        const PrecisionScope scope(digits);
        return Real(Real(1) / 2);
    };
    const std::vector<Real> narrow{half_at(20)};
    const std::vector<Real> wide{half_at(80)};
    using edgeproof::formula::detail::call_builtin;
    CHECK(call_builtin<Real>(Builtin::sqrt, wide).precision() >= 80);
    CHECK(call_builtin<Real>(Builtin::sqrt, narrow).precision() < 30);
    const PrecisionScope high(100);
    const Real root = call_builtin<Real>(Builtin::sqrt, narrow);
    CHECK(abs(root * root - narrow[0]) < Real("1e-99"));
    const Real cube_root = real_power(narrow[0], Rational(1, 3));
    CHECK(abs(cube_root * cube_root * cube_root - narrow[0]) < Real("1e-99"));
}

TEST_CASE("powers of extreme numbers keep their last digits") {
    // Compares x^(p/q) at 50 digits with the same at 120.
    for (const char* base : {"1e-300", "1e300", "1e-40", "7e5", "0.999999"}) {
        for (const Rational& q : {Rational(1, 3), Rational(-2, 3), Rational(5, 2), Rational(-7, 2),
                                  Rational(1, 2), Rational(-1, 2), Rational(617, 1000)}) {
            const auto at = [&](unsigned digits) {
                const PrecisionScope scope(digits);
                return real_power(Real(base), q);
            };
            const Real wide = at(120);
            const PrecisionScope scope(50);
            const Real x(base);
            const PrecisionScope more(120);
            // The base itself is rounded to 50 digits; start from the rounded base.
            const Real exact = real_power(Real(x, 120), q);
            CAPTURE(base);
            CAPTURE(q.str());
            const PrecisionScope back(50);
            CHECK(real_power(x, q) == Real(exact, 50));
            CHECK(abs(exact / wide - 1) < Real("1e-48"));
        }
    }
}

TEST_CASE("integer powers, far out") {
    CHECK(pow_int(2.0, 1023) == 0x1p1023);
    CHECK(pow_int(2.0, -1074) == 0x1p-1074);
    CHECK(pow_int(-1.0, 9'007'199'254'740'993L) == -1.0); // 2^53 + 1 is not a double
    CHECK(pow_int(1.5, 3) == 3.375);
    const PrecisionScope scope(50);
    CHECK(pow_int(Real(3), 100) == Real("515377520732011331036461129765621272702107522001"));
    CHECK_THROWS_AS((void)pow_int(0.0, -1), DomainError);
}

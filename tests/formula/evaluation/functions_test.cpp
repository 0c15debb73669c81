// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/functions.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

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
Dual pow(Dual x, Dual y) { return exp(y * log(x)); }
Dual pow(Dual x, const edgeproof::Rational& q) {
    return {std::pow(x.v, q.convert_to<double>()),
            q.convert_to<double>() * std::pow(x.v, q.convert_to<double>() - 1) * x.d};
}

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
             Case{"hypot(3*x, 4*x)", 5 * x, 5},
             Case{"Pi*sin(x)/cos(x)", std::acos(-1.0) * std::tan(x),
                  std::acos(-1.0) * (1 + std::tan(x) * std::tan(x))},
         }) {
        CAPTURE(c.text);
        const Dual y = dual(c.text, x);
        CHECK(y.v == doctest::Approx(c.value).epsilon(1e-14));
        CHECK(y.d == doctest::Approx(c.derivative).epsilon(1e-14));
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

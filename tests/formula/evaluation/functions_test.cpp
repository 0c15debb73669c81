// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/formula/evaluation/functions.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace elsewhere {

/// A number with few functions.
struct Bare {
    double v;
};
Bare operator-(Bare x) { return {-x.v}; }
Bare operator+(Bare x, Bare y) { return {x.v + y.v}; }
Bare operator-(Bare x, Bare y) { return {x.v - y.v}; }
Bare operator*(Bare x, Bare y) { return {x.v * y.v}; }
Bare operator/(Bare x, Bare y) { return {x.v / y.v}; }
Bare pow(Bare x, Bare y) { return {std::pow(x.v, y.v)}; }
Bare pow(Bare x, const edgeproof::Rational& q) { return pow(x, Bare{q.convert_to<double>()}); }

struct Environment {
    static Bare number(const edgeproof::Rational& q) { return {q.convert_to<double>()}; }
    static Bare pi() { return {3}; }
    [[nodiscard]] static Bare symbol(std::string_view) { return {0.5}; }
};

} // namespace elsewhere

TEST_CASE("a function that an arithmetic lacks is an error with a name, not a wrong value") {
    using namespace elsewhere;
    const auto value = [](const char* text) {
        return evaluate<Bare>(parse(text, Symbols{"x"}), Environment{}).v;
    };
    CHECK(value("x^2/4 - Pi*x^-1") == 0.0625 - 6);
    CHECK_THROWS_WITH_AS((void)value("gamma(x)"), doctest::Contains("'gamma' is not defined for"),
                         Error);
    for (const char* text : {"atan(x)", "abs(x)", "max(x, 1)", "integral(s, s, 0, x)"}) {
        CHECK_THROWS_AS((void)value(text), Error);
    }
}

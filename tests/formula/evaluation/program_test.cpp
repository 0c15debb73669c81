// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/program.hpp"

#include "edgeproof/formula/parse.hpp"
#include "tests/formula/random_expr.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace {

const Symbols program_symbols = [] {
    Symbols s{"x", "y"};
    s.add_function("f", 1);
    return s;
}();

/// Returns the outcome of an evaluation: a value, or the DomainError that was thrown.
template <class F> std::pair<Real, bool> outcome(const F& f) {
    try {
        return {f(), true};
    } catch (const DomainError&) {
        return {Real(0), false};
    }
}

} // namespace

TEST_CASE("random expressions: a program gives what evaluation gives") {
    const PrecisionScope scope(60);
    const std::vector<Real> at{from_rational<Real>(Rational(3, 7)),
                               from_rational<Real>(Rational(11, 5))};
    const Values<Real> values{{"x", at[0]}, {"y", at[1]}};
    std::mt19937_64 random(987654321);
    int defined = 0;
    for (int i = 0; i < 2000; ++i) {
        const Expr e = test::random_expr(random, 6, {"x", "y"});
        CAPTURE(to_text(e));
        const auto direct = outcome([&] { return evaluate<Real>(e, values); });
        const auto compiled = outcome([&] {
            const Program program(e, {"x", "y"});
            return run<Real>(program, at, constants_of<Real>(program));
        });
        CHECK(compiled.second == direct.second);
        // The same operations on the same numbers give equal results to the last bit, unless not a
        // number.
        CHECK((compiled.first == direct.first || isnan(direct.first)));
        defined += direct.second ? 1 : 0;
    }
    // Most of the formulas must be defined.
    CHECK(defined > 1000);
}

TEST_CASE("equal parts are computed once, constant parts beforehand") {
    const auto steps = [](const char* text) {
        return Program(parse(text, program_symbols), {"x", "y"}).steps().size();
    };
    CHECK(steps("x") == 0);
    CHECK(steps("2*Pi/sqrt(3)") == 0);
    CHECK(steps("x + y") == 1);
    CHECK(steps("sqrt(x + y)*sqrt(x + y)") == 3);
    CHECK(steps("(x + sqrt(2)/3)*(x + sqrt(2)/3)") == 2);
    CHECK(steps("sum(x^k, k, 0, 3)") == 4 + 3);
    const Program program(parse("x*(sqrt(2)/3) + sqrt(2)/3", program_symbols), {"x"});
    CHECK(program.constants() == std::vector<Expr>{parse("sqrt(2)/3")});
}

TEST_CASE("one program serves several precisions and arithmetics") {
    const Program program(parse("x^(3/2)/3 + Pi*x^(1/3) + x^-2", program_symbols), {"x"});
    const std::vector<double> x64{2.0};
    const double low = run<double>(program, x64, constants_of<double>(program));
    for (const unsigned digits : {30U, 300U}) {
        const PrecisionScope scope(digits);
        const std::vector<Real> x{Real(2)};
        const Real high = run<Real>(program, x, constants_of<Real>(program));
        const Real expected = 2 * sqrt(Real(2)) / 3 + pi<Real>() * cbrt(Real(2)) + Real(1) / 4;
        CHECK(abs(high - expected) < 100 * unit_roundoff<Real>());
        CHECK(low == doctest::Approx(expected.convert_to<double>()).epsilon(1e-15));
    }
}

TEST_CASE("functions and integrals come from outside") {
    struct Externals {
        [[nodiscard]] double call(const Expr& node, std::span<const double> args) const {
            return node.name() == "f" ? 10 * args[0] : 0;
        }
        [[nodiscard]] double binder(const Expr& node, std::span<const double> at) const {
            // Correct for integrands that are the bound variable.
            return node.kind() == Expr::Kind::integral ? at[0] * at[0] / 2 : 0;
        }
    };
    const Expr e = parse("f(x + 1) + integral(s, s, 0, x)", program_symbols);
    const Program program(e, {"x"});
    const std::array<double, 1> at{4.0};
    CHECK(run<double>(program, at, constants_of<double>(program), Externals{}) == 58.0);
    CHECK_THROWS_AS((void)run<double>(program, at, constants_of<double>(program)), Error);
}

TEST_CASE("misuse is an error, and so is a value outside the domain") {
    CHECK_THROWS_AS(Program(parse("x + y", program_symbols), {"x"}), Error);
    CHECK_THROWS_AS(Program(parse("integral(s*y, s, 0, x)", program_symbols), {"x"}), Error);
    const Program program(parse("2 + log(x - 3)", program_symbols), {"x"});
    const std::array<double, 1> at{1.0};
    const std::array<double, 2> two{1.0, 2.0};
    const auto constants = constants_of<double>(program);
    CHECK_THROWS_WITH_AS((void)run<double>(program, at, constants),
                         "log of a number that is not positive in log(x - 3)", DomainError);
    CHECK_THROWS_AS((void)run<double>(program, two, constants), Error);
    CHECK_THROWS_AS((void)run<double>(program, at, {}), Error);
    CHECK_THROWS_AS((void)run<double>(program, at, {}), Error);
}

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

TEST_CASE("parts that are given, and parts that are written out") {
    // b(x) is an input, f(x) is written out, and f(y) is a constant of the environment.
    const auto written_out = [](const Expr& e) {
        return e.kind() == Expr::Kind::call && e.name() == "f"
                   ? std::optional(e.arg(0) * Expr::number(Rational(10)))
                   : std::nullopt;
    };
    Symbols symbols = program_symbols;
    symbols.add_function("b", 1);
    const auto compiled = [&](const char* text) {
        return Program(parse(text, symbols), {Expr::symbol("x"), parse("b(x)", symbols)},
                       written_out);
    };
    const Program program = compiled("f(x + 1) + b(x) + f(y)");
    struct Negative : Values<double> {
        [[nodiscard]] double call(const Expr& node, std::span<const double> args) const {
            return node.name() == "f" ? -args[0] : 0;
        }
    };
    Negative values;
    values.set("y", 7.0);
    const std::array<double, 2> at{4.0, 0.5};
    CHECK(run<double>(program, at, constants_of<double>(program, values)) == 50 + 0.5 - 7);
    // The source of a step is the part as it is written.
    CHECK(program.steps().back().source == parse("f(x + 1) + b(x) + f(y)", symbols));
    // A factor that is the number 0 removes the other factor.
    for (const char* zero : {"0*log(x)", "log(x)*(1 - 1)", "-(0*x)", "0/x", "f(0*x)"}) {
        CAPTURE(zero);
        const Program none = compiled(zero);
        CHECK(none.result() == 2);
        CHECK(run<double>(none, at, constants_of<double>(none, values)) == 0);
    }
}

TEST_CASE("misuse is an error, and so is a value outside the domain") {
    for (const char* text : {"x + y", "x*f(1)", "x + integral(s, s, 0, 1)"}) {
        const Program lacking(parse(text, program_symbols), {"x"});
        CHECK_THROWS_AS((void)constants_of<double>(lacking), Error);
    }
    for (const char* text : {"f(x)", "integral(s, s, 0, x)", "sum(k, k, 1, x)"}) {
        const Program lacking(parse(text, program_symbols), {"x"});
        CHECK_THROWS_AS((void)run<double>(lacking, std::array{1.0}, constants_of<double>(lacking)),
                        Error);
    }
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/evaluation/program.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "tests/formula/ball_values.hpp"
#include "tests/formula/random_expr.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace {

const Symbols program_symbols = [] {
    Symbols s{"x", "y"};
    s.add_function("f", 1);
    return s;
}();

Program program_of(const Expr& e, const std::vector<std::string>& names) {
    std::vector<Expr> inputs;
    for (const std::string& name : names) {
        inputs.push_back(Expr::symbol(name));
    }
    return {e, inputs, [](const Expr&) { return std::optional<Expr>(); }};
}

/// The operation of a step, with the operands 0, 1, ... as names.
Expr operation(const Program::Part& step) {
    std::vector<Expr> x;
    for (std::size_t i = 0; i < step.operands.size(); ++i) {
        x.push_back(Expr::symbol(std::to_string(i)));
    }
    switch (step.kind) {
    case Expr::Kind::neg:
        return -x[0];
    case Expr::Kind::add:
        return x[0] + x[1];
    case Expr::Kind::sub:
        return x[0] - x[1];
    case Expr::Kind::mul:
        return x[0] * x[1];
    case Expr::Kind::div:
        return x[0] / x[1];
    case Expr::Kind::pow:
        return pow(x[0], step.source.arg(1).rational() != nullptr ? step.source.arg(1) : x[1]);
    default:
        return Expr::call(step.source.name(), x);
    }
}

template <class Values> Ball run(const Program& program, const Values& values) {
    std::vector<Ball> slots;
    for (const Program::Part& part : program.parts()) {
        if (!part.is_operation()) {
            slots.push_back(evaluate<Ball>(part.source, values));
            continue;
        }
        test::BallValues operands{{values.bits}};
        for (std::size_t i = 0; i < part.operands.size(); ++i) {
            operands.values[std::to_string(i)] = slots[part.operands[i]];
        }
        slots.push_back(evaluate<Ball>(operation(part), operands));
    }
    return slots[program.result()];
}

} // namespace

TEST_CASE("random expressions: a program gives what evaluation gives") {
    const test::BallValues values{
        {200}, {{"x", Ball(Rational(3, 7), 200)}, {"y", Ball(Rational(11, 5), 200)}}};
    std::mt19937_64 random(987654321);
    int defined = 0;
    for (int i = 0; i < 2000; ++i) {
        const Expr e = test::random_expr(random, 6, {"x", "y"});
        CAPTURE(to_text(e));
        const Ball direct = evaluate<Ball>(e, values);
        const Ball compiled = run(program_of(e, {"x", "y"}), values);
        // A product with the number 0 has a value in a program even if the other factor has none.
        CHECK((compiled.is_finite() || !direct.is_finite()));
        CHECK((overlaps(compiled, direct) || !direct.is_finite()));
        defined += direct.is_finite() ? 1 : 0;
    }
    // Most of the formulas must be defined.
    CHECK(defined > 1000);
}

TEST_CASE("equal parts are computed once, constant parts beforehand") {
    const auto steps = [](const char* text) {
        return std::ranges::count_if(program_of(parse(text, program_symbols), {"x", "y"}).parts(),
                                     &Program::Part::is_operation);
    };
    CHECK(steps("x") == 0);
    CHECK(steps("2*Pi/sqrt(3)") == 0);
    CHECK(steps("x + y") == 1);
    CHECK(steps("sqrt(x + y)*sqrt(x + y)") == 3);
    CHECK(steps("(x + sqrt(2)/3)*(x + sqrt(2)/3)") == 2);
    CHECK(steps("sum(x^k, k, 0, 3)") == 4 + 3);
    const Program program = program_of(parse("x*(sqrt(2)/3) + sqrt(2)/3", program_symbols), {"x"});
    REQUIRE(program.parts().size() == 4);
    CHECK(program.parts()[1].source == parse("sqrt(2)/3"));
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
    struct Negative : test::BallValues {
        [[nodiscard]] static Ball call(const Expr& node, std::span<const Ball> args) {
            return node.name() == "f" ? -args[0] : Ball(1, 64) / 2;
        }
    };
    const Negative values{{{200}, {{"x", Ball(4, 200)}, {"y", Ball(7, 200)}}}};
    CHECK(contains(run(program, values), Real(50 + 0.5 - 7)));
    // The source of a step is the part as it is written.
    CHECK(program.parts().back().source == parse("f(x + 1) + b(x) + f(y)", symbols));
    // A factor that is the number 0 removes the other factor.
    for (const char* zero : {"0*log(x)", "log(x)*(1 - 1)", "-(0*x)", "0/x", "f(0*x)"}) {
        CAPTURE(zero);
        const Program none = compiled(zero);
        CHECK(none.parts()[none.result()].role == Program::Part::Role::constant);
        CHECK(run(none, values).is_exact());
        CHECK(contains_zero(run(none, values)));
    }
}

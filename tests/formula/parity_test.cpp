// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/parity.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/precision/real.hpp"
#include "tests/formula/random_expr.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <random>
#include <string>

using namespace edgeproof::formula;

namespace {

Expr read(const std::string& text) { return parse(text, Symbols{"x", "c", "k"}); }
Parity of(const std::string& text) { return parity(read(text), "x"); }
bool odd_and_constant(const std::string& text) { return odd_but_for_a_constant(read(text), "x"); }

/// Returns the value at x if it is real.
std::optional<Real> value_at(const Expr& e, const Real& x) {
    Values<Real> values;
    values.set("x", x);
    values.set("c", Real(7) / 5);
    try {
        Real y = evaluate<Real>(e, values);
        if (isfinite(y)) {
            return y;
        }
    } catch (const Error&) { // undefined there
    }
    return std::nullopt;
}

} // namespace

TEST_CASE("even and odd functions are recognised by their form") {
    for (const char* text :
         {"3", "Pi", "c", "c^(1/3)", "x^2", "x*x", "x^-4", "x/x", "cos(x)", "abs(x^3)",
          "sqrt(1 + x^2)", "exp(-x^2)", "sinh(x)^2", "gamma(x^2)", "max(x^2, c)", "hypot(x^2, 1)",
          "integral(k^2, k, 0, 1)", "sin(x)/x", "2^(x^2)"}) {
        CAPTURE(text);
        CHECK(of(text) == Parity::even);
    }
    for (const char* text : {"x", "-x", "x^3", "x^-1", "c*x", "x/3 + x^3/7", "sinh(x)", "x*cos(x)",
                             "x/(1 + x^2)", "tan(x) - x", "atan(x/c)", "sgn(x)",
                             "asin(x)*sqrt(1 - x^2)", "sin(sin(x))", "x*abs(x)", "1/x"}) {
        CAPTURE(text);
        CHECK(of(text) == Parity::odd);
    }
    for (const char* text :
         {"x + 1", "x + x^2", "exp(x)", "sqrt(x)", "x^(3/2)", "x^(1/3)", "x^c", "log(x)", "acos(x)",
          "gamma(x)", "step(x)", "c^x", "max(x, 0)", "max(x, x)", "hypot(x, 1)",
          "sum(x^k, k, 1, 3)", "integral(x*k, k, 0, 1)"}) {
        CAPTURE(text);
        CHECK(of(text) == Parity::undecided);
    }
}

TEST_CASE("an odd function and a constant") {
    for (const char* text : {"x + 1", "3/100 + x + x^3", "(x + 1)*2", "2 - (c - x)/7", "acos(x)",
                             "c", "-(1 + sinh(x))"}) {
        CAPTURE(text);
        CHECK(odd_and_constant(text));
    }
    for (const char* text : {"x + x^2", "x^2 + 1", "(x + 1)^2", "(x + 1)*x", "1/(1 + x)", "exp(x)",
                             "sqrt(x) + 1", "(1 + x)*(1 + x)"}) {
        CAPTURE(text);
        CHECK_FALSE(odd_and_constant(text));
    }
}

TEST_CASE("the parity found for random formulas agrees with their values") {
    std::mt19937_64 random(17);
    const PrecisionScope scope(40);
    int decided = 0;
    for (int k = 0; k < 6000; ++k) {
        const Expr e = test::random_expr(random, 5, {"x", "c"});
        const Parity p = parity(e, "x");
        const bool shifted = odd_but_for_a_constant(e, "x");
        if (p == Parity::undecided && !shifted) {
            continue;
        }
        for (const char* at : {"0.3", "1.7", "5"}) {
            const auto right = value_at(e, Real(at));
            const auto left = value_at(e, -Real(at));
            const auto centre = value_at(e, Real(0));
            if (!right || !left) {
                continue;
            }
            ++decided;
            CAPTURE(to_text(e));
            const Real size = 1 + abs(*right);
            if (p == Parity::even) {
                CHECK(abs(*right - *left) <= size * Real("1e-25"));
            } else if (p == Parity::odd) {
                CHECK(abs(*right + *left) <= size * Real("1e-25"));
            }
            if (shifted && centre) {
                CHECK(abs(*right + *left - 2 * *centre) <= size * Real("1e-25"));
            }
        }
    }
    CHECK(decided > 1000);
}

TEST_CASE("the parity of a deep formula is found in one traversal") {
    Expr e = Expr::symbol("x");
    for (int k = 0; k < 500; ++k) {
        e = Expr::call("sin", {pow(e, Expr::number(3))});
    }
    CHECK(parity(e, "x") == Parity::odd);
}

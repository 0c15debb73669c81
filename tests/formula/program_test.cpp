// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/formula/program.hpp"

#include "edgeproof/formula/parse.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace edgeproof;

TEST_CASE("a program gives what evaluation gives") {
    const Symbols symbols{"x", "y"};
    const std::array<double, 2> at{0.375, 1.5};
    Values<double> values{{"x", at[0]}, {"y", at[1]}};
    for (const char* text :
         {"x", "2", "Pi", "x*y - sqrt(2)/3*x", "sin(x)^2 + cos(x)^2 + sin(x)",
          "x^(3/2) + y^-2 + x^y", "sum(x^k/k, k, 1, 9)", "max(x, y, 1)", "-x/(y - 1)^(-1/2)"}) {
        CAPTURE(text);
        const Expr e = parse(text, symbols);
        const Program program(e, {"x", "y"});
        CHECK(run<double>(program, at, constants_of<double>(program)) ==
              doctest::Approx(evaluate<double>(e, values)).epsilon(1e-15));
    }
}

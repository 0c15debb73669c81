// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/formula/expr.hpp"
#include "tests/support/namespaces.hpp"

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace edgeproof::test {

/// Returns a random tree of at most `height` levels. It uses only the raw output of the engine, so
/// that a seed gives the same tree with every standard library.
inline Expr random_expr(std::mt19937_64& random, int height,
                        const std::vector<std::string>& symbols) {
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const auto leaf = [&]() -> Expr {
        static const std::array numbers{Rational(0),    Rational(1),      Rational(2),
                                        Rational(1, 2), Rational(5, 4),   Rational(12345, 1000),
                                        Rational(3),    Rational(1, 1000)};
        const std::size_t n = below(5);
        return n < 2    ? Expr::number(numbers[below(numbers.size())])
               : n == 2 ? Expr::pi()
                        : Expr::symbol(symbols[below(symbols.size())]);
    };
    if (height <= 1) {
        return leaf();
    }
    const auto child = [&] { return random_expr(random, height - 1, symbols); };
    const std::size_t kind = below(10);
    const Expr x = child();
    switch (kind) {
    case 0:
        return leaf();
    case 1:
        return -x;
    case 2:
        return x + child();
    case 3:
        return x - child();
    case 4:
        return x * child();
    case 5:
        return x / child();
    case 6: {
        static const std::array exponents{Rational(2), Rational(-1), Rational(1, 2),
                                          Rational(-3, 2), Rational(3)};
        return pow(x, below(3) == 0 ? child() : Expr::number(exponents[below(exponents.size())]));
    }
    case 7: {
        static const std::array names{"sin", "atan", "exp", "tanh", "asinh", "abs", "sqrt", "log"};
        return Expr::call(names[below(names.size())], {x});
    }
    case 8:
        return Expr::call(below(2) == 0 ? "max" : "hypot", {x, child()});
    default:
        return x * x - x;
    }
}

} // namespace edgeproof::test

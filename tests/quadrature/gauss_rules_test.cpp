// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/quadrature/theta_cells.hpp"

#include "edgeproof/precision/ball/ball.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace {

/// Returns the rule's value for an even f over -1 < x < 1.
template <class F> Ball integral(const GaussLegendreBalls& rule, const F& f) {
    Ball sum(0, rule.x[0].bits());
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
        const bool middle = rule.x[k].is_exact() && contains_zero(rule.x[k]);
        sum += rule.weight[k] * f(rule.x[k]) * (middle ? 1 : 2);
    }
    return sum;
}

} // namespace

TEST_CASE("Gauss-Legendre: known nodes, and exact to degree 2n - 1 and no further") {
    constexpr long bits = 200;
    // Abramowitz & Stegun, 25.4.30 in closed form: n = 2: 1/sqrt(3); n = 3: sqrt(3/5), 8/9, 5/9.
    CHECK(overlaps(gauss_legendre_balls(2, bits)->x[0], 1 / sqrt(Ball(3, bits))));
    const auto three = gauss_legendre_balls(3, bits);
    CHECK(overlaps(three->x[0], sqrt(Ball(Rational(3, 5), bits))));
    CHECK(contains(three->weight[0], Rational(5, 9)));
    CHECK(contains(three->x[1], Rational(0)));
    CHECK(contains(three->weight[1], Rational(8, 9)));
    for (const std::size_t n : {5U, 38U, 85U}) {
        CAPTURE(n);
        const auto rule = gauss_legendre_balls(n, bits);
        const auto top = static_cast<long>(2 * n);
        const auto power = [&](long e) {
            return integral(*rule, [&](const Ball& x) { return pow_int(x, e); });
        };
        CHECK(contains(power(top - 2), Rational(2, top - 1)));
        CHECK_FALSE(contains(power(top), Rational(2, top + 1)));
        CHECK(power(0).radius() < pow(Real(10), -50));
    }
}

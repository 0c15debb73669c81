// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/gauss_legendre.hpp"

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

Real ten_to(int e) { return pow(Real(10), e); }

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
    }
}

TEST_CASE("enclosed nodes hold the roots of the polynomial, and are narrow") {
    for (const std::size_t n : {1U, 2U, 9U, 40U}) {
        CAPTURE(n);
        const auto rule = gauss_legendre_balls(n, 256);
        REQUIRE(rule->x.size() == (n + 1) / 2);
        Ball total(0, 256);
        for (std::size_t k = 0; k < rule->x.size(); ++k) {
            // (i + 1) P_(i+1) = (2i + 1) x P_i - i P_(i-1)
            const Ball& x = rule->x[k];
            Ball before(1, 256);
            Ball now = x;
            for (long i = 1; i < static_cast<long>(n); ++i) {
                const Ball next = ((2 * i + 1) * x * now - i * before) / (i + 1);
                before = now;
                now = next;
            }
            CHECK(contains_zero(now));
            CHECK(x.radius() < ten_to(-70));
            total += rule->weight[k] * (x.is_exact() && contains_zero(x) ? 1L : 2L);
        }
        CHECK(contains(total, Rational(2)));
        CHECK(total.radius() < ten_to(-70));
    }
}

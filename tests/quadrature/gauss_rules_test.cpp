// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/quadrature/tanh_sinh_nodes.hpp"

#include "edgeproof/precision/ball/ball.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <thread>
#include <vector>

namespace {

/// Returns the rule's value for an f over -1 < x < 1.
template <class F> Real integral(const GaussLegendreRule& rule, const F& f) {
    Real sum(0);
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
        sum += rule.weight[k] * f(rule.x[k]);
        if (rule.x[k] != 0) {
            sum += rule.weight[k] * f(Real(-rule.x[k]));
        }
    }
    return sum;
}

Real ten_to(int e) { return pow(Real(10), e); }

} // namespace

TEST_CASE("Gauss-Legendre: known nodes, and exact to degree 2n - 1 and no further") {
    const PrecisionScope scope(60);
    // Abramowitz & Stegun, 25.4.30 in closed form: n = 2: 1/sqrt(3); n = 3: sqrt(3/5), 8/9, 5/9.
    CHECK(abs(gauss_legendre_rule(2, 200).x[0] - 1 / sqrt(Real(3))) < ten_to(-58));
    const auto three = gauss_legendre_rule(3, 200);
    CHECK(abs(three.x[0] - sqrt(Real(3) / 5)) < ten_to(-58));
    CHECK(abs(three.weight[0] - Real(5) / 9) < ten_to(-58));
    CHECK(three.x[1] == 0);
    CHECK(abs(three.weight[1] - Real(8) / 9) < ten_to(-58));
    for (const std::size_t n : {5U, 38U, 85U}) {
        CAPTURE(n);
        const auto rule = gauss_legendre_rule(n, 200);
        const auto top = static_cast<unsigned>(2 * n);
        const auto power = [&](unsigned e) {
            return integral(rule, [&](const Real& x) { return Real(pow(x, e)); });
        };
        CHECK(abs(power(top - 2) - Real(2) / (top - 1)) < ten_to(-57));
        CHECK(abs(power(top) - Real(2) / (top + 1)) > ten_to(-57));
    }
}

TEST_CASE("a table is made once, also when two threads ask for it together") {
    std::shared_ptr<const GaussLegendreBalls> one;
    std::shared_ptr<const GaussLegendreBalls> other;
    std::thread first([&] { one = gauss_legendre_balls(47, 333); });
    std::thread second([&] { other = gauss_legendre_balls(47, 333); });
    first.join();
    second.join();
    CHECK(one == other);
    CHECK(one->x.size() == 24);
    CHECK(gauss_legendre_balls(47, 334) != one);
    // The rule has the precision asked for, at any precision of the thread.
    const PrecisionScope scope(20);
    CHECK(mpfr_get_prec(gauss_legendre_rule(47, 335).x[3].backend().data()) == 335);
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

TEST_CASE("logarithms of sizes beyond the range of binary64") {
    const PrecisionScope scope(100);
    CHECK(std::abs(ln_size(from_ln_size(-5000.25)) + 5000.25) < 1e-9);
}

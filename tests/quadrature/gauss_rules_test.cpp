// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/quadrature/gauss_legendre.hpp"
#include "edgeproof/quadrature/holomorphic_reach.hpp"
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
        for (std::size_t k = 0; k < rule.x.size(); ++k) {
            CHECK(abs(rule.from_end[k] - (1 - rule.x[k])) < ten_to(-58));
        }
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

TEST_CASE("a limited number of tables is kept, and one in use remains valid") {
    const auto held = gauss_legendre_balls(5, 100);
    const Ball outermost = held->x[0];
    for (long bits = 101; bits < 101 + 3 * static_cast<long>(most_gauss_legendre_tables); ++bits) {
        (void)gauss_legendre_balls(4, bits);
        CHECK(gauss_legendre_tables() <= most_gauss_legendre_tables);
    }
    CHECK(gauss_legendre_tables() == most_gauss_legendre_tables);
    CHECK(arb_equal(held->x[0].data(), outermost.data()) != 0);
    CHECK(gauss_legendre_balls(5, 100) != held);
}

TEST_CASE("the bound by Bernstein's ellipse holds, and is not far off") {
    // The integral of 1/(t - x), t > 1, is ln((t + 1)/(t - 1)); the integrand is holomorphic up to
    // t, and at most 1/(t - vertex) inside.
    const PrecisionScope scope(120);
    for (const double t : {1.02, 1.3, 2.0, 5.0}) {
        for (const std::size_t n : {6U, 14U, 30U}) {
            CAPTURE(t);
            CAPTURE(n);
            const Real pole(t);
            const auto rule = gauss_legendre_rule(n, 400);
            const Real value = integral(rule, [&](const Real& x) { return Real(1 / (pole - x)); });
            const double error = ln_size(Real(value - log((pole + 1) / (pole - 1))));
            const double excess = (t - 1) * (1 - 0.5 / static_cast<double>(n));
            const BernsteinEllipse ellipse = BernsteinEllipse::beyond(1, excess);
            CHECK(std::abs(ellipse.excess() - excess) < 1e-9);
            const double bound = gauss_legendre_log_error(ellipse, -std::log(t - 1 - excess), n);
            CHECK(error <= bound);
            CHECK(error >= bound - 11);
            // The same error needs the same number of nodes.
            CHECK(std::abs(gauss_legendre_nodes_needed(ellipse, -std::log(t - 1 - excess), bound) -
                           static_cast<double>(n)) < 1e-6);
        }
    }
}

TEST_CASE("numbers of nodes go up in steps of at most a tenth, or two") {
    for (double n = 1; n < 3000; n *= 1.07) {
        const auto taken = static_cast<double>(rounded_up_nodes(n));
        CHECK(taken >= n);
        CHECK(taken <= 1.1 * n + 2.2);
    }
}

TEST_CASE("rules with the singular weight in them: exact below degree n, and no further") {
    const PrecisionScope scope(60);
    for (const auto& [p, r] :
         {std::pair{Real(-1) / 4, Real(0)}, std::pair{Real(3) / 8, Real(1) / 8},
          std::pair{Real(-2) / 5, Real(9) / 10}, std::pair{Real(0), Real(0)}}) {
        for (const std::size_t n : {4U, 30U}) {
            const ProductRule rule(n, p, r);
            // The mean of t^j is (p + 1)_j/(p + r + 2)_j (the beta function's ratio).
            Real exact(1);
            for (std::size_t j = 0; j <= 2 * n; ++j) {
                Real mean(0);
                for (std::size_t k = 0; k < n; ++k) {
                    mean += rule.weight[k] * pow(rule.t[k], static_cast<unsigned>(j));
                }
                if (j < n) {
                    CHECK(abs(mean - exact) < ten_to(-57));
                }
                if (j == 2 * n) {
                    CHECK(abs(mean - exact) > ten_to(-57));
                }
                const auto i = static_cast<long>(j);
                exact *= (p + 1 + i) / (p + r + 2 + i);
            }
            for (std::size_t k = 0; k < n; ++k) {
                CHECK(abs(rule.t[k] + rule.from_end[k] - 1) < ten_to(-57));
            }
        }
    }
}

TEST_CASE("a product rule's bound holds for a pole beyond the end, and is not far off") {
    // For the weight t^(-1/2) with mean 1 (t = s^2), the mean of 1/(1 + g - t) is artanh(h)/h h^2,
    // h = (1 + g)^(-1/2). For the weight 1 it is ln(1 + 1/g); Gauss's nodes are twice as good as
    // the bound.
    const PrecisionScope scope(120);
    for (const char* text : {"0.02", "0.3", "4"}) {
        for (const std::size_t n : {6U, 20U}) {
            CAPTURE(text);
            CAPTURE(n);
            const Real g(text);
            const double gap = static_cast<double>(g);
            const double part = 0.5 / static_cast<double>(n); // of the gap, next to the pole
            const double rho = BernsteinEllipse::beyond(1, 2 * (1 - part) * gap).rho;
            const auto error = [&](const ProductRule& rule, const Real& exact) {
                Real mean(0);
                for (std::size_t k = 0; k < n; ++k) {
                    mean += rule.weight[k] / (g + rule.from_end[k]);
                }
                return ln_size(Real(mean - exact));
            };
            const auto bound = [&](const ProductRule& rule) {
                return product_rule_log_error(n, rho, -std::log(part * gap), rule.size);
            };
            const ProductRule plain(n, Real(0), Real(0));
            CHECK(error(plain, log(1 + 1 / g)) <= bound(plain));
            const ProductRule root(n, Real(-1) / 2, Real(0));
            const Real h = 1 / sqrt(Real(1 + g));
            const double missed = error(root, h * log((1 + h) / (1 - h)) / 2);
            CHECK(missed <= bound(root));
            CHECK(missed >= bound(root) - 13);
        }
    }
    // 2 M (1 + size)/((rho - 1) rho^(n - 1)) with M = e, size = 1, rho = 2, n = 3.
    CHECK(std::abs(product_rule_log_error(3, 2, 1, 1) - 1) < 1e-12);
}

TEST_CASE("the estimate by levels: quadratic convergence is detected, and only that") {
    const PrecisionScope scope(100);
    LevelEstimate quick;
    double error = 0;
    for (const int digits : {3, 6, 12, 24}) {
        error = quick.next(Real(1 + ten_to(-digits)));
    }
    // The difference is 1e-12; the estimate claims 1.4 times as many digits.
    CHECK(error < -16 * std::log(10.0));
    CHECK(error > -18 * std::log(10.0));
    LevelEstimate slow;
    for (const int digits : {3, 4, 5, 6}) {
        error = slow.next(Real(1 + ten_to(-digits)));
    }
    CHECK(error > -7.5 * std::log(10.0));
    LevelEstimate first;
    CHECK(first.next(Real(1)) > 0);
    CHECK(std::abs(ln_size(from_ln_size(-5000.25)) + 5000.25) < 1e-9);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/real.hpp"
#include "edgeproof/series/truncated.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

constexpr std::size_t terms = 45;
using S = Series<Rational>;

Rational q(int n, int d = 1) { return Rational(n) / d; }

S sample() {
    // 1 + z/2 - z^2/3 + z^3/5 ...: a series without special properties.
    S s(q(1), terms);
    for (std::size_t k = 1; k < terms; ++k) {
        s[k] = q(k % 2 == 0 ? -1 : 1, static_cast<int>(k) + 1);
    }
    return s;
}

void check_equal(const S& x, const S& y) {
    REQUIRE(x.order() == y.order());
    for (std::size_t k = 0; k < x.order(); ++k) {
        CHECK_MESSAGE(x[k] == y[k], "coefficient ", k);
    }
}

} // namespace

TEST_CASE("arithmetic over the rationals is exact") {
    const S s = sample();
    check_equal(s / s, S(q(1), terms));
    check_equal((s + s) - s, s);
    check_equal((s * s) / s, s);
    CHECK((S::variable(q(0), 4) * S::variable(q(0), 4))[2] == 1);
}

TEST_CASE("a result is known to the smaller order, never more") {
    CHECK((S(q(1), 7) * S(q(1), 4)).order() == 4);
    CHECK((S(q(1), 3) + S(q(1), 9)).order() == 3);
    CHECK(derivative(S(q(1), 5)).order() == 4);
    CHECK(antiderivative(S(q(1), 5), q(0)).order() == 6);
    CHECK_THROWS_AS((void)derivative(S(q(1), 1)), DomainError);
    CHECK_THROWS_AS(S(q(1), 0), DomainError);
    CHECK_THROWS_AS((void)(S(q(1), 3) / S(q(0), 3)), DomainError);
}

TEST_CASE("binomial series: known coefficients") {
    // (1 - z)^(-1/2) has C(2k, k)/4^k (Abramowitz & Stegun 3.6.9), an exact recurrence.
    S one_minus = S(q(1), terms);
    one_minus[1] = q(-1);
    const S s = pow_with_constant<Rational>(one_minus, q(-1, 2), q(1));
    Rational expected = 1;
    for (std::size_t k = 0; k < terms; ++k) {
        CHECK(s[k] == expected);
        expected *= q(2 * static_cast<int>(k) + 1, 2 * static_cast<int>(k) + 2);
    }
    check_equal(s * s * one_minus, S(q(1), terms));
}

TEST_CASE("reversion: the Catalan numbers, and f(g(z)) = z") {
    // z - z^2 reverts to the generating function of the Catalan numbers (OEIS A000108).
    S f(q(0), 12);
    f[1] = 1;
    f[2] = -1;
    const S g = revert(f);
    const int catalan[] = {1, 1, 2, 5, 14, 42, 132, 429, 1430, 4862, 16796};
    for (std::size_t k = 1; k < 12; ++k) {
        CHECK(g[k] == catalan[k - 1]);
    }
    S h = sample();
    h[0] = 0;
    check_equal(compose(h, revert(h)), S::variable(q(0), terms));
    check_equal(compose(revert(h), h), S::variable(q(0), terms));
    CHECK_THROWS_AS((void)revert(sample()), DomainError);
    CHECK_THROWS_AS((void)compose(h, sample()), DomainError);
}

TEST_CASE("a truncated antiderivative undoes the derivative") {
    const S s = sample();
    check_equal(antiderivative(derivative(s), s[0]), s);
}

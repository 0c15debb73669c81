// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/precision.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

TEST_CASE("a power of zero is zero, and two zeros have no angle") {
    const Ball zero(0, 100);
    CHECK(pow(zero, Rational(5, 3)).is_exact());
    CHECK_FALSE(pow(zero, Rational(-5, 3)).is_finite());
    CHECK_FALSE(atan2(zero, zero).is_finite());
    CHECK(atan2(zero, Ball(1, 100)).is_finite());
}

TEST_CASE("arithmetic encloses, and comparisons state only what is certain") {
    const Ball third(Rational(1, 3), 100);
    CHECK(contains(third, Rational(1, 3)));
    CHECK_FALSE(third.is_exact());
    CHECK(contains(third * 3, Rational(1)));
    CHECK(contains_zero(third * 3 - 1));
    CHECK_FALSE(certainly_positive(third * 3 - 1));
    CHECK(certainly_less(third, Ball(Rational(1, 2), 100)));
    const Ball wide = Ball::from_interval(Real(1), Real(2), 100);
    CHECK_FALSE(certainly_less(third + 1, wide));
    CHECK(overlaps(wide, third + 1));
    CHECK(disjoint(wide, third));
    CHECK_FALSE((Ball(1, 64) / (third * 3 - 1)).is_finite());
    CHECK_FALSE(log(wide - 1).is_finite());
    CHECK(contains(Ball::hull(third, wide), Real(1)));
    CHECK(contains(wide, Real(3) / 2));
    CHECK_FALSE(contains(wide, Real(5) / 2));
    CHECK(wide.lower() <= 1);
    CHECK(wide.upper() >= 2);
    CHECK_THROWS_AS((void)Ball::from_interval(Real(2), Real(1), 64), DomainError);
    CHECK_THROWS_AS((void)Ball::around(Real(2), Real(-1), 64), DomainError);
    CHECK((third + Ball(1, 300)).bits() == 300);
}

TEST_CASE("powers take exact paths") {
    const Ball two(2, 200);
    CHECK(contains(pow_int(two, -3), Rational(1, 8)));
    CHECK(overlaps(pow(two, Rational(1, 2)), sqrt(two)));
    CHECK(overlaps(pow(two, Rational(2, 3)), exp(log(two) * 2 / 3)));
    CHECK(pow_int(two, 10).is_exact());
}

TEST_CASE("escalation doubles the bits until they suffice, and fails at the limit") {
    int calls = 0;
    // The terms cancel except for 2^-400, which is invisible at 128 and 256 bits.
    const Rational small(Integer(1), Integer(Integer(1) << 400));
    const auto f = [&](long bits) {
        ++calls;
        return (Ball(Rational(1, 3), bits) + Ball(small, bits)) - Ball(Rational(1, 3), bits);
    };
    const auto enough = [](const Ball& x) { return x.relative_accuracy_bits() > 50; };
    const Ball found = escalate(f, enough);
    CHECK(contains(found, small));
    CHECK(calls == 3);
    const auto zero = [](long bits) { return Ball(Rational(1, 3), bits) * 3 - 1; };
    CHECK_THROWS_AS((void)escalate(zero, enough, {128, 4096}), BudgetError);
}

// The ball has a radius of at most 2^-100 and contains the exact number.
TEST_CASE("max and min of a ball about an exact number end at that number exactly") {
    for (const Rational& limit : {Rational(0), Rational(1), Rational(-3, 8)}) {
        for (const int side : {-1, 0, 1}) {
            const Ball exact(limit, 128);
            const Ball near = Ball::around(Real(exact.midpoint() + side * pow(Real(2), -101)),
                                           pow(Real(2), -100), 128);
            const Ball most = max(near, exact);
            CHECK(most.lower() == exact.midpoint());
            CHECK(most.upper() >= near.upper());
            CHECK(most.upper() <= near.upper() + pow(Real(2), -120));
            CHECK(max(exact, near).lower() == exact.midpoint());
            const Ball least = min(near, exact);
            CHECK(least.upper() == exact.midpoint());
            CHECK(least.lower() <= near.lower());
            const Ball root = sqrt(Ball(most - exact));
            CHECK(root.is_finite());
            CHECK(contains_zero(root));
            CHECK(root.upper() < pow(Real(2), -49));
        }
    }
    const Ball about_one = Ball::around(Real(1), pow(Real(2), -100), 128);
    const Ball arc = acosh(max(about_one, Ball(1, 128)));
    CHECK(arc.is_finite());
    CHECK(contains_zero(arc));
    // acosh(1 + t) = sqrt(2 t) (1 - t/12 + ...)
    CHECK(arc.upper() < pow(Real(2), -49));
    CHECK(arc.upper() > pow(Real(2), -50));
    CHECK(!acosh(about_one).is_finite());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/precision.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <thread>

namespace {

/// Checks that the ball contains f by MPFR at a far higher precision, and is narrow. Returns the
/// first argument for which this fails, and the reason; empty if there is none.
template <class B, class R>
std::string not_enclosed(const B& ball_function, const R& real_function, double lo, double hi) {
    std::mt19937_64 seeded(20240607);
    std::uniform_real_distribution<double> uniform(lo, hi);
    for (int k = 0; k < 200; ++k) {
        const double at = uniform(seeded);
        const PrecisionScope scope(120);
        const Real exact = real_function(Real(at));
        const Ball ball = ball_function(Ball(Real(at), 200));
        // The error of the 120-digit value is at most 1e-119.
        const Ball slack = Ball::around(exact, Real(abs(exact) * pow(Real(10), -117)), 500);
        const char* fault = !ball.is_finite()        ? "not finite"
                            : !overlaps(ball, slack) ? "excludes MPFR's value"
                            : exact != 0 && ball.relative_accuracy_bits() <= 180 ? "wide"
                                                                                 : nullptr;
        if (fault != nullptr) {
            return std::string(fault) + " at " + std::to_string(at);
        }
    }
    return "";
}

} // namespace

#define FAULT(f, of_real, lo, hi)                                                                  \
    not_enclosed([](const Ball& x) { return f(x); },                                               \
                 [](const Real& x) { return Real(of_real(x)); }, lo, hi)

TEST_CASE("functions of exact numbers hold MPFR's values, narrowly") {
    CHECK(FAULT(sqrt, sqrt, 1e-9, 1e9) == "");
    CHECK(FAULT(exp, exp, -50, 50) == "");
    CHECK(FAULT(log, log, 2, 1e9) == "");
    CHECK(FAULT(log1p, log1p, -1e-6, 1e-6) == "");
    CHECK(FAULT(sin, sin, 0.1, 3) == "");
    CHECK(FAULT(tan, tan, 0.1, 1.5) == "");
    CHECK(FAULT(asin, asin, 1e-3, 0.999) == "");
    CHECK(FAULT(acos, acos, -0.99, 0.99) == "");
    CHECK(FAULT(atan, atan, 1e-3, 1e6) == "");
    CHECK(FAULT(asinh, asinh, 1e-3, 1e6) == "");
    CHECK(FAULT(acosh, acosh, 1.5, 1e6) == "");
    CHECK(FAULT(atanh, atanh, 1e-3, 0.99) == "");
    CHECK(FAULT(tanh, tanh, 1e-3, 5) == "");
    CHECK(FAULT(gamma, tgamma, 0.1, 20) == "");
}

TEST_CASE("a power of zero is zero, and two zeros have no angle") {
    const Ball zero(0, 100);
    CHECK(pow(zero, Rational(5, 3)).is_exact());
    CHECK_FALSE(pow(zero, Rational(-5, 3)).is_finite());
    CHECK_FALSE(atan2(zero, zero).is_finite());
    CHECK(atan2(zero, Ball(1, 100)).is_finite());
}

TEST_CASE("2F1 at known values") {
    // 2F1(1/2, 1; 3/2; z^2)... = artanh(z)/z, and 2F1(1, 1; 2; z) = -ln(1-z)/z (DLMF 15.4).
    const long bits = 300;
    const Ball half(Rational(1, 2), bits);
    const Ball one(1, bits);
    const Ball three_halves(Rational(3, 2), bits);
    for (const Rational& z : {Rational(1, 3), Rational(99, 100), Rational(1, 1000000)}) {
        const Ball x(z, bits);
        CHECK(overlaps(hypergeometric_2f1(half, one, three_halves, x * x), atanh(x) / x));
        const Ball value = hypergeometric_2f1(one, one, Ball(2, bits), x);
        CHECK(overlaps(value, -log(1 - x) / x));
        CHECK(value.relative_accuracy_bits() > 200);
    }
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

TEST_CASE("two threads, two precisions") {
    Ball fine;
    std::thread other([&] {
        for (int k = 0; k < 200; ++k) {
            fine = log(Ball(2, 1000));
        }
    });
    Ball coarse;
    for (int k = 0; k < 200; ++k) {
        coarse = log(Ball(2, 80));
    }
    other.join();
    CHECK(contains(coarse, fine));
    CHECK(fine.relative_accuracy_bits() > 980);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/ball/interval.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace {

Interval whole_ends(long lo, long hi) { return {Ball(lo, 64), Ball(hi, 64)}; }

bool ends_at(const Interval& x, long lo, long hi) {
    return x.lower().is_exact() && x.upper().is_exact() && x.lower().midpoint() == lo &&
           x.upper().midpoint() == hi;
}

bool holds(const Interval& x, const Real& y) {
    const Ball lo = x.lower();
    const Ball hi = x.upper();
    return (!lo.is_finite() || lo.midpoint() <= y) && (!hi.is_finite() || y <= hi.midpoint());
}

/// Checks that f of an interval contains f by MPFR at points of the interval. If `tight`, its ends
/// must be no farther from the extreme values than neighbouring values are from each other. Returns
/// the first failure.
template <class I, class R>
std::string misses(const I& of_interval, const R& of_real, double least, double most,
                   bool tight = false) {
    std::mt19937_64 seeded(20261122);
    std::uniform_real_distribution<double> uniform(least, most);
    for (int k = 0; k < 40; ++k) {
        const double one = uniform(seeded);
        const double other = uniform(seeded);
        const auto [lo, hi] = std::minmax(one, other);
        const Interval image = of_interval(Interval(Ball(Real(lo), 64), Ball(Real(hi), 64)));
        const PrecisionScope scope(40);
        const std::string where = " of " + std::to_string(lo) + " to " + std::to_string(hi);
        std::vector<Real> values;
        Real step = pow(Real(10), -35);
        for (int i = 0; i <= 20; ++i) {
            const Real x = Real(lo) + (Real(hi) - Real(lo)) * i / 20;
            values.push_back(of_real(x));
            const Real slack = pow(Real(10), -37) * (1 + abs(values.back()));
            if (!holds(image + Interval(Ball::around(Real(0), slack, 128)), values.back())) {
                return "at " + x.str(10) + where;
            }
            if (i > 0) {
                step = std::max(step, Real(abs(values[values.size() - 2] - values.back())));
            }
        }
        const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
        if (tight && !(image.is_finite() && image.lower().midpoint() >= *smallest - step &&
                       image.upper().midpoint() <= *largest + step)) {
            return "too wide" + where;
        }
    }
    return "";
}

} // namespace

#define MISSES(f, lo, hi)                                                                          \
    misses([](const Interval& x) { return f(x); }, [](const Real& x) { return Real(f(x)); }, lo,   \
           hi, true)

TEST_CASE("functions of an interval hold those of its points, and little more") {
    CHECK(MISSES(sqrt, 0, 9) == "");
    CHECK(MISSES(exp, -5, 5) == "");
    CHECK(MISSES(log, 0.01, 9) == "");
    CHECK(MISSES(sin, -9, 9) == "");
    CHECK(MISSES(cos, -9, 9) == "");
    CHECK(MISSES(tan, -1.5, 1.5) == "");
    CHECK(MISSES(asin, -1, 1) == "");
    CHECK(MISSES(acos, -1, 1) == "");
    CHECK(MISSES(atan, -9, 9) == "");
    CHECK(MISSES(sinh, -5, 5) == "");
    CHECK(MISSES(cosh, -5, 5) == "");
    CHECK(MISSES(tanh, -5, 5) == "");
    CHECK(MISSES(asinh, -5, 5) == "");
    CHECK(MISSES(acosh, 1, 9) == "");
    CHECK(MISSES(atanh, -0.99, 0.99) == "");
    CHECK(MISSES(abs, -2, 3) == "");
}

TEST_CASE("powers and the four operations of intervals hold those of their points") {
    for (const long n : {0L, 1L, 2L, 3L, 6L}) {
        CAPTURE(n);
        CHECK(misses([&](const Interval& x) { return pow_int(x, n); },
                     [&](const Real& x) { return Real(pow(x, static_cast<int>(n))); }, -2, 3,
                     true) == "");
    }
    for (const int n : {-3, -2, 5}) {
        for (const int d : {1, 2, 7}) {
            CAPTURE(n);
            CAPTURE(d);
            CHECK(misses([&](const Interval& x) { return pow(x, Rational(n, d)); },
                         [&](const Real& x) { return Real(pow(x, Real(n) / d)); }, 0.01, 3,
                         true) == "");
        }
    }
    const Interval other = whole_ends(-3, 2);
    for (const int y : {-3, 1, 2}) {
        CHECK(misses([&](const Interval& x) { return x * other - other / (x * x + exp(x)); },
                     [&](const Real& x) { return Real(x * y - y / (x * x + exp(x))); }, -2,
                     3) == "");
        CHECK(misses([&](const Interval& x) { return pow(x, other); },
                     [&](const Real& x) { return Real(pow(x, Real(y))); }, 0.1, 3) == "");
    }
}

TEST_CASE("an interval keeps the ends that it has exactly, and its sign with them") {
    CHECK(ends_at(pow_int(whole_ends(0, 3), 2), 0, 9));
    CHECK(ends_at(pow_int(whole_ends(-2, 3), 2), 0, 9));
    CHECK(ends_at(pow_int(whole_ends(-2, 3), 3), -8, 27));
    CHECK(ends_at(whole_ends(0, 3) * whole_ends(0, 2), 0, 6));
    CHECK(ends_at(whole_ends(-2, 3) * whole_ends(-5, 4), -15, 12));
    CHECK(ends_at(sqrt(whole_ends(-1, 4)), 0, 2));
    CHECK(ends_at(abs(whole_ends(-7, 3)), 0, 7));
    CHECK(ends_at(abs(whole_ends(-7, -3)), 3, 7));
    CHECK(pow(whole_ends(0, 3), Rational(1, 3)).nowhere_negative());
    CHECK((whole_ends(1, 1) - cos(whole_ends(-1, 1))).nowhere_negative());
    CHECK_FALSE(whole_ends(-1, 5).nowhere_negative());
    CHECK_FALSE(whole_ends(-1, 0).negative());
    CHECK(whole_ends(-2, -1).negative());
}

TEST_CASE("an interval that is unbounded at one end is marked so, and keeps the other end") {
    const Interval one = whole_ends(1, 1);
    const Interval far = one / whole_ends(0, 2);
    CHECK(far.lower().midpoint() == 0.5);
    CHECK_FALSE(far.upper().is_finite());
    CHECK(far.nowhere_negative());
    CHECK((one / whole_ends(-2, 0)).negative());
    CHECK((far * whole_ends(0, 1)).nowhere_negative());
    CHECK_FALSE((one / whole_ends(-1, 1)).nowhere_negative());
    CHECK_FALSE((far - far).nowhere_negative());
    CHECK_FALSE(Interval::everything().nowhere_negative());
    CHECK_FALSE(Interval::everything().negative());
    CHECK_FALSE(log(whole_ends(0, 1)).lower().is_finite());
    CHECK_FALSE(tan(whole_ends(1, 2)).is_finite()); // pi/2
    CHECK(pow(whole_ends(0, 4), Rational(-1, 2)).lower().midpoint() == 0.5);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/elementary.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <future>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using OfMpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// Returns the value by MPFR, correctly rounded, at the precision of the thread or at x's own.
Real by_mpfr(OfMpfr f, const Real& x) {
    Real result;
    mpfr_ptr to = result.backend().data();
    mpfr_set_prec(to, std::max(mpfr_get_prec(to), mpfr_get_prec(x.backend().data())));
    f(to, x.backend().data(), MPFR_RNDN);
    return result;
}

/// True if both are the same number with the same precision, or both nan.
bool same(const Real& x, const Real& y) {
    mpfr_srcptr a = x.backend().data();
    mpfr_srcptr b = y.backend().data();
    return mpfr_get_prec(a) == mpfr_get_prec(b) &&
           ((mpfr_nan_p(a) != 0 && mpfr_nan_p(b) != 0) ||
            (mpfr_equal_p(a, b) != 0 && mpfr_signbit(a) == mpfr_signbit(b)));
}

/// Adds x and both its neighbours, with both signs.
void add_about(std::vector<Real>& xs, Real x) {
    mpfr_nextbelow(x.backend().data());
    for (int k = 0; k < 3; ++k) {
        xs.insert(xs.end(), {x, Real(-x)});
        mpfr_nextabove(x.backend().data());
    }
}

/// Returns arguments of every size for which there is another method, and those where the methods
/// meet; those for which the value is next to the midpoint of two numbers; and random numbers.
std::vector<Real> arguments(std::mt19937_64& random) {
    std::vector<Real> xs;
    const auto bits = static_cast<int>(mpfr_get_prec(Real(0).backend().data()));
    for (const int near : {-2 * bits, -bits, -bits / 2, -bits / 3, -17, 0, 20, bits, 2 * bits}) {
        for (int e = near - 3; e <= near + 3; ++e) {
            add_about(xs, ldexp(Real(1), e));
            add_about(xs, ldexp(Real(3), e));
        }
    }
    for (const int e : {-1000000000, -100000, 100000, 1000000000}) {
        add_about(xs, ldexp(Real(1), e));
    }
    add_about(xs, Real(bits));
    add_about(xs, log(Real(2)));
    gmp_randstate_t state;
    gmp_randinit_default(state);
    gmp_randseed_ui(state, random());
    for (int k = 0; k < 200; ++k) {
        Real x;
        mpfr_urandomb(x.backend().data(), state);
        const int e = std::uniform_int_distribution<int>(-bits, bits)(random);
        xs.push_back(ldexp(Real(k % 2 == 0 ? -x : x), k < 100 ? e % 8 : e));
    }
    gmp_randclear(state);
    xs.insert(xs.end(), {Real(0), Real(-Real(0)), std::numeric_limits<Real>::infinity(),
                         Real(-std::numeric_limits<Real>::infinity()),
                         std::numeric_limits<Real>::quiet_NaN()});
    return xs;
}

/// Returns the first argument, at many precisions, for which `ours` differs from MPFR in the last
/// bit; empty if there is none.
std::string first_unlike_mpfr(Real (*ours)(const Real&), OfMpfr theirs) {
    std::mt19937_64 random(20260101);
    for (const unsigned digits : {2U, 3U, 15U, 19U, 34U, 38U, 39U, 70U, 110U, 320U, 1060U, 2500U}) {
        const PrecisionScope scope(digits);
        for (const Real& x : arguments(random)) {
            if (!same(ours(x), by_mpfr(theirs, x))) {
                return x.str() + " at " + std::to_string(digits) + " digits";
            }
        }
    }
    return {};
}

} // namespace

TEST_CASE("the arc tangent by Arb is MPFR's to the last bit") {
    CHECK(first_unlike_mpfr(arc_tangent, mpfr_atan) == "");
    CHECK(arc_tangent(1.0) == std::atan(1.0));
}

TEST_CASE("the exponential less one by Arb is MPFR's to the last bit") {
    CHECK(first_unlike_mpfr(exp_less_one, mpfr_expm1) == "");
    CHECK(exp_less_one(0.5) == std::expm1(0.5));
}

TEST_CASE("a number of more digits than the thread's keeps them") {
    const Real x = [] {
        const PrecisionScope scope(200);
        return Real(Real(1) / 3);
    }();
    const PrecisionScope scope(30);
    CHECK(same(arc_tangent(x), by_mpfr(mpfr_atan, x)));
    CHECK(same(exp_less_one(x), by_mpfr(mpfr_expm1, x)));
    CHECK(mpfr_get_prec(arc_tangent(x).backend().data()) == mpfr_get_prec(x.backend().data()));
}

TEST_CASE("threads with different digits do not affect each other") {
    const auto work = [](unsigned digits) {
        const PrecisionScope scope(digits);
        int unlike = 0;
        for (int k = 1; k < 400; ++k) {
            const Real x = Real(k) / 173;
            unlike += same(arc_tangent(x), by_mpfr(mpfr_atan, x)) ? 0 : 1;
        }
        return unlike;
    };
    auto one = std::async(std::launch::async, work, 60U);
    auto two = std::async(std::launch::async, work, 61U);
    auto three = std::async(std::launch::async, work, 300U);
    CHECK(one.get() == 0);
    CHECK(two.get() == 0);
    CHECK(three.get() == 0);
}

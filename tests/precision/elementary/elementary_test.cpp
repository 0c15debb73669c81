// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/elementary/elementary.hpp"
#include "edgeproof/precision/elementary/fixed_point.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <future>
#include <random>
#include <string>
#include <vector>

namespace {

/// |x - exact| in units of the last place of x.
double ulps(const Real& x, const Real& exact) {
    if (x == exact) {
        return 0;
    }
    const Real off = abs(x - exact);
    const auto bits = mpfr_get_prec(x.backend().data());
    return ldexp(off, static_cast<int>(bits - mpfr_get_exp(x.backend().data())))
        .convert_to<double>();
}

/// By MPFR, correctly rounded, at the precision of the thread.
Real by_mpfr(const Real& x) {
    Real result;
    mpfr_atan(result.backend().data(), x.backend().data(), MPFR_RNDN);
    return result;
}

/// Of both signs and of every size from 2^-least to 2^most, those that tables are entered at, and
/// beside them.
std::vector<Real> arguments(std::mt19937_64& random, int least, int most) {
    std::vector<Real> xs;
    std::uniform_int_distribution<int> exponent(-least, most);
    gmp_randstate_t state;
    gmp_randinit_default(state);
    gmp_randseed_ui(state, random());
    for (int k = 0; k < 300; ++k) {
        Real x;
        mpfr_urandomb(x.backend().data(), state);
        xs.push_back(ldexp(x, k < 200 ? exponent(random) % 24 : exponent(random)));
        if (k % 2 == 0) {
            xs.back() = -xs.back();
        }
    }
    gmp_randclear(state);
    for (const int numerator : {1, 2, 3, 127, 128, 255, 256, 257, 511, 512}) {
        for (const int bits : {9, 17, 18}) {
            const Real x = ldexp(Real(numerator), -bits);
            for (const Real& beside : {x, Real(x * (1 + unit_roundoff<Real>())),
                                       Real(x * (1 - unit_roundoff<Real>())), Real(1 / x)}) {
                xs.push_back(beside);
            }
        }
    }
    return xs;
}

/// The first number, at digits of few and of many limbs and up to where MPFR's takes over, whose
/// value is farther from MPFR's of more digits than 0.51 units of the last place; else nothing.
std::string first_far_from_mpfr(Real (*ours)(const Real&),
                                int (*theirs)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t),
                                const std::function<std::vector<Real>(std::mt19937_64&)>& numbers) {
    std::mt19937_64 random(20260101);
    for (const unsigned digits :
         {2U, 15U, 34U, 70U, 101U, 170U, 320U, 640U, 1060U, 1300U, 3600U, 3700U}) {
        const PrecisionScope scope(digits);
        for (const Real& x : numbers(random)) {
            const Real y = ours(x);
            const PrecisionScope more(digits + 20);
            Real exact;
            theirs(exact.backend().data(), x.backend().data(), MPFR_RNDN);
            if (!(ulps(y, exact) <= 0.51)) {
                return x.str() + " at " + std::to_string(digits) + " digits";
            }
        }
    }
    return {};
}

} // namespace

TEST_CASE("the series by blocks comes to the sum of its terms") {
    using fixed_point::GmpInteger;
    for (mp_bitcnt_t bits = 128; bits < 4000; bits += 64) {
        for (const unsigned zero_bits : {34U, 36U, 50U, 52U}) {
            for (const bool alternating : {false, true}) {
                GmpInteger s;
                mpz_setbit(s.get(), bits - zero_bits);
                mpz_sub_ui(s.get(), s.get(), 12345);
                GmpInteger sum;
                fixed_point::WordSeries::odd(bits, zero_bits, alternating).sum(sum, s);
                GmpInteger power; // with twice the bits after the point
                GmpInteger term;
                GmpInteger plain;
                mpz_setbit(power.get(), 2 * bits);
                for (unsigned k = 0; mpz_sgn(power.get()) > 0; ++k) {
                    mpz_fdiv_q_ui(term.get(), power.get(), 2 * k + 1);
                    if (alternating && k % 2 == 1) {
                        mpz_sub(plain.get(), plain.get(), term.get());
                    } else {
                        mpz_add(plain.get(), plain.get(), term.get());
                    }
                    mpz_mul(power.get(), power.get(), s.get());
                    mpz_fdiv_q_2exp(power.get(), power.get(), bits);
                }
                mpz_fdiv_q_2exp(plain.get(), plain.get(), bits);
                mpz_sub(plain.get(), plain.get(), sum.get());
                CAPTURE(bits);
                CAPTURE(zero_bits);
                CHECK(mpz_cmpabs_ui(plain.get(), 8) < 0);
            }
        }
    }
}

TEST_CASE("the arc tangent beside MPFR's, correctly rounded") {
    const auto numbers = [](std::mt19937_64& random) { return arguments(random, 700, 900); };
    CHECK(first_far_from_mpfr(arc_tangent, mpfr_atan, numbers) == "");
}

TEST_CASE("the exponential less one beside MPFR's, correctly rounded") {
    const auto numbers = [](std::mt19937_64& random) {
        std::vector<Real> xs = arguments(random, 700, 12);
        // Where the tables end, and MPFR's takes over.
        for (const int e : {18, 19, 20, 21}) {
            const Real edge = ldexp(Real(1), e);
            for (const Real& x : {edge, Real(edge * (1 + unit_roundoff<Real>())),
                                  Real(edge * (1 - unit_roundoff<Real>()))}) {
                xs.insert(xs.end(), {x, Real(-x)});
            }
        }
        return xs;
    };
    CHECK(first_far_from_mpfr(exp_less_one, mpfr_expm1, numbers) == "");
}

TEST_CASE("the logarithm of one and more beside MPFR's, correctly rounded") {
    const auto numbers = [](std::mt19937_64& random) {
        std::vector<Real> xs = arguments(random, 700, 900);
        // Where tables are entered: 1 + x at the middle between i/2^8 and the next, and at 3/2 2^e.
        for (const int i : {256, 257, 300, 383, 384, 385, 511}) {
            for (const int e : {0, 1, 40}) {
                const Real edge = ldexp(Real(2 * i + 1), e - 9) - 1;
                xs.insert(xs.end(), {edge, Real(edge * (1 + unit_roundoff<Real>())),
                                     Real(edge * (1 - unit_roundoff<Real>())),
                                     Real(ldexp(Real(i), e - 8) - 1)});
            }
        }
        std::erase_if(xs, [](const Real& x) { return !(x > -1); });
        return xs;
    };
    CHECK(first_far_from_mpfr(log_of_one_plus, mpfr_log1p, numbers) == "");
}

TEST_CASE("what an arc tangent cannot be worked out of as others are") {
    const PrecisionScope scope(50);
    const Real infinite = std::numeric_limits<Real>::infinity();
    CHECK(arc_tangent(Real(0)) == 0);
    CHECK(arc_tangent(infinite) == by_mpfr(infinite));
    CHECK(isnan(arc_tangent(std::numeric_limits<Real>::quiet_NaN())));
    CHECK(arc_tangent(Real(1)) == pi<Real>() / 4);
    CHECK(arc_tangent(1.0) == std::atan(1.0));
    CHECK(log_of_one_plus(Real(0)) == 0);
    CHECK(log_of_one_plus(infinite) == infinite);
    CHECK(isnan(log_of_one_plus(Real(-2))));
    CHECK(isnan(log_of_one_plus(std::numeric_limits<Real>::quiet_NaN())));
    CHECK(log_of_one_plus(0.5) == std::log1p(0.5));
}

TEST_CASE("a number of more digits than the thread's keeps them") {
    Real x;
    {
        const PrecisionScope scope(200);
        x = Real(1) / 3;
    }
    const Real wide = [&] {
        const PrecisionScope scope(30);
        return arc_tangent(x);
    }();
    const PrecisionScope scope(200);
    CHECK(ulps(wide, by_mpfr(x)) <= 1);
}

TEST_CASE("threads with different digits have tables of their own") {
    const auto work = [](unsigned digits) {
        const PrecisionScope scope(digits);
        double worst = 0;
        for (int k = 1; k < 400; ++k) {
            const Real x = Real(k) / 173;
            worst = std::max(worst, ulps(arc_tangent(x), by_mpfr(x)));
        }
        return worst;
    };
    auto one = std::async(std::launch::async, work, 60U);
    auto two = std::async(std::launch::async, work, 61U);
    auto three = std::async(std::launch::async, work, 300U);
    CHECK(one.get() <= 1);
    CHECK(two.get() <= 1);
    CHECK(three.get() <= 1);
}

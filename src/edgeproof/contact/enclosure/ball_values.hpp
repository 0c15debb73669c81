// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"

#include <cstddef>
#include <vector>

/// Small operations on balls that the searches of this module share.
namespace edgeproof::contact {

/// The exact midpoint of x.
[[nodiscard]] inline Ball middle(const Ball& x) { return {x.midpoint(), x.bits()}; }
/// The exact ends of x, rounded outwards at its precision.
[[nodiscard]] inline Ball lower_end(const Ball& x) { return {x.lower(), x.bits()}; }
[[nodiscard]] inline Ball upper_end(const Ball& x) { return {x.upper(), x.bits()}; }

/// Returns a ball that is not finite, for a value that cannot be enclosed.
[[nodiscard]] inline Ball unknown_ball(long bits) {
    Ball x(0, bits);
    arb_indeterminate(x.data());
    return x;
}
[[nodiscard]] inline BallSeries unknown_series(std::size_t order, long bits) {
    return BallSeries(std::vector<Ball>(order, unknown_ball(bits)));
}

/// 2^k, exactly.
[[nodiscard]] inline Ball power_of_two(long k, long bits) {
    Ball x(1, bits);
    arb_mul_2exp_si(x.data(), x.data(), k);
    return x;
}
[[nodiscard]] inline Rational power_of_two(long k) {
    const Integer p = Integer(1) << static_cast<unsigned>(k < 0 ? -k : k);
    return k < 0 ? Rational(1, p) : Rational(p);
}

/// The rational number that is equal to x.
[[nodiscard]] inline Rational exact_value(const Real& x) {
    Rational q;
    mpfr_get_q(q.backend().data(), x.backend().data());
    return q;
}
/// A rational number with few digits in the interval, near its middle.
[[nodiscard]] inline Rational middle(const Rational& lo, const Rational& hi) {
    const Ball m(Rational((lo + hi) / 2), 64);
    const Rational near = exact_value(m.midpoint());
    return near > lo && near < hi ? near : Rational((lo + hi) / 2);
}

/// The rational number with the smallest denominator from lo to hi.
[[nodiscard]] inline Rational simplest_between(const Rational& lo, const Rational& hi) {
    FmpqValue simplest;
    fmpq_simplest_between(simplest, to_fmpq(lo), to_fmpq(hi));
    return from_fmpq(simplest);
}

/// The ball about 0 of all numbers that are at most `size` in magnitude.
[[nodiscard]] inline Ball up_to(const Ball& size) {
    return Ball::around(Real(0), size.upper(), size.bits());
}

/// The approximate midpoint in binary64.
[[nodiscard]] inline double approximate(const Ball& x) {
    return arf_get_d(arb_midref(x.data()), ARF_RND_NEAR);
}

/// c_0 + c_1 x + ... by Horner's rule; `c` is not empty.
template <class T> [[nodiscard]] T horner(const std::vector<T>& c, const T& x) {
    T sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;) {
        sum = sum * x + c[k];
    }
    return sum;
}

} // namespace edgeproof::contact

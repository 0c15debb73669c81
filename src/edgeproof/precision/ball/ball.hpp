// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/ball/arb_values.hpp"
#include "edgeproof/precision/real.hpp"

#include <algorithm>
#include <limits>

namespace edgeproof {

/// A real number within a proved radius of a midpoint (Arb, johansson2017). Every operation
/// encloses the exact result for every choice of operands from their balls. A ball carries its
/// working precision in bits, and a result has the larger one of its operands: there is no global
/// or thread-local state. Where a function is not defined on the whole ball the result is not
/// finite.
class Ball {
public:
    /// 0 at 64 bits.
    Ball() : bits_(64) {}
    Ball(long value, long bits) : bits_(bits) { arb_set_si(x_, value); }
    /// A ball around q at `bits` that contains q.
    Ball(const Rational& q, long bits);
    /// Exactly the number x.
    Ball(const Real& x, long bits);

    [[nodiscard]] static Ball pi(long bits);
    /// Returns a ball that contains all numbers from lo to hi. Throws DomainError for lo > hi or an
    /// end that is not finite.
    [[nodiscard]] static Ball from_interval(const Real& lo, const Real& hi, long bits);
    /// Returns (nearly) the smallest ball that contains both.
    [[nodiscard]] static Ball hull(const Ball& x, const Ball& y);
    /// Returns midpoint +- radius, radius >= 0.
    [[nodiscard]] static Ball around(const Real& midpoint, const Real& radius, long bits);

    [[nodiscard]] long bits() const noexcept { return bits_; }
    /// The same ball with another working precision.
    [[nodiscard]] Ball with_bits(long bits) const {
        Ball r(*this);
        r.bits_ = bits;
        return r;
    }
    /// The midpoint, exactly.
    [[nodiscard]] Real midpoint() const;
    /// The radius, rounded up to 30 bits.
    [[nodiscard]] Real radius() const;
    /// The end points, rounded outwards at the precision of the ball.
    [[nodiscard]] Real lower() const;
    [[nodiscard]] Real upper() const;
    [[nodiscard]] bool is_finite() const { return arb_is_finite(x_) != 0; }
    [[nodiscard]] bool is_exact() const { return arb_is_exact(x_) != 0; }
    /// About -log2(radius/|midpoint|).
    /// The greatest long for a number without a radius.
    [[nodiscard]] long relative_accuracy_bits() const {
        return static_cast<long>(std::clamp<slong>(arb_rel_accuracy_bits(x_),
                                                   std::numeric_limits<long>::min(),
                                                   std::numeric_limits<long>::max()));
    }

    // Defined in ball.cpp: of inline functions the linker may keep the slower copy of a module that
    // is compiled with -Og.
    Ball& operator+=(const Ball& o);
    Ball& operator-=(const Ball& o);
    Ball& operator*=(const Ball& o);
    Ball& operator/=(const Ball& o);
    Ball& operator+=(long k);
    Ball& operator-=(long k);
    Ball& operator*=(long k);
    Ball& operator/=(long k);
    friend Ball operator-(Ball x);
    friend Ball operator+(Ball x, const Ball& y);
    friend Ball operator-(Ball x, const Ball& y);
    friend Ball operator*(Ball x, const Ball& y);
    friend Ball operator/(Ball x, const Ball& y);
    friend Ball operator+(Ball x, long k);
    friend Ball operator-(Ball x, long k);
    friend Ball operator*(Ball x, long k);
    friend Ball operator/(Ball x, long k);
    friend Ball operator+(long k, Ball x);
    friend Ball operator-(long k, Ball x);
    friend Ball operator*(long k, Ball x);
    friend Ball operator/(long k, const Ball& x);

    /// For the functions below, and for code that calls Arb.
    [[nodiscard]] arb_srcptr data() const noexcept { return x_; }
    [[nodiscard]] arb_ptr data() noexcept { return x_; }

private:
    /// Sets the working precision to that of o if that is larger, and returns it.
    long widen(const Ball& o) { return bits_ = bits_ < o.bits_ ? o.bits_ : bits_; }
    ArbValue x_;
    long bits_;
};

/// Certain statements: each is true if it holds for every pair of numbers in the balls.
[[nodiscard]] inline bool certainly_less(const Ball& x, const Ball& y) {
    return arb_lt(x.data(), y.data()) != 0;
}
[[nodiscard]] inline bool certainly_positive(const Ball& x) {
    return arb_is_positive(x.data()) != 0;
}
[[nodiscard]] inline bool certainly_negative(const Ball& x) {
    return arb_is_negative(x.data()) != 0;
}
[[nodiscard]] inline bool contains_zero(const Ball& x) { return arb_contains_zero(x.data()) != 0; }
/// False if the balls are proved to have no number in common.
[[nodiscard]] inline bool overlaps(const Ball& x, const Ball& y) {
    return arb_overlaps(x.data(), y.data()) != 0;
}
[[nodiscard]] inline bool disjoint(const Ball& x, const Ball& y) { return !overlaps(x, y); }
[[nodiscard]] bool contains(const Ball& x, const Real& point);
[[nodiscard]] bool contains(const Ball& x, const Rational& point);
[[nodiscard]] inline bool contains(const Ball& outer, const Ball& inner) {
    return arb_contains(outer.data(), inner.data()) != 0;
}

[[nodiscard]] Ball abs(const Ball& x);
[[nodiscard]] Ball sgn(const Ball& x);
[[nodiscard]] Ball sqrt(const Ball& x);
[[nodiscard]] Ball exp(const Ball& x);
[[nodiscard]] Ball log(const Ball& x);
[[nodiscard]] Ball log1p(const Ball& x);
[[nodiscard]] Ball sin(const Ball& x);
[[nodiscard]] Ball cos(const Ball& x);
[[nodiscard]] Ball tan(const Ball& x);
[[nodiscard]] Ball asin(const Ball& x);
[[nodiscard]] Ball acos(const Ball& x);
[[nodiscard]] Ball atan(const Ball& x);
[[nodiscard]] Ball atan2(const Ball& y, const Ball& x);
[[nodiscard]] Ball sinh(const Ball& x);
[[nodiscard]] Ball cosh(const Ball& x);
[[nodiscard]] Ball tanh(const Ball& x);
[[nodiscard]] Ball asinh(const Ball& x);
[[nodiscard]] Ball acosh(const Ball& x);
[[nodiscard]] Ball atanh(const Ball& x);
[[nodiscard]] Ball gamma(const Ball& x);
[[nodiscard]] Ball hypot(const Ball& x, const Ball& y);
[[nodiscard]] Ball max(const Ball& x, const Ball& y);
[[nodiscard]] Ball min(const Ball& x, const Ball& y);
[[nodiscard]] Ball pow(const Ball& x, const Ball& y);
[[nodiscard]] Ball pow(const Ball& x, const Rational& y);
[[nodiscard]] Ball pow_int(const Ball& x, long n);
/// Gauss's 2F1(a, b; c; z) for z < 1 (DLMF 15.2.1).
[[nodiscard]] Ball hypergeometric_2f1(const Ball& a, const Ball& b, const Ball& c, const Ball& z);

/// The pointers that the functions of MPFR take: loops call these functions
/// without temporaries.
[[nodiscard]] inline mpfr_ptr raw(Real& x) { return x.backend().data(); }
[[nodiscard]] inline mpfr_srcptr raw(const Real& x) { return x.backend().data(); }

} // namespace edgeproof

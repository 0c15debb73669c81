// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/ball/ball.hpp"

#include "edgeproof/precision/error.hpp"

#include <utility>

namespace edgeproof {
namespace {

/// Returns an arf as a Real, exactly or rounded to `bits` in the given direction.
Real to_real(arf_srcptr x, long bits, mpfr_rnd_t rounding) {
    Real r;
    mpfr_set_prec(r.backend().data(), bits < 2 ? 2 : bits);
    arf_get_mpfr(r.backend().data(), x, rounding);
    return r;
}

void set_exactly(arf_ptr target, const Real& x) { arf_set_mpfr(target, x.backend().data()); }

template <class F> Ball apply(const Ball& x, F f) {
    Ball r(0, x.bits());
    f(r.data(), x.data(), x.bits());
    return r;
}
template <class F> Ball apply(const Ball& x, const Ball& y, F f) {
    const long bits = x.bits() < y.bits() ? y.bits() : x.bits();
    Ball r(0, bits);
    f(r.data(), x.data(), y.data(), bits);
    return r;
}

/// Returns the ball from `least`, which is exact, to the upper end of `other`. The lower end of the
/// result is exactly `least`, so that sqrt(max(x, 0)) has a value.
Ball from_exactly(const Ball& least, const Ball& other) {
    ArfValue half;
    arb_get_ubound_arf(half, other.data(), MAG_BITS + other.bits());
    arf_sub(half, half, arb_midref(least.data()), MAG_BITS, ARF_RND_UP);
    arf_mul_2exp_si(half, half, -1);
    Ball r(0, other.bits());
    arf_get_mag(arb_radref(r.data()), half);
    arf_set_mag(half, arb_radref(r.data()));
    arf_add(arb_midref(r.data()), arb_midref(least.data()), half, ARF_PREC_EXACT, ARF_RND_DOWN);
    return r;
}

} // namespace

Ball::Ball(const Rational& q, long bits) : bits_(bits) { arb_set_fmpq(x_, to_fmpq(q), bits); }

Ball::Ball(const Real& x, long bits) : bits_(bits) { set_exactly(arb_midref(x_), x); }

Ball Ball::pi(long bits) {
    Ball r(0, bits);
    arb_const_pi(r.x_, bits);
    return r;
}

Ball Ball::from_interval(const Real& lo, const Real& hi, long bits) {
    if (!(lo <= hi) || !isfinite(lo) || !isfinite(hi)) {
        throw DomainError("a ball needs finite ends in order");
    }
    Ball r(0, bits);
    arb_set_interval_mpfr(r.x_, lo.backend().data(), hi.backend().data(), bits);
    return r;
}

Ball Ball::hull(const Ball& x, const Ball& y) {
    const long bits = x.bits_ < y.bits_ ? y.bits_ : x.bits_;
    Ball r(0, bits);
    arb_union(r.x_, x.x_, y.x_, bits);
    return r;
}

Ball Ball::around(const Real& midpoint, const Real& radius, long bits) {
    if (!(radius >= 0)) {
        throw DomainError("a ball needs a radius that is not negative");
    }
    Ball r(midpoint, bits);
    ArfValue error;
    set_exactly(error, radius);
    arb_add_error_arf(r.x_, error);
    return r;
}

Real Ball::midpoint() const { return to_real(arb_midref(x_), arf_bits(arb_midref(x_)), MPFR_RNDN); }

Real Ball::radius() const {
    ArfValue r;
    arf_set_mag(r, arb_radref(x_));
    return to_real(r, 30, MPFR_RNDU);
}

Real Ball::lower() const {
    ArfValue end;
    arb_get_lbound_arf(end, x_, bits_);
    return to_real(end, bits_, MPFR_RNDD);
}

Real Ball::upper() const {
    ArfValue end;
    arb_get_ubound_arf(end, x_, bits_);
    return to_real(end, bits_, MPFR_RNDU);
}

bool contains(const Ball& x, const Real& point) {
    ArfValue p;
    set_exactly(p, point);
    return arb_contains_arf(x.data(), p) != 0;
}

bool contains(const Ball& x, const Rational& point) {
    return arb_contains_fmpq(x.data(), to_fmpq(point)) != 0;
}

Ball& Ball::operator+=(const Ball& o) {
    arb_add(x_, x_, o.x_, widen(o));
    return *this;
}
Ball& Ball::operator-=(const Ball& o) {
    arb_sub(x_, x_, o.x_, widen(o));
    return *this;
}
Ball& Ball::operator*=(const Ball& o) {
    arb_mul(x_, x_, o.x_, widen(o));
    return *this;
}
Ball& Ball::operator/=(const Ball& o) {
    arb_div(x_, x_, o.x_, widen(o));
    return *this;
}
Ball& Ball::operator*=(long k) {
    arb_mul_si(x_, x_, k, bits_);
    return *this;
}
Ball& Ball::operator/=(long k) {
    arb_div_si(x_, x_, k, bits_);
    return *this;
}
Ball& Ball::operator+=(long k) {
    arb_add_si(x_, x_, k, bits_);
    return *this;
}
Ball& Ball::operator-=(long k) {
    arb_sub_si(x_, x_, k, bits_);
    return *this;
}
Ball operator-(Ball x) {
    arb_neg(x.x_, x.x_);
    return x;
}
Ball operator+(Ball x, const Ball& y) { return std::move(x += y); }
Ball operator-(Ball x, const Ball& y) { return std::move(x -= y); }
Ball operator*(Ball x, const Ball& y) { return std::move(x *= y); }
Ball operator/(Ball x, const Ball& y) { return std::move(x /= y); }
Ball operator+(Ball x, long k) { return std::move(x += k); }
Ball operator-(Ball x, long k) { return std::move(x -= k); }
Ball operator*(Ball x, long k) { return std::move(x *= k); }
Ball operator/(Ball x, long k) { return std::move(x /= k); }
Ball operator+(long k, Ball x) { return std::move(x += k); }
Ball operator-(long k, Ball x) { return -std::move(x -= k); }
Ball operator*(long k, Ball x) { return std::move(x *= k); }
Ball operator/(long k, const Ball& x) { return Ball(k, x.bits_) / x; }

Ball abs(const Ball& x) {
    return apply(x, [](arb_ptr r, arb_srcptr v, long) { arb_abs(r, v); });
}
Ball sgn(const Ball& x) {
    return apply(x, [](arb_ptr r, arb_srcptr v, long) { arb_sgn(r, v); });
}
Ball sqrt(const Ball& x) { return apply(x, arb_sqrt); }
Ball exp(const Ball& x) { return apply(x, arb_exp); }
Ball log(const Ball& x) { return apply(x, arb_log); }
Ball log1p(const Ball& x) { return apply(x, arb_log1p); }
Ball sin(const Ball& x) { return apply(x, arb_sin); }
Ball cos(const Ball& x) { return apply(x, arb_cos); }
Ball tan(const Ball& x) { return apply(x, arb_tan); }
Ball asin(const Ball& x) { return apply(x, arb_asin); }
Ball acos(const Ball& x) { return apply(x, arb_acos); }
Ball atan(const Ball& x) { return apply(x, arb_atan); }
Ball sinh(const Ball& x) { return apply(x, arb_sinh); }
Ball cosh(const Ball& x) { return apply(x, arb_cosh); }
Ball tanh(const Ball& x) { return apply(x, arb_tanh); }
Ball asinh(const Ball& x) { return apply(x, arb_asinh); }
Ball acosh(const Ball& x) {
    const Ball value = apply(x, arb_acosh);
    if (value.is_finite() || !x.is_finite() || x.lower() < 1) {
        return value;
    }
    // acosh increases from 1 on, and lies between its values at both ends.
    const Ball least = apply(Ball(x.lower(), x.bits()), arb_acosh);
    return Ball::hull(least, apply(Ball(x.upper(), x.bits()), arb_acosh));
}
Ball atanh(const Ball& x) { return apply(x, arb_atanh); }
Ball gamma(const Ball& x) { return apply(x, arb_gamma); }
Ball atan2(const Ball& y, const Ball& x) {
    Ball angle = apply(y, x, arb_atan2);
    if (contains_zero(y) && contains_zero(x)) {
        arb_indeterminate(angle.data()); // Arb's angle of two zeros is 0
    }
    return angle;
}
Ball hypot(const Ball& x, const Ball& y) { return apply(x, y, arb_hypot); }
Ball max(const Ball& x, const Ball& y) {
    if (y.is_exact() && !x.is_exact() && overlaps(x, y)) {
        return from_exactly(y, x);
    }
    if (x.is_exact() && !y.is_exact() && overlaps(x, y)) {
        return from_exactly(x, y);
    }
    return apply(x, y, arb_max);
}
Ball min(const Ball& x, const Ball& y) { return -max(-x, -y); }
Ball pow(const Ball& x, const Ball& y) { return apply(x, y, arb_pow); }

Ball pow(const Ball& x, const Rational& y) {
    Ball r(0, x.bits());
    if (arb_is_zero(x.data()) != 0 && y > 0) {
        return r; // Arb takes no cube root of zero
    }
    arb_pow_fmpq(r.data(), x.data(), to_fmpq(y), x.bits());
    return r;
}

Ball pow_int(const Ball& x, long n) {
    Ball r(0, x.bits());
    FmpzValue e;
    fmpz_set_si(e, n);
    arb_pow_fmpz(r.data(), x.data(), e, x.bits());
    return r;
}

Ball hypergeometric_2f1(const Ball& a, const Ball& b, const Ball& c, const Ball& z) {
    Ball r(0, z.bits());
    arb_hypgeom_2f1(r.data(), a.data(), b.data(), c.data(), z.data(), 0, z.bits());
    return r;
}

} // namespace edgeproof

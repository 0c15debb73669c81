// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/ball/interval.hpp"

namespace edgeproof {
namespace {

/// Returns the end of a ball; infinite where the ball is not known.
void lower_end(arf_ptr r, const Ball& x) {
    arb_get_lbound_arf(r, x.data(), Interval::bits);
    if (arf_is_nan(r) != 0) {
        arf_neg_inf(r);
    }
}
void upper_end(arf_ptr r, const Ball& x) {
    arb_get_ubound_arf(r, x.data(), Interval::bits);
    if (arf_is_nan(r) != 0) {
        arf_pos_inf(r);
    }
}

/// A product of ends: infinity times 0 is 0, the limit along either.
void end_product(arf_ptr r, arf_srcptr x, arf_srcptr y, arf_rnd_t rounding) {
    if (arf_is_zero(x) != 0 || arf_is_zero(y) != 0) {
        arf_zero(r);
    } else {
        arf_mul(r, x, y, Interval::bits, rounding);
    }
}

Interval between(long lo, long hi) { return {Ball(lo, Interval::bits), Ball(hi, Interval::bits)}; }
Interval from_on(long lo) {
    Ball end(0, Interval::bits);
    arb_pos_inf(end.data());
    return {Ball(lo, Interval::bits), end};
}
Interval one() { return between(1, 1); }

} // namespace

Interval::Interval(const Ball& from, const Ball& to) {
    lower_end(lo_, from);
    upper_end(hi_, to);
}

Interval Interval::everything() {
    Ball unknown(0, bits);
    arb_indeterminate(unknown.data());
    return Interval(unknown);
}

Ball Interval::at(arf_srcptr x) {
    Ball r(0, bits);
    arb_set_arf(r.data(), x);
    return r;
}

Interval operator-(const Interval& x) {
    Interval r;
    arf_neg(r.lo_, x.hi_);
    arf_neg(r.hi_, x.lo_);
    return r;
}

// If a sum of ends is inf - inf, by overflow, nothing is known.
Interval operator+(const Interval& x, const Interval& y) {
    Interval r;
    arf_add(r.lo_, x.lo_, y.lo_, Interval::bits, ARF_RND_FLOOR);
    arf_add(r.hi_, x.hi_, y.hi_, Interval::bits, ARF_RND_CEIL);
    return arf_is_nan(r.lo_) != 0 || arf_is_nan(r.hi_) != 0 ? Interval::everything() : r;
}

Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

// The rules of interval arithmetic (moore-kearfott-cloud2009).
Interval operator*(const Interval& x, const Interval& y) {
    Interval r;
    ArfValue p;
    bool first = true;
    for (const ArfValue* of_x : {&x.lo_, &x.hi_}) {
        for (const ArfValue* of_y : {&y.lo_, &y.hi_}) {
            end_product(p, *of_x, *of_y, ARF_RND_FLOOR);
            if (first || arf_cmp(p, r.lo_) < 0) {
                arf_set(r.lo_, p);
            }
            end_product(p, *of_x, *of_y, ARF_RND_CEIL);
            if (first || arf_cmp(p, r.hi_) > 0) {
                arf_set(r.hi_, p);
            }
            first = false;
        }
    }
    return r;
}

Interval operator/(const Interval& x, const Interval& y) {
    const int lo = arf_sgn(y.lo_);
    const int hi = arf_sgn(y.hi_);
    if (lo > 0 || hi < 0 || (lo == 0) != (hi == 0)) {
        Interval inverse = Interval::everything();
        if (hi != 0) {
            arf_ui_div(inverse.lo_, 1, y.hi_, Interval::bits, ARF_RND_FLOOR);
        }
        if (lo != 0) {
            arf_ui_div(inverse.hi_, 1, y.lo_, Interval::bits, ARF_RND_CEIL);
        }
        return x * inverse;
    }
    return Interval::everything();
}

Interval abs(const Interval& x) {
    if (x.nowhere_negative()) {
        return x;
    }
    const Interval mirrored = -x;
    if (mirrored.nowhere_negative()) {
        return mirrored;
    }
    Interval r;
    r.hi_ = arf_cmp(x.hi_, mirrored.hi_) < 0 ? mirrored.hi_ : x.hi_;
    return r;
}

Interval clipped(const Interval& x, const Interval& y) {
    Interval r(x);
    for (ArfValue* end : {&r.lo_, &r.hi_}) {
        if (arf_cmp(*end, y.lo_) < 0) {
            *end = y.lo_;
        } else if (arf_cmp(*end, y.hi_) > 0) {
            *end = y.hi_;
        }
    }
    return r;
}

namespace {

using OfBall = Ball (*)(const Ball&);

Interval rise(const Interval& x, OfBall f) { return rising(x, f); }
Interval fall(const Interval& x, OfBall f) { return falling(x, f); }
/// A function that is not monotone, by the ball that contains x.
Interval wave(const Interval& x, OfBall f) {
    const Ball lo = x.lower();
    const Ball hi = x.upper();
    return lo.is_finite() && hi.is_finite() ? Interval(f(Ball::hull(lo, hi)))
                                            : Interval::everything();
}

} // namespace

Interval sqrt(const Interval& x) { return rise(clipped(x, from_on(0)), sqrt); }
Interval exp(const Interval& x) { return clipped(rise(x, exp), from_on(0)); }
Interval log(const Interval& x) { return rise(clipped(x, from_on(0)), log); }
Interval sin(const Interval& x) { return clipped(wave(x, sin), between(-1, 1)); }
Interval cos(const Interval& x) { return clipped(wave(x, cos), between(-1, 1)); }
Interval tan(const Interval& x) {
    // If tan is finite over the whole ball, the ball contains no pole; tan increases between poles.
    const Interval whole = wave(x, tan);
    return whole.is_finite() ? rise(x, tan) : whole;
}
Interval asin(const Interval& x) { return rise(clipped(x, between(-1, 1)), asin); }
Interval acos(const Interval& x) { return fall(clipped(x, between(-1, 1)), acos); }
Interval atan(const Interval& x) { return rise(x, atan); }
Interval sinh(const Interval& x) { return rise(x, sinh); }
Interval cosh(const Interval& x) { return clipped(rise(abs(x), cosh), from_on(1)); }
Interval tanh(const Interval& x) { return rise(x, tanh); }
Interval asinh(const Interval& x) { return rise(x, asinh); }
Interval acosh(const Interval& x) { return rise(clipped(x, from_on(1)), acosh); }
Interval atanh(const Interval& x) { return rise(clipped(x, between(-1, 1)), atanh); }

Interval pow_int(const Interval& x, long n) {
    if (n < 0) {
        return one() / pow_int(x, -n);
    }
    const auto f = [n](const Ball& end) { return pow_int(end, n); };
    return n == 0 ? one() : n % 2 == 0 ? rising(abs(x), f) : rising(x, f);
}

Interval pow(const Interval& x, const Rational& q) {
    if (denominator(q) == 1 && abs(q) < 10000) {
        return pow_int(x, q.convert_to<long>());
    }
    if (q < 0) {
        return one() / pow(x, Rational(-q));
    }
    return rising(clipped(x, from_on(0)), [&q](const Ball& end) {
        return contains_zero(end) ? Ball(0, Interval::bits) : pow(end, q);
    });
}

Interval pow(const Interval& x, const Interval& y) { return exp(y * log(x)); }

} // namespace edgeproof

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"

namespace edgeproof {

/// The real numbers between two ends, which may be infinite (moore-kearfott-cloud2009). Unlike a
/// ball an interval can end at exactly 0: the square of [0, h] is nowhere negative. Every operation
/// contains the exact result for every choice of operands for which it is defined (sqrt of [-1, 4]
/// is [0, 2]); it does not report whether it is defined everywhere.
class Interval {
public:
    /// Bits to which the ends are rounded, outwards.
    static constexpr long bits = 128;

    /// [0, 0].
    Interval() : Interval(Ball(0, bits)) {}
    /// All of the ball; everything if the ball is not finite.
    explicit Interval(const Ball& x) : Interval(x, x) {}
    /// The interval between the lower end of one ball and the upper end of another.
    Interval(const Ball& from, const Ball& to);
    [[nodiscard]] static Interval everything();

    [[nodiscard]] bool nowhere_negative() const { return arf_sgn(lo_) >= 0; }
    [[nodiscard]] bool negative() const { return arf_sgn(hi_) < 0; }
    /// True if both ends are finite.
    [[nodiscard]] bool is_finite() const {
        return arf_is_finite(lo_) != 0 && arf_is_finite(hi_) != 0;
    }
    /// The ends, exactly; not finite if an end is infinite.
    [[nodiscard]] Ball lower() const { return at(lo_); }
    [[nodiscard]] Ball upper() const { return at(hi_); }

    friend Interval operator-(const Interval& x);
    friend Interval operator+(const Interval& x, const Interval& y);
    friend Interval operator-(const Interval& x, const Interval& y);
    friend Interval operator*(const Interval& x, const Interval& y);
    friend Interval operator/(const Interval& x, const Interval& y);

    friend Interval abs(const Interval& x);
    /// The intersection; if that is empty, the number of y nearest to x.
    friend Interval clipped(const Interval& x, const Interval& y);
    /// The range of a function that increases, or decreases, where it is defined.
    template <class F> friend Interval rising(const Interval& x, F f) {
        return {f(x.lower()), f(x.upper())};
    }
    template <class F> friend Interval falling(const Interval& x, F f) {
        return {f(x.upper()), f(x.lower())};
    }

private:
    [[nodiscard]] static Ball at(arf_srcptr x);
    ArfValue lo_;
    ArfValue hi_;
};

[[nodiscard]] Interval sqrt(const Interval& x);
[[nodiscard]] Interval exp(const Interval& x);
[[nodiscard]] Interval log(const Interval& x);
[[nodiscard]] Interval sin(const Interval& x);
[[nodiscard]] Interval cos(const Interval& x);
[[nodiscard]] Interval tan(const Interval& x);
[[nodiscard]] Interval asin(const Interval& x);
[[nodiscard]] Interval acos(const Interval& x);
[[nodiscard]] Interval atan(const Interval& x);
[[nodiscard]] Interval sinh(const Interval& x);
[[nodiscard]] Interval cosh(const Interval& x);
[[nodiscard]] Interval tanh(const Interval& x);
[[nodiscard]] Interval asinh(const Interval& x);
[[nodiscard]] Interval acosh(const Interval& x);
[[nodiscard]] Interval atanh(const Interval& x);
[[nodiscard]] Interval pow_int(const Interval& x, long n);
/// For x >= 0 if q is not an integer.
[[nodiscard]] Interval pow(const Interval& x, const Rational& q);
[[nodiscard]] Interval pow(const Interval& x, const Interval& y);

} // namespace edgeproof

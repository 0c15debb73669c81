// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/rational.hpp"

namespace edgeproof {

/// The real numbers from one end to another, either of which may be infinite. Unlike a ball about
/// a middle it ends at exactly 0 where its numbers do: [0, h] squared is not below 0 anywhere.
/// Every operation holds the exact result of every choice of operands from their intervals for
/// which it is defined (sqrt of [-1, 4] is [0, 2]): it says nothing about whether it is defined.
class Interval {
public:
    /// Of the ends, when they are rounded outwards.
    static constexpr long bits = 128;

    /// [0, 0].
    Interval() : Interval(Ball(0, bits)) {}
    /// All of the ball; everything where that is not finite.
    explicit Interval(const Ball& x) : Interval(x, x) {}
    /// From all of one ball to all of another.
    Interval(const Ball& from, const Ball& to);
    [[nodiscard]] static Interval everything();

    [[nodiscard]] bool nowhere_negative() const { return arf_sgn(lo_) >= 0; }
    [[nodiscard]] bool negative() const { return arf_sgn(hi_) < 0; }
    /// Both ends are.
    [[nodiscard]] bool is_finite() const {
        return arf_is_finite(lo_) != 0 && arf_is_finite(hi_) != 0;
    }
    /// The ends, exactly; not finite where an end is infinite.
    [[nodiscard]] Ball lower() const { return at(lo_); }
    [[nodiscard]] Ball upper() const { return at(hi_); }

    friend Interval operator-(const Interval& x);
    friend Interval operator+(const Interval& x, const Interval& y);
    friend Interval operator-(const Interval& x, const Interval& y);
    friend Interval operator*(const Interval& x, const Interval& y);
    friend Interval operator/(const Interval& x, const Interval& y);

    friend Interval abs(const Interval& x);
    /// What both have in common; y's nearest number where that is nothing.
    friend Interval clipped(const Interval& x, const Interval& y);
    /// Of a function that rises, or falls, wherever it is defined.
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
/// Of x >= 0 where q is no integer.
[[nodiscard]] Interval pow(const Interval& x, const Rational& q);
[[nodiscard]] Interval pow(const Interval& x, const Interval& y);

} // namespace edgeproof

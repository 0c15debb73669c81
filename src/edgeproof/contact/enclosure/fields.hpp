// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/algebra/form.hpp"
#include "edgeproof/contact/law/field.hpp"
#include "edgeproof/contact/law/kernels.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/ball_series.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstddef>
#include <utility>

/// Balls, series of balls, exact constants and symbols as fields for the formulas of contact/law/.
namespace edgeproof::contact {

using algebra::Form;

template <> struct Field<Ball> {
    static Ball number(int k, const Ball& like) { return {static_cast<long>(k), like.bits()}; }
    static Ball pi(const Ball& like) { return Ball::pi(like.bits()); }
    static Ball over(Ball x, int k) { return std::move(x /= k); }
    static bool vanishes(const Ball& x) { return x.is_exact() && contains_zero(x); }
    static Ball times(const Ball& weight, const Ball& x) { return weight * x; }
    static void add_product(Ball& sum, const Ball& x, const Ball& y) {
        arb_addmul(sum.data(), x.data(), y.data(), sum.bits());
    }
    static Ball twice(Ball x) {
        arb_mul_2exp_si(x.data(), x.data(), 1);
        return x;
    }
    static Ball smaller(const Ball& x, const Ball& y) { return min(x, y); }
    /// The square root of the non-negative part of x.
    static Ball root(const Ball& x) {
        Ball r(0, x.bits());
        arb_sqrtpos(r.data(), x.data(), x.bits());
        return r;
    }
    /// The angle h of docs/mechanics.md, 2 atan sqrt(near/far), without the quotient.
    static Ball angle(const Ball& near, const Ball& far) {
        return atan2(root(near), root(far)) * 2;
    }
    /// pi - h as a difference: the cancellation costs bits, and the caller uses more bits.
    template <class Mark> static Ball other_angle(const Mark& m) { return pi(m.h) - m.h; }
};

template <> struct Field<BallSeries> {
    static BallSeries number(int k, const BallSeries& like) {
        return {Ball(static_cast<long>(k), like.bits()), like.order()};
    }
    static BallSeries pi(const BallSeries& like) { return {Ball::pi(like.bits()), like.order()}; }
    static BallSeries over(const BallSeries& x, int k) {
        return x * Ball(Rational(1, k), x.bits());
    }
    static bool vanishes(const BallSeries& x) {
        for (std::size_t k = 0; k < x.order(); ++k) {
            if (!Field<Ball>::vanishes(x[k])) {
                return false;
            }
        }
        return true;
    }
    template <class W> static BallSeries times(const W& weight, const BallSeries& x) {
        return x * weight;
    }
    static void add_product(BallSeries& sum, const Ball& x, const BallSeries& y) {
        sum = sum + y * x;
    }
    static BallSeries root(const BallSeries& x) { return sqrt(x); }
    /// 2 atan sqrt(near/far). Not finite for a knot that may lie on an edge.
    static BallSeries angle(const BallSeries& near, const BallSeries& far) {
        return atan(sqrt(near / far)) * Ball(2, near.bits());
    }
    template <class Mark> static BallSeries other_angle(const Mark& m) {
        return -m.h + Ball::pi(m.h.bits());
    }
    static BallSeries inverse_root(const BallSeries& x) {
        return pow(x, Ball(Rational(-1, 2), x.bits()));
    }
    static BallSeries resized(const BallSeries& x, std::size_t order) { return x.resized(order); }
    static void set_constant(BallSeries& x, const Ball& c) { x.set(0, c); }
};

/// Thrown where a value has no exact form.
struct NoExactForm : DomainError {
    NoExactForm() : DomainError("the value has no exact form") {}
};

template <> struct Field<Form> {
    using X = Form;
    static X number(int k, const X&) { return {k}; }
    static X pi(const X&) { return X::pi(); }
    static X over(const X& x, int k) { return x / k; }
    static bool vanishes(const X& x) { return x.is_zero(); }
    static X times(const X& weight, const X& x) { return weight * x; }
    static X root(const X& x) { return sqrt(x); }
    /// The angle h by its cosine.
    static X angle(const X& near, const X& far) { return acos((far - near) / (far + near)); }
    template <class Mark> static X other_angle(const Mark& m) { return X::pi() - m.h; }
};

/// The mark of v, limited to the contact: a distance from an edge that may be negative is replaced
/// by the interval from 0 to its upper end, so that a ball of b that contains a knot needs no
/// special case.
[[nodiscard]] Mark<Ball> clamped_mark(const Extent<Ball>& e, const Ball& v);

/// max(x, 0) as a ball.
[[nodiscard]] Ball clamped(const Ball& x);

/// G(x, v) = ln((sqrt p + sqrt q)^2/(D |v - x|)), p = right_v left_x, q = right_x left_v
/// (docs/pressure.md, "Closed form: piecewise linear slopes"), and (v - x) G. The latter is also
/// enclosed if the ball of v - x contains zero, and is 0 if v = x. `right_x`, `left_x`: distances
/// of x from the edges; w_x = sqrt(right_x left_x); D = a + b; `offset` = v - x; all are lengths.
struct BallGreen {
    Ball value;
    Ball moment;
    Ball least; ///< a lower bound of G over the balls, finite even if the value is not
};
[[nodiscard]] BallGreen ball_green(const Mark<Ball>& v, const Ball& right_x, const Ball& left_x,
                                   const Ball& w_x, const Ball& D, const Ball& offset);
/// Encloses (v - x) G where the ball of v - x contains zero, from p, q, D and the offset v - x. Not
/// finite if the ball is too wide.
[[nodiscard]] Ball moment_across(const Ball& p, const Ball& q, const Ball& D, const Ball& offset);

} // namespace edgeproof::contact

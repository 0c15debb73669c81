// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_marks.hpp"

namespace edgeproof::contact {

Ball clamped(const Ball& x) {
    if (certainly_positive(x)) {
        return x;
    }
    if (certainly_negative(x) || !x.is_finite()) {
        return {0, x.bits()};
    }
    return Ball::from_interval(Real(0), x.upper(), x.bits());
}

Ball root(const Ball& x) {
    Ball r(0, x.bits());
    arb_sqrtpos(r.data(), x.data(), x.bits());
    return r;
}

BallMark BallMark::at(const Ball& a, const Ball& b, const Ball& v) {
    if (certainly_negative(a - v)) {
        return right_end(a, b);
    }
    if (certainly_negative(v + b)) {
        return left_end(a, b);
    }
    BallMark m;
    m.right = clamped(a - v);
    m.left = clamped(v + b);
    m.y = (m.left - m.right) / 2;
    m.w = root(m.right * m.left);
    m.h = atan2(root(m.right), root(m.left)) * 2;
    return m;
}

BallMark BallMark::right_end(const Ball& a, const Ball& b) {
    const Ball zero(0, a.bits());
    return {zero, a + b, (a + b) / 2, zero, zero, true};
}

BallMark BallMark::left_end(const Ball& a, const Ball& b) {
    const Ball zero(0, a.bits());
    return {a + b, zero, -((a + b) / 2), zero, Ball::pi(a.bits()), true};
}

BallGreen ball_green(const BallMark& v, const Ball& right_x, const Ball& left_x, const Ball& D,
                     const Ball& offset) {
    return ball_green(v, right_x, left_x, root(right_x * left_x), D, offset);
}

BallGreen ball_green(const BallMark& v, const Ball& right_x, const Ball& left_x, const Ball& w_x,
                     const Ball& D, const Ball& offset) {
    BallGreen g;
    if (offset.is_exact() && contains_zero(offset)) {
        g.value = Ball(0, offset.bits());
        arb_pos_inf(g.value.data());
        g.moment = Ball(0, offset.bits());
        g.least = g.moment;
        return g;
    }
    // p - q = -D offset, so that the argument is 1 + (2 min + 2 sqrt(pq))/gap: near an edge it is
    // near 1 and the logarithm keeps its relative digits.
    const Ball gap = D * abs(offset);
    Ball beyond = v.w * w_x;
    if (certainly_positive(offset)) {
        arb_addmul(beyond.data(), v.right.data(), left_x.data(), beyond.bits());
    } else if (certainly_negative(offset)) {
        arb_addmul(beyond.data(), right_x.data(), v.left.data(), beyond.bits());
    } else {
        beyond += min(v.right * left_x, right_x * v.left);
    }
    arb_mul_2exp_si(beyond.data(), beyond.data(), 1);
    g.value = log1p(beyond / gap);
    if (!contains_zero(offset)) {
        g.moment = offset * g.value;
        g.least = g.value;
        return g;
    }
    g.least = log1p(clamped(beyond) / Ball(gap.upper(), offset.bits()));
    // |t ln(C/t)| grows with t up to C/e: over |offset| <= t it is at most t ln(C/t).
    const Ball sum = root(v.right * left_x) + root(right_x * v.left);
    const Ball C(Ball(sum * sum / D).upper(), offset.bits());
    const Ball t(abs(offset).upper(), offset.bits());
    const Ball largest = t * log(C / t);
    g.moment = largest;
    if (certainly_less(t * 3, C) && largest.is_finite()) {
        g.moment = Ball::around(Real(0), largest.upper(), offset.bits());
    } else {
        arb_indeterminate(g.moment.data());
    }
    return g;
}

} // namespace edgeproof::contact

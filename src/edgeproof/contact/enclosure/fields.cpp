// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/fields.hpp"

#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/law/linear_measure.hpp"

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

Mark<Ball> clamped_mark(const Extent<Ball>& e, const Ball& v) {
    const Ball right = e.a - v;
    const Ball left = v + e.b;
    return certainly_negative(right)  ? right_end(e)
           : certainly_negative(left) ? left_end(e)
                                      : mark_between(clamped(right), clamped(left));
}

// |t ln(C/t)| grows with t up to t = C/e: for |offset| <= t the moment is at most t ln(C/t).
Ball moment_across(const Ball& p, const Ball& q, const Ball& D, const Ball& offset) {
    const Ball sum = Field<Ball>::root(p) + Field<Ball>::root(q);
    const Ball C = upper_end(sum * sum / D).with_bits(offset.bits());
    const Ball t = upper_end(abs(offset));
    const Ball largest = t * log(C / t);
    return certainly_less(t * 3, C) && largest.is_finite() ? up_to(largest)
                                                           : unknown_ball(offset.bits());
}

BallGreen ball_green(const Mark<Ball>& v, const Ball& right_x, const Ball& left_x, const Ball& w_x,
                     const Ball& D, const Ball& offset) {
    BallGreen g;
    if (offset.is_exact() && contains_zero(offset)) {
        g.value = Ball(0, offset.bits());
        arb_pos_inf(g.value.data());
        g.moment = Ball(0, offset.bits());
        g.least = g.moment;
        return g;
    }
    const Ball gap = D * abs(offset);
    const int side = certainly_positive(offset) ? 1 : certainly_negative(offset) ? -1 : 0;
    // docs/pressure.md, "Closed form: piecewise linear slopes"
    const Ball beyond = green_excess(v, right_x, left_x, w_x, side);
    g.value = log1p(beyond / gap);
    if (!contains_zero(offset)) {
        g.moment = offset * g.value;
        g.least = g.value;
        return g;
    }
    g.least = log1p(clamped(beyond) / Ball(gap.upper(), offset.bits()));
    g.moment = moment_across(v.right * left_x, right_x * v.left, D, offset);
    return g;
}

} // namespace edgeproof::contact

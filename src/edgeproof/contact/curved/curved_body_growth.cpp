// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals over the contacts of growing size: the gap of a curved body of revolution, and
// energies.
#include "edgeproof/contact/curved/curved_body.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"

namespace edgeproof::contact {

// With w = sqrt(s^2 - A^2) = D cos(psi) between two knots, D^2 = to^2 - A^2, both roots are
// analytic.
Ball CurvedBody::over_approach(const Ball& from, std::optional<std::size_t> on, const Ball& beyond,
                               const std::function<Box(const Radius& at, const Box& depth)>& f,
                               const Ball& scale) const {
    const Ball to = from + beyond;
    const Ball quarter = Ball::pi(bits_) / 2;
    const IntegralGoal goal{bits_, useful_accuracy(beyond.relative_accuracy_bits(), bits_), scale,
                            Ball(1, bits_)};
    Ball sum(0, bits_);
    Ball A = from;
    Ball left = beyond; // to - A
    for (std::size_t i = on ? *on + 1 : 0;; ++i) {
        const bool last = i == rings_.size() || !certainly_less(rings_[i].v, to);
        if (!last && !certainly_less(A, rings_[i].v)) {
            if (certainly_less(rings_[i].v, A)) {
                continue;
            }
            return unknown_ball(bits_);
        }
        const Ball D = Field<Ball>::root(left * (to + A));
        const Ball first = last ? Ball(0, bits_)
                                : atan2(sqrt((to - rings_[i].v) * (to + rings_[i].v)),
                                        sqrt((rings_[i].v - A) * (rings_[i].v + A)));
        const Ball width = quarter - first;
        sum += width * integral_of(
                           [&](const Box& t) {
                               const Box psi = t * width + first;
                               const Box w = cos(psi) * D;
                               const Box depth = cos(Box(quarter) - psi) * D;
                               const Radius at = radius(A, on, w);
                               Box rate = approach_rate(at, on) * w;
                               if (on) {
                                   rate = rate + Box(rings_[*on].jump * rings_[*on].v);
                               }
                               return f(at, depth) * rate * depth / at.s;
                           },
                           goal);
        if (last) {
            return sum;
        }
        A = rings_[i].v;
        left = to - A;
        on = i;
    }
}

// docs/axisymmetric.md, "The gap"
Ball CurvedBody::gap_beyond(const Ball& beyond) const {
    const Ball r = a_ + beyond;
    std::optional<std::size_t> on;
    Ball rest(0, bits_); // of rings that r may lie on
    for (std::size_t i = 1; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        if (on_edge_[rings_[i].knot]) {
            on = i;
        } else if (overlaps(v, r)) {
            // At most the greatest arccos times the part of the ring in h(r).
            const Box near(Ball::hull(v, r));
            const Ball bend = abs(value(i, near, Integrand::slope).real() -
                                  value(i - 1, near, Integrand::slope).real());
            const Ball A = atan2(Field<Ball>::root(clamped(r - v) * (r + v)), v);
            rest += up_to(upper_end(r * A * A * bend));
        }
    }
    const auto arc = [&](const Radius& /*at*/, const Box& depth) {
        Box x = depth / r;
        if (!certainly_less(abs(x), Ball(1, bits_))) {
            return unknown_box(bits_); // near a cut
        }
        acb_asin(x.get(), x.get(), bits_);
        return x;
    };
    return (over_approach(a_, on, beyond, arc, Ball(0, bits_)) + rest) * 2 / Ball::pi(bits_);
}

// docs/axisymmetric.md, "The energy of a cycle"
Ball CurvedBody::loop_integral(const Ball& from, const Ball& tau) const {
    const Ball P = force();
    const Ball mean = P * (1 - tau / 2);
    const auto loop = [&](const Radius& at, const Box& /*depth*/) {
        return Box(mean) - over_rings(at, Integrand::moment, bits_) * (modulus_ * 2);
    };
    return over_approach(from, {}, a_ - from, loop, P * tau * (approach() - approach_at(from)));
}

// Between two knots L is analytic in w = sqrt(s^2 - v^2), where v is the knot before
// (docs/histories.md, "The energy"); ds/s = w dw/s^2.
Ball CurvedBody::over_plane_widths(const Ball& from, const Ball& to,
                                   const std::function<Box(const Box& L)>& f) const {
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        const bool last = i + 1 == rings_.size();
        if (certainly_less(to, v) || (!last && certainly_less(rings_[i + 1].v, from))) {
            continue;
        }
        const Ball begin = max(from, v);
        const Ball end = last ? to : min(to, rings_[i + 1].v);
        const Ball first = Field<Ball>::root(clamped(begin - v) * (begin + v));
        const Ball final = Field<Ball>::root(clamped(end - v) * (end + v));
        const Ball both = first + final; // it may be 0 where an edge is on the knot
        const Ball width = certainly_positive(both) ? (end - begin) * (end + begin) / both : both;
        const IntegralGoal goal{bits_, useful_accuracy(width.relative_accuracy_bits(), bits_),
                                Ball(0, bits_), Ball(1, bits_)};
        sum += width * integral_of(
                           [&](const Box& t) {
                               const Box w = t * width + first;
                               const Radius at = radius(v, i, w);
                               const Box L = over_rings(at, Integrand::first_moment, bits_);
                               return f(L * modulus_) * w / (at.s * at.s);
                           },
                           goal);
    }
    return sum;
}

} // namespace edgeproof::contact

// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals over the approach: the gap outside the contact, and the energy of a cycle.
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"
#include "edgeproof/contact/enclosure/rigorous_integral.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace edgeproof::contact {

namespace {

/// The part of a bend at v in the gap at r: the integral of h'(s) arccos(s/r) over s0 < s < r,
/// s = v + (r - v) cos^2(psi), psi = t psi_0 (docs/axisymmetric.md, "The gap").
/// @param beyond r - s0 (length)
/// @param before s0 - v, 0 or more (length)
/// @param rate h'(s) cos(psi) for s, cos(psi)
Ball gap_integral(const Ball& v, const Ball& r, const Ball& beyond, const Ball& before,
                  const std::function<Box(const Box& s, const Box& cosine)>& rate) {
    const long bits = r.bits();
    const Ball span = r - v;
    const Ball angle = atan2(sqrt(beyond), Field<Ball>::root(before)); // psi_0
    const Ball ratio = sqrt(span / (r * 2));
    const IntegralGoal goal{bits, useful_accuracy(beyond.relative_accuracy_bits(), bits),
                            Ball(0, bits), Ball(1, bits)};
    return integral_of(
               [&](const Box& t) {
                   Box sine(bits);
                   Box cosine(bits);
                   acb_sin_cos(sine.get(), cosine.get(), (t * angle).get(), bits);
                   Box arc = sine * ratio;
                   if (!certainly_less(abs(arc), Ball(1, bits))) {
                       return unknown_box(bits); // near a cut
                   }
                   acb_asin(arc.get(), arc.get(), bits);
                   const Box s = cosine * cosine * span + v;
                   return sine * arc * rate(s, cosine);
               },
               goal) *
           angle * span * 8 / Ball::pi(bits);
}

} // namespace

Ball axisymmetric_gap(const BallContact& plane, const Ball& beyond) {
    const long bits = plane.bits();
    const Ball& a = plane.a();
    const Ball rate = plane.force_rate() / plane.modulus(); // h'(a)
    const std::optional<PowerLaw<Ball>>& power = plane.power_law();
    const Box exponent(power ? power->exponent : Ball(plane.slope().has_corner(0) ? 0 : 1, bits));
    return gap_integral(Ball(0, bits), a + beyond, beyond, a, [&](const Box& s, const Box& cosine) {
        if (!certainly_positive(s.real())) {
            return unknown_box(bits); // near a cut
        }
        Box grown(bits);
        acb_pow(grown.get(), (s / a).get(), exponent.get(), bits);
        return grown * rate * cosine;
    });
}

// With s = a exp(-x) the power is an exponential. Beyond x = X the integrand is bounded by its
// values in the box of the remaining s.
Ball over_approach(const BallContact& plane, const std::function<Box(const Box& s)>& f) {
    const long bits = plane.bits();
    const std::optional<PowerLaw<Ball>>& law = plane.power_law();
    const Ball power =
        law ? law->exponent + 1 : Ball(plane.slope().has_corner(0) ? 1 : 2, bits); // m + 1
    const Ball& a = plane.a();
    const Ball scale = plane.force_rate() / plane.modulus() * a; // a h'(a)
    const Ball X = middle(log(Ball(2, bits)) * (bits + 16) / power);
    const auto place = [&](const Box& x) {
        Box s(bits);
        acb_exp(s.get(), (-x).get(), bits);
        return s * a;
    };
    const Ball whole = X * integral_of(
                               [&](const Box& t) {
                                   const Box x = t * X;
                                   Box weight(bits);
                                   acb_exp(weight.get(), (x * -power).get(), bits);
                                   return f(place(x)) * weight;
                               },
                               {bits, bits, Ball(0, bits), Ball(1, bits)});
    const Ball rest = place(Box(X)).real();
    const Ball end = upper_end(exp(-power * X)) / power;
    return scale * (whole + up_to(end * upper_end(abs(f(Box(Ball::hull(Ball(0, bits), rest)))))));
}

// With w = sqrt(s^2 - A^2) = D cos(psi) between two knots, D^2 = to^2 - A^2, both roots are
// analytic.
Ball AxisymmetricContact::over_approach(
    const Ball& from, std::optional<std::size_t> on, const Ball& beyond,
    const std::function<Box(const Radius& at, const Box& depth)>& f, const Ball& scale,
    long known) const {
    const Ball to = from + beyond;
    const Ball quarter = Ball::pi(bits_) / 2;
    const IntegralGoal goal{
        bits_, useful_accuracy(std::min(known, beyond.relative_accuracy_bits()), bits_), scale,
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
        if (!on && i == 0) { // a flat: h' is 0 before the first ring
            if (last) {
                return sum;
            }
            A = rings_[i].v;
            left = to - A;
            on = i;
            continue;
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
                               Box rate = approach_rate(at, on); // ds/dw
                               if (!on || !on_axis(*on)) {
                                   rate = rate * w;
                                   rate =
                                       (on ? rate + rings_[*on].jump * rings_[*on].v : rate) / at.s;
                               }
                               return f(at, depth) * rate * depth;
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

// Of a linear slope ring by ring, since one arctangent at a time is faster than a sum of all, with
// s^2 = v^2 + y^2 and ds = y dy/s.
Ball AxisymmetricContact::over_approach(const std::function<Box(const Box& s, const Box& s2)>& f,
                                        const std::function<Ball(long power)>& of_power,
                                        long known) const {
    if (!linear_) {
        return over_approach(
            Ball(0, bits_), on_axis(0) ? std::optional<std::size_t>(0) : std::nullopt, a_,
            [&](const Radius& at, const Box& /*depth*/) { return f(at.s, at.s * at.s); },
            Ball(0, bits_), known);
    }
    Ball sum(0, bits_);
    for (std::size_t i = 0; i < rings_.size() && (on_axis(i) || inside(rings_[i].knot)); ++i) {
        const Ball& v = rings_[i].v;
        const Ball& jump = rings_[i].jump;
        const Ball& rate = rings_[i].rate;
        const Ball quarter = Ball::pi(bits_) / 2;
        if (on_axis(i) && of_power) {
            sum += of_power(1) * rate * 2;
            sum += contains_zero(jump) ? Ball(0, bits_) : of_power(0) * jump * quarter;
            continue;
        }
        const Ball Y = on_axis(i) ? a_ : Field<Ball>::root(clamped(a_ - v) * (a_ + v));
        const long accuracy = useful_accuracy(std::min(known, Y.relative_accuracy_bits()), bits_);
        const auto integrand = [&](const Box& t) {
            const Box y = t * Y;
            const Box y2 = y * y;
            if (on_axis(i)) {
                return f(y, y2) * (y * (rate * 2) + jump * quarter);
            }
            const Box s2 = y2 + v * v;
            const Box s = principal_root(s2);
            const Box A = principal_arctangent(y / v);
            const Box slope = (A * y + v) * jump + (y * Ball(2, bits_) - A * v) * y * rate;
            return f(s, s2) * slope / s;
        };
        sum += Y * integral_of(integrand, {std::min(bits_, accuracy + 64), accuracy, Ball(0, bits_),
                                           Ball(1, bits_)});
    }
    return sum;
}

// docs/axisymmetric.md, "The gap"
Ball AxisymmetricContact::gap_beyond(const Ball& beyond) const {
    const Ball r = a_ + beyond;
    std::optional<std::size_t> on;
    Ball rest(0, bits_); // of rings that r may lie on
    for (std::size_t i = 0; i < rings_.size(); ++i) {
        const Ball& v = rings_[i].v;
        if (on_edge_[rings_[i].knot]) {
            on = i;
        } else if (!on_axis(i) && overlaps(v, r)) {
            // At most the greatest arccos times the part of the ring in h(r).
            const Box near(Ball::hull(v, r));
            const std::size_t knot = rings_[i].knot;
            const Ball bend = abs(value(knot, near, Integrand::slope).real() -
                                  value(knot - 1, near, Integrand::slope).real());
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
Ball AxisymmetricContact::loop_integral(const Ball& from, const Ball& tau) const {
    const Ball P = force();
    const Ball mean = P * (1 - tau / 2);
    const auto loop = [&](const Radius& at, const Box& /*depth*/) {
        return Box(mean) - over_rings(at, Integrand::moment) * (modulus_ * 2);
    };
    return over_approach(from, {}, a_ - from, loop, P * tau * (approach() - approach_at(from)));
}

// Between two knots L is analytic in w = sqrt(s^2 - v^2), where v is the knot before
// (docs/histories.md, "The energy"); ds/s = w dw/s^2.
Ball AxisymmetricContact::over_plane_widths(const Ball& from, const Ball& to,
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
                               const Box L = over_rings(at, Integrand::first_moment);
                               return f(L * modulus_) * w / (at.s * at.s);
                           },
                           goal);
    }
    return sum;
}

} // namespace edgeproof::contact

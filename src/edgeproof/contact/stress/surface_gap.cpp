// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/stress/cauchy_integral.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"

#include <cstddef>

namespace edgeproof::contact {

namespace {

Ball positive_part(const Ball& x) { return max(x, Ball(0, x.bits())); }

/// The integral of g'(y) - g'(a) over y from the right edge a to a place, which is `outwards`
/// beyond it, or `inwards` before it; the other one is 0. Each bend of the slope on the way
/// contributes its jump times the distance from it, and its change of g'' times half the square.
Ball rise_of_profile(const BallContact& contact, const Ball& inwards, const Ball& outwards) {
    const LinearSlope<Ball>& slope = contact.slope();
    std::size_t at_edge = 0; // the first knot beyond the edge
    while (at_edge < slope.knots.size() && contact.knot_marks()[at_edge].end != Edge::right) {
        ++at_edge;
    }
    Ball sum = slope.rate(at_edge) * (inwards * inwards + outwards * outwards) / 2;
    for (std::size_t i = 0; i < slope.knots.size(); ++i) {
        const Ball outside = slope.knots[i] - contact.a();
        if (i < at_edge && !certainly_negative(outside)) {
            // It counts as inside; if it is beyond, the error is at most that of its distance.
            sum += up_to(abs(outside) * (abs(slope.jump(i)) + abs(slope.rate_drop(i)) * outwards));
        }
        const Ball passed = i < at_edge ? positive_part(inwards - positive_part(-outside))
                                        : positive_part(outwards - positive_part(outside));
        const Ball change = slope.rate_drop(i) * passed * passed / 2;
        sum += slope.jump(i) * passed + (i < at_edge ? change : -change);
    }
    return sum;
}

// docs/stress.md, "The gap": the integral of h' = g' - (2/(pi E*)) P_1 from the edge, with g'(a) by
// the consistency condition.
Ball linear_gap(const BallContact& contact, const Ball& beyond) {
    const LinearSlope<Ball>& slope = contact.slope();
    const Extent<Ball> e{contact.a(), contact.b()};
    const Ball pi = Ball::pi(beyond.bits());
    const Ball half = e.length() / 2;
    const Ball W = sqrt(beyond * (e.length() + beyond));
    const Ball omega = half / (half + beyond + W);
    const Ball log_omega = log1p((beyond + W) / half); // -ln omega
    Ball lost = (log_omega * 2 + omega * omega - 1) * contact.arc() * half * half / 4;
    for (const std::size_t i : contact.bends_inside()) {
        const Mark<Ball>& v = contact.knot_marks()[i];
        const Ball far = beyond + v.right; // x - v
        const Ball k = atan2(omega * v.w / half, 1 - omega * v.y / half) * 2;
        const Ball k_edge = pi - v.h;
        if (slope.has_corner(i)) {
            lost += (far * k - v.right * k_edge + log_omega * v.w) * slope.jump(i);
        }
        lost -= (far * far * k - v.right * v.right * k_edge +
                 (W - log_omega * v.y - beyond * 2) * v.w) *
                slope.rate_drop(i) / 2;
    }
    const Ball at_edge =
        over_linear_measure<LeftBalanceKernel>(slope, e, contact.knot_marks()); // pi g'(a)
    return rise_of_profile(contact, Ball(0, beyond.bits()), beyond) +
           (beyond * at_edge - lost) / pi;
}

// docs/stress.md, "The gap": h = C x^(m+1)/(m+1) - (2/(pi E* (m+1))) (a P'(a) arcosh(x/a)
// + x P_1(x)), where C follows from P'(a) = E* C a^m sqrt(pi) Gamma(m/2 + 1)/Gamma((m + 1)/2).
Ball power_law_gap(const BallContact& contact, const Ball& beyond) {
    const long bits = beyond.bits();
    const Ball& a = contact.a();
    const Ball growth = contact.force_rate() * a;
    const Ball power = contact.power_law()->exponent + 1;
    const Ball m = power - 1;
    const Ball x = a + beyond;
    const Ball pi = Ball::pi(bits);
    const Ball scaled = beyond / a;
    const Ball arcosh = log1p(scaled + sqrt(scaled * (scaled + 2)));
    const Ball slope =
        growth / a * gamma(power / 2) / gamma(m / 2 + 1) / sqrt(pi) * pow(x / a, m); // E* C x^m
    const Ball lift = contact.cauchy_integral(Box(x, Ball(0, bits))).value.real();
    return (slope * x - (growth * arcosh + x * lift) * 2 / pi) / power / contact.modulus();
}

// docs/pressure.md, "Closed form: piecewise linear slopes", integrated over x: with the angle h of
// x and the Green function G, the integral of G from x to a is (v - x) G + w(v) h, and that of
// (v - s) G is (v - x)^2 G/2 - w(v) ((c - v) h + w(x))/2.
Ball carried_by_linear(const BallContact& contact, const Ball& x) {
    const LinearSlope<Ball>& slope = contact.slope();
    const Mark<Ball> at = clamped_mark({contact.a(), contact.b()}, x);
    const Ball length = contact.length();
    const Ball half = length / 2;
    Ball sum = contact.arc() * (half * half * at.h - at.w * at.y) / 2;
    for (const std::size_t i : contact.bends_inside()) {
        const Mark<Ball>& v = contact.knot_marks()[i];
        const Ball offset = at.right - v.right; // v - x
        const Ball moment = ball_green(v, at.right, at.left, at.w, length, offset).moment;
        sum += slope.jump(i) * (moment + v.w * at.h) +
               slope.rate_drop(i) * (offset * moment - v.w * (at.w - v.y * at.h)) / 2;
    }
    return sum * contact.pressure_factor();
}

// docs/stress.md, "Power laws": zeta P' = m P - a P'(a)/W, integrated.
SurfacePotential of_power_law(const BallContact& contact, const Ball& x) {
    const Ball& a = contact.a();
    const Ball growth = contact.force_rate() * a;
    const Ball power = contact.power_law()->exponent + 1;
    const Ball beyond = positive_part(abs(x) - a);
    const Ball scaled = beyond / a;
    const Ball arcosh = log1p(scaled + sqrt(scaled * (scaled + 2)));
    const Mark<Ball> at = clamped_mark({a, a}, x);
    const Box T = contact.cauchy_integral(Box(x, Ball(0, x.bits()))).value;
    const Ball at_edge = contact.cauchy_integral_at(Edge::right);
    return {(x * T.real() + growth * arcosh - a * at_edge) / power,
            (growth * at.h + x * T.imaginary()) / Ball::pi(x.bits()) / power};
}

Ball lift_of_linear(const BallContact& contact, const Ball& x) {
    const Ball factor = Ball::pi(x.bits()) * contact.modulus() / 2;
    const Ball beyond = x - contact.a();
    const Ball rise = rise_of_profile(contact, positive_part(-beyond), positive_part(beyond));
    return contact.cauchy_integral_at(Edge::right) * beyond + (rise - contact.gap_at(x)) * factor;
}

/// The potential where x is known only to be within `slack` of an edge: the force carried decreases
/// as x grows, and for a power law, whose lift is 0 at both edges, T there is between 0 and that of
/// the slope alone.
SurfacePotential potential_about(const BallContact& contact, Edge edge, const Ball& x,
                                 const Ball& slack) {
    const bool right = edge == Edge::right;
    const Ball inside =
        right ? lower_end(contact.a()) - slack * 2 : slack * 2 - lower_end(contact.b());
    const Ball there = right ? Ball(0, x.bits()) : contact.force();
    if (contact.piecewise_linear()) {
        return {lift_of_linear(contact, x), Ball::hull(there, carried_by_linear(contact, inside))};
    }
    const Ball farthest = (contact.a() + slack) / contact.a();
    const Ball most = contact.cauchy_integral_at(Edge::right) *
                      pow(farthest, contact.power_law()->exponent) * slack;
    return {Ball::hull(-most, most), Ball::hull(there, of_power_law(contact, inside).carried)};
}

} // namespace

Ball BallContact::gap_beyond(Edge edge, const Ball& beyond) const {
    if (!piecewise_linear()) {
        return power_law_gap(*this, beyond);
    }
    return edge == Edge::right ? linear_gap(*this, beyond) : linear_gap(mirrored(), beyond);
}

Ball PlaneContact::gap_at(const Ball& x) const {
    const Ball right = x - a_;
    const Ball left = -x - b_;
    if (certainly_negative(right) && certainly_negative(left)) {
        return {0, x.bits()};
    }
    const Edge edge = certainly_negative(right) ? Edge::left : Edge::right;
    const Ball& beyond = edge == Edge::left ? left : right;
    if (!contains_zero(beyond)) {
        return gap_beyond(edge, beyond);
    }
    // The gap grows outwards from 0: h' = W(x)/pi times the integral of the divided difference of
    // g' over 1/w, and g' does not decrease.
    const Ball most = upper_end(beyond);
    const Ball zero(0, x.bits());
    return certainly_positive(most) ? Ball::hull(zero, gap_beyond(edge, most)) : zero;
}

SurfacePotential BallContact::surface_potential(const Ball& x,
                                                const std::optional<Exact>& /*known*/) const {
    for (const Edge edge : {Edge::right, Edge::left}) {
        const Ball inwards = edge == Edge::right ? a_ - x : b_ + x;
        if (contains_zero(inwards) && arb_is_exact(inwards.data()) == 0) {
            return potential_about(*this, edge, x, upper_end(abs(inwards)));
        }
    }
    if (!piecewise_linear()) {
        return of_power_law(*this, x);
    }
    return {lift_of_linear(*this, x), carried_by_linear(*this, x)};
}

// The traction is (Q/pi + sigma_0 (x - c)/4)/w (docs/partial-slip.md).
SurfacePotential surface_potential(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                   const Ball& x) {
    const Ball half = e.length() / 2;
    const Mark<Ball> at = clamped_mark(e, x);
    const Ball right = positive_part(x - e.a);
    const Ball left = positive_part(-x - e.b);
    const Ball beyond = right + left; // one of them is 0
    const Ball root = Field<Ball>::root(beyond * (beyond + half * 2));
    const Ball tension = load.bulk_tension / 4;
    const Ball pi = Ball::pi(x.bits());
    const Ball signed_root = certainly_positive(left) ? -root : root;
    return {load.Q * log1p((beyond + root) / half) + pi * tension * (signed_root - (x - e.a)),
            load.Q * at.h / pi + tension * at.w};
}

} // namespace edgeproof::contact

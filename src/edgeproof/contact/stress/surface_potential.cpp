// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/surface_potential.hpp"

#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"
#include "edgeproof/contact/stress/surface_gap.hpp"

#include <cstddef>

namespace edgeproof::contact {
namespace {

Ball positive_part(const Ball& x) { return max(x, Ball(0, x.bits())); }

/// The integral of g'(y) - g'(a) over y from the right edge a to x.
Ball rise_of_profile(const BallContact& contact, const Ball& x) {
    const LinearSlope<Ball>& slope = contact.slope();
    const Ball inwards = positive_part(contact.a() - x);
    const Ball outwards = positive_part(x - contact.a());
    const Ball& rate = [&]() -> const Ball& {
        std::size_t at_edge = 0;
        while (at_edge < slope.knots.size() && contact.knot_marks()[at_edge].end != Edge::right) {
            ++at_edge;
        }
        return slope.rate(at_edge);
    }();
    Ball sum = rate * (inwards * inwards + outwards * outwards) / 2;
    for (std::size_t i = 0; i < slope.knots.size(); ++i) {
        const bool beyond = contact.knot_marks()[i].end == Edge::right;
        const Ball& v = slope.knots[i];
        const Ball passed = beyond ? positive_part(x - max(v, contact.a()))
                                   : positive_part(min(v, contact.a()) - x);
        const Ball change = slope.rate_drop(i) * passed * passed / 2;
        sum += slope.jump(i) * passed + (beyond ? -change : change);
    }
    return sum;
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
    for (std::size_t i = 0; i < slope.knots.size(); ++i) {
        if (!contact.bends_inside(i)) {
            continue;
        }
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
    const Box T = cauchy_integral(contact, Box(x, Ball(0, x.bits()))).value;
    const Ball at_edge = cauchy_integral_at_edge(contact, Edge::right);
    return {(x * T.real() + growth * arcosh - a * at_edge) / power,
            (growth * at.h + x * T.imaginary()) / Ball::pi(x.bits()) / power};
}

} // namespace

SurfacePotential surface_potential(const BallContact& contact, const Ball& x) {
    if (!contact.piecewise_linear()) {
        return of_power_law(contact, x);
    }
    const Ball factor = Ball::pi(x.bits()) * contact.modulus() / 2;
    return {cauchy_integral_at_edge(contact, Edge::right) * (x - contact.a()) +
                (rise_of_profile(contact, x) - gap_at(contact, x)) * factor,
            carried_by_linear(contact, x)};
}

// The traction is (Q/pi + sigma_0 (x - c)/4)/w (docs/shear.md).
SurfacePotential surface_potential(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                   const Ball& x) {
    const Ball half = e.length() / 2;
    const Mark<Ball> at = clamped_mark(e, x);
    const Ball right = positive_part(x - e.a);
    const Ball left = positive_part(-x - e.b);
    const Ball beyond = right + left; // one of them is 0
    const Ball root = sqrt(beyond * (beyond + half * 2));
    const Ball tension = load.bulk_tension / 4;
    const Ball pi = Ball::pi(x.bits());
    const Ball signed_root = certainly_positive(left) ? -root : root;
    return {load.Q * log1p((beyond + root) / half) + pi * tension * (signed_root - (x - e.a)),
            load.Q * at.h / pi + tension * at.w};
}

} // namespace edgeproof::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/stress/surface_gap.hpp"

#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"
#include "edgeproof/contact/stress/linear_gap.hpp"

#include <cstddef>

namespace edgeproof::contact {
namespace {

/// The integral of g'(y) - g'(a) over a < y < a + beyond: each bend of the slope beyond the edge
/// contributes its jump times the distance from it, and its change of g'' times half the square.
Ball gap_of_profile(const BallContact& contact, const Ball& beyond) {
    const LinearSlope<Ball>& slope = contact.slope();
    const Ball zero(0, beyond.bits());
    Ball rate = slope.rate(slope.knots.size());
    Ball sum = zero;
    for (std::size_t i = slope.knots.size(); i-- > 0;) {
        const Ball outside = slope.knots[i] - contact.a();
        if (contact.knot_marks()[i].end != Edge::right) {
            if (certainly_negative(outside)) {
                break;
            }
            // It counts as inside; if it is beyond, the error is at most that of its distance.
            sum += up_to(abs(outside) * (abs(slope.jump(i)) + abs(slope.rate_drop(i)) * beyond));
            continue;
        }
        const Ball distance = max(zero, beyond - max(zero, outside));
        sum += slope.jump(i) * distance - slope.rate_drop(i) * distance * distance / 2;
        rate = slope.rate(i);
    }
    return sum + rate * beyond * beyond / 2;
}

// docs/stress.md, "The gap"
Ball linear_gap(const BallContact& contact, const Ball& beyond) {
    const Extent<Ball> e{contact.a(), contact.b()};
    const Ball half = e.length() / 2;
    const Ball W = sqrt(beyond * (e.length() + beyond));
    const Ball omega = half / (half + beyond + W);
    const Ball at_edge =
        over_linear_measure<LeftBalanceKernel>(contact.slope(), e, contact.knot_marks());
    const BeyondEdge<Ball> x{beyond, W, omega, log1p((beyond + W) / half)};
    return gap_of_profile(contact, beyond) +
           gap_of_contact(contact, at_edge, x, [&](const Mark<Ball>& v) {
               return atan2(omega * v.w / half, 1 - omega * v.y / half) * 2;
           });
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
    const Ball lift = cauchy_integral(contact, Box(x, Ball(0, bits))).value.real();
    return (slope * x - (growth * arcosh + x * lift) * 2 / pi) / power / contact.modulus();
}

} // namespace

Ball gap_beyond(const BallContact& contact, Edge edge, const Ball& beyond) {
    if (!contact.piecewise_linear()) {
        return power_law_gap(contact, beyond);
    }
    return edge == Edge::right ? linear_gap(contact, beyond)
                               : linear_gap(contact.mirrored(), beyond);
}

Ball gap_at(const BallContact& contact, const Ball& x) {
    const Ball right = x - contact.a();
    const Ball left = -x - contact.b();
    if (certainly_negative(right) && certainly_negative(left)) {
        return {0, x.bits()};
    }
    return certainly_negative(right) ? gap_beyond(contact, Edge::left, clamped(left))
                                     : gap_beyond(contact, Edge::right, clamped(right));
}

} // namespace edgeproof::contact

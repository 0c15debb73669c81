// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"

#include <cstddef>

/// The gap outside a contact with a piecewise linear slope (docs/stress.md, "The gap").
namespace edgeproof::contact {

/// A place at the distance `beyond` (length) beyond the right edge, in a number or complex box U.
template <class U> struct BeyondEdge {
    U beyond;
    U root;      ///< W = sqrt(beyond (D + beyond)) (length)
    U omega;     ///< (D/2)/(D/2 + beyond + W)
    U log_omega; ///< -ln omega
};

/// Returns pi times (g'(a) beyond less the gap) for a profile that is linear beyond the edge with
/// g'' = 0: the integral of h' = g' - (2/(pi E*)) P_1 from the edge, with g'(a) by the consistency
/// condition. The integral of g'(y) - g'(a) has to be added to the gap.
/// @param contact the contact, or a zone of its profile
/// @param at_edge the integral of (pi - h) dg', which is pi g'(a)
/// @param x the place (length)
/// @param k_of returns k(x, v) = 2 arg(1 - omega e^(-ih)) for the mark of a knot
template <class U, class Kernel>
[[nodiscard]] U gap_of_contact(const BallContact& contact, const Ball& at_edge,
                               const BeyondEdge<U>& x, const Kernel& k_of) {
    const LinearSlope<Ball>& slope = contact.slope();
    const Ball half = (contact.a() + contact.b()) / 2;
    const Ball pi = Ball::pi(half.bits());
    const Ball one(1, half.bits());
    U lost = (x.log_omega * Ball(2, half.bits()) + x.omega * x.omega - one) *
             (contact.arc() * half * half / 4);
    for (std::size_t i = 0; i < slope.knots.size(); ++i) {
        if (!contact.bends_inside(i)) {
            continue;
        }
        const Mark<Ball>& v = contact.knot_marks()[i];
        const U far = x.beyond + v.right; // x - v
        const U k = k_of(v);
        const Ball k_edge = pi - v.h;
        if (slope.has_corner(i)) {
            lost = lost + (far * k - v.right * k_edge + x.log_omega * v.w) * slope.jump(i);
        }
        lost = lost - (far * far * k - v.right * v.right * k_edge +
                       (x.root - x.log_omega * v.y - x.beyond * Ball(2, half.bits())) * v.w) *
                          (slope.rate_drop(i) / 2);
    }
    return (x.beyond * at_edge - lost) / pi;
}

} // namespace edgeproof::contact

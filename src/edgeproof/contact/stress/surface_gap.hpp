// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/precision/ball/ball.hpp"

#include <cstddef>

/// The gap between the bodies outside a contact, or outside a zone of its profile that is a contact
/// with a tilt (docs/stress.md).
namespace edgeproof::contact {

/// The gap (length) at the distance `beyond` >= 0 (length) outwards from an edge of a contact with
/// a closed form. Enclosed. It grows as beyond^(3/2) at the edge.
[[nodiscard]] Ball gap_beyond(const BallContact& contact, Edge edge, const Ball& beyond);

/// The gap (length) at the place x (length) on either side of a contact with a closed form, or of a
/// zone of its profile; 0 inside. Enclosed.
[[nodiscard]] Ball gap_at(const BallContact& contact, const Ball& x);

/// Integrals of a traction t and of its Cauchy integral T along the surface, from which the
/// displacements of a half-plane follow (docs/stress.md, "The displacements").
struct SurfacePotential {
    Ball lift;    ///< the integral of Re T from the right edge to x (force/length)
    Ball carried; ///< the integral of t from x to the right edge (force/length)

    friend SurfacePotential operator-(const SurfacePotential& x, const SurfacePotential& y) {
        return {x.lift - y.lift, x.carried - y.carried};
    }
    friend SurfacePotential operator+(const SurfacePotential& x, const SurfacePotential& y) {
        return {x.lift + y.lift, x.carried + y.carried};
    }
    friend SurfacePotential operator*(const SurfacePotential& x, const Ball& factor) {
        return {x.lift * factor, x.carried * factor};
    }
};

/// Returns the potential of the pressure of a contact with a closed form, or of a zone of its
/// profile. Enclosed.
/// @param contact the contact, or the zone
/// @param x the place (length), anywhere on the surface
[[nodiscard]] SurfacePotential surface_potential(const BallContact& contact, const Ball& x);

/// Returns the potential of the traction under full stick (law/shear.hpp). Enclosed.
/// @param e the contact
/// @param load Q (force/length) and sigma_0 (stress)
/// @param x the place (length)
[[nodiscard]] SurfacePotential surface_potential(const Extent<Ball>& e, const ShearLoad<Ball>& load,
                                                 const Ball& x);

/// Returns the integral of h(x) (pressure p(x) + punch/w(x)) dx over the places of `outer` outside
/// `inner`: h (length) is the gap of the contact `inner`, p and w = sqrt((a - x)(x + b)) are those
/// of `outer`. Enclosed, by rigorous integration in x = a_i + (a - a_i) sin^2(pi t/2), which
/// removes the roots at both ends. Wide if the bits do not distinguish the contacts.
/// @param inner a contact with a piecewise linear slope
/// @param outer a contact of the same profile under a greater force
/// @param pressure factor of p
/// @param punch factor of 1/w
[[nodiscard]] Ball gap_integral(const BallContact& inner, const BallContact& outer,
                                const Ball& pressure, const Ball& punch);

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
    for (const std::size_t i : contact.bends_inside()) {
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

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

} // namespace edgeproof::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/stress/cauchy_integral.hpp"

#include <vector>

namespace edgeproof::contact {

/// The pressure of a contact, or of a zone of its profile, as a part of the load on a body.
struct LoadPart {
    BallContact contact;
    Ball pressure; ///< its factor in p
    Ball shear;    ///< its factor in the shear traction on the body
};

/// A half-plane under pressure, shear traction and bulk stress, in balls of one precision.
struct StressField {
    /// The contact first, then its stick zone if there is one; after a load history the zones of
    /// the layers, the smallest one first.
    std::vector<LoadPart> parts;
    Ball bulk; ///< stress
    /// True if the load is known to be symmetric: then all stresses at (-x, z) are those at (x, z).
    bool mirrored = false;
    /// True if tau_max is known to be the same at (-x, 0) and at (x, 0).
    bool surface_mirrored = false;
    /// True if sxx is known to be -p in the zone of the part 1: neither a bulk stress nor a tilt,
    /// and no shear where the contact has always stuck.
    bool untilted = false;

    [[nodiscard]] long bits() const { return bulk.bits(); }
    [[nodiscard]] const BallContact& contact() const { return parts.front().contact; }
    /// The field of the mirror image.
    [[nodiscard]] StressField reflected() const;
};

/// The greatest stress sxx along the surface, tension positive (stress), and the edge of the
/// contact at which it is, for a shear traction between the surfaces of one direction, whose ratio
/// to the pressure does not decrease towards the edges, as in partial slip: at the trailing edge
/// (docs/stress.md, "The greatest values"). Infinite nowhere.
struct SurfaceTension {
    Edge edge;
    Ball value;
};
/// The shear factor of the first part must not be zero.
[[nodiscard]] SurfaceTension greatest_surface_tension(const StressField& field);

} // namespace edgeproof::contact

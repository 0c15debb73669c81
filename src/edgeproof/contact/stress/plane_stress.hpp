// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/stress/cauchy_integral.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace edgeproof::contact {

/// The stress at a point of a body in the plane of the contact, tension positive (stress). z is the
/// depth into that body; on its surface szz = -p, and sxz = -q with the traction q on that body.
struct StressState {
    Ball sxx;
    Ball szz;
    Ball sxz;
    Ball half_difference; ///< (sxx - szz)/2, computed without cancellation: exactly 0 where it is 0
    /// The normal stress across the plane, if it is not that of plane strain.
    std::optional<Ball> across = {};

    /// The greatest shear stress in the plane; with `across`, of all planes.
    [[nodiscard]] Ball tau_max() const {
        const Ball in_plane = shear_in_plane();
        return across ? max(in_plane, (abs(mean() - *across) + in_plane) / 2) : in_plane;
    }
    /// The normal stress across the plane, in plane strain, for Poisson's ratio `nu`.
    [[nodiscard]] Ball syy(const Ball& nu) const { return across ? *across : nu * (sxx + szz); }
    /// The equivalent stress of von Mises, without `across` in plane strain, for Poisson's ratio
    /// `nu`.
    [[nodiscard]] Ball mises(const Ball& nu) const;
    /// The principal stresses in plane strain, s1 >= s2 >= s3; syy is one of them.
    [[nodiscard]] std::array<Ball, 3> principal(const Ball& nu) const;
    /// The equivalent stress of Tresca in plane strain, s1 - s3, for Poisson's ratio `nu` <= 1/2.
    [[nodiscard]] Ball tresca(const Ball& nu) const;

private:
    /// The greatest shear stress in the plane.
    [[nodiscard]] Ball shear_in_plane() const {
        return arb_is_zero(sxz.data()) != 0 ? abs(half_difference) : hypot(half_difference, sxz);
    }
    [[nodiscard]] Ball mean() const { return (sxx + szz) / 2; }
};

/// The stress at zeta = x + i z of a half-plane whose surface carries the pressure with the Cauchy
/// integral `p`, the shear traction with the Cauchy integral `q`, and the bulk stress `bulk`
/// (stress)
/// (`johnson1985`, eq. 2.23; docs/stress.md, "The Cauchy integrals").
[[nodiscard]] StressState stress_of(const CauchyIntegral& p, const CauchyIntegral& q,
                                    const Box& zeta, const Ball& bulk);

/// The pressure of a contact, or of a zone of its profile, as a part of the load on a body.
struct LoadPart {
    std::shared_ptr<const PlaneContact> contact;
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
    [[nodiscard]] const PlaneContact& contact() const { return *parts.front().contact; }
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

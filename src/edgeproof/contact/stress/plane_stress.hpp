// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/stress/cauchy_integral.hpp"

#include <array>
#include <optional>

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
/// (`johnson1985`, eq. 2.23; docs/stress.md, "Stresses").
[[nodiscard]] StressState stress_of(const CauchyIntegral& p, const CauchyIntegral& q,
                                    const Box& zeta, const Ball& bulk);

} // namespace edgeproof::contact

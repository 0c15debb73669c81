// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/edge.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/precision/ball/ball.hpp"

namespace edgeproof::contact {

/// A punch whose tilt is not given. phi: slope; t, R: lengths.
struct TiltedPunch {
    Profile::Kind kind; ///< tilted_wedge or tilted_flat_and_rounded
    Exact phi;          ///< the slope of the wedge's faces
    Exact t;            ///< the half-length of the flat of a flat-and-rounded punch
    Exact R;            ///< the radius of a flat-and-rounded punch
    [[nodiscard]] static TiltedPunch wedge(Exact phi);
    [[nodiscard]] static TiltedPunch flat_and_rounded(Exact t, Exact R);
    [[nodiscard]] Profile at(const Exact& alpha) const;
};

/// A tilt enclosed by a ball (a slope, dimensionless), and the profile of a tilt in or near it.
struct EnclosedTilt {
    Ball alpha;
    Profile near;
    bool exactly_zero = false; ///< the tilt is 0, and `near` is its profile
};

/// The proved tilt at which a punch carries the normal force P > 0 and the moment M, both per unit
/// length; contact_modulus is a stress.
///
/// M is the integral of x p (moore-hills EQ22): positive where it presses the right side down. It
/// is taken about the origin, which is the minimum of the tilted punch. For the wedge this is its
/// apex. For the flat-and-rounded punch the minimum moves with the tilt, to the distance alpha R
/// from the right end of the flat: a moment M_c about the middle of the flat corresponds to
/// M = M_c - P (t + alpha R).
///
/// At most one tilt satisfies this: with P held, dM/dalpha = pi E* c^2/4 - P R with c = (a + b)/2
/// (without P R for the wedge; docs/mechanics.md, "Profiles"). The first term is the couple of a
/// flat punch of half-width c that turns by dalpha. The measure dg' of the flat-and-rounded punch
/// is dx/R less a part inside the contact, so that P < pi E* c^2/(4R) while a part of the flat is
/// in contact, and dM/dalpha > 0.
///
/// For a wedge there is a tilt for every M, in closed form. A flat-and-rounded punch needs
/// -t P <= M < 0: at -t P it is upright, and from alpha = sqrt(4P/(pi E* R)) on the contact lies
/// within one arc, where M = 0 for every tilt. Throws InputError otherwise, for P <= 0, and for
/// t = 0; BudgetError if these bits do not isolate the tilt.
[[nodiscard]] EnclosedTilt enclose_tilt(const TiltedPunch& punch, const Exact& contact_modulus,
                                        const Exact& P, const Exact& M, long bits);

} // namespace edgeproof::contact

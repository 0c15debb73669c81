// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/routes/normal_contact.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace edgeproof::contact {

/// A punch whose tilt is not given.
struct TiltedPunch {
    Profile::Kind kind; ///< tilted_wedge or tilted_flat_and_rounded
    formula::Exact phi; ///< of the wedge
    formula::Exact t;   ///< of the flat-and-rounded
    formula::Exact R;
    [[nodiscard]] static TiltedPunch wedge(formula::Exact phi);
    [[nodiscard]] static TiltedPunch flat_and_rounded(formula::Exact t, formula::Exact R);
    [[nodiscard]] Profile at(const formula::Exact& alpha) const;
};

/// The tilt found, as an exact constant: a decimal, or a decimal below the largest tilt. A contact
/// of `profile` under P has the moment asked for, to the digits asked for.
struct SolvedTilt {
    formula::Exact alpha;
    Profile profile;
    std::size_t contacts = 0; ///< solved on the way
    /// The tilt, and a little less and more of it: by about 10^-k of its distance from the end of
    /// its range that it is near. For the exact tilts 0 there is none.
    std::function<formula::Exact(unsigned k, int sense)> beside = {};
    bool certain = true; ///< false: 0 as far as can be told
};

/// The tilt at which a punch carries the normal force P > 0 and the moment M, both per unit length.
///
/// M is the integral of x p (moore-hills.tex eqn:AppliedNormalForce_NonSym): positive where it
/// presses the right side down, and taken about the origin, which is the minimum of the tilted
/// punch. For the wedge that is its apex. For the flat-and-rounded punch it moves with the tilt, by
/// alpha R from the right end of the flat: a moment M_c about the middle of the flat is
/// M = M_c - P (t + alpha R).
///
/// At most one tilt fits: with P held, dM/dalpha = pi E* c^2/4 - P R with c = (a + b)/2 (no P R for
/// the wedge), the first term being the couple of a flat punch of half-width c that turns by
/// dalpha. The measure dg' of the flat-and-rounded punch is dx/R less a part inside the contact, so
/// P < pi E* c^2/(4R) as long as any of the flat is in contact, and dM/dalpha > 0.
///
/// A wedge finds a tilt for every M. A flat-and-rounded punch needs -t P <= M < 0: at -t P it
/// stands upright, and from alpha = sqrt(4P/(pi E* R)) on the contact lies within one arc, where M
/// = 0 whatever the tilt. Throws InputError otherwise, for P <= 0, and for t = 0; BudgetError for
/// an M within 1e-1000 of the ends of its range.
[[nodiscard]] SolvedTilt solve_tilt(const TiltedPunch& punch, const formula::Exact& contact_modulus,
                                    const formula::Exact& P, const formula::Exact& M,
                                    unsigned digits);

} // namespace edgeproof::contact

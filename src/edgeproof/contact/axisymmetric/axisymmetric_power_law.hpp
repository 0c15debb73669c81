// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/formula/expr.hpp"

namespace edgeproof::contact {

/// A power law g'(r) = C r^m as a body of revolution (docs/axisymmetric.md, "Power laws"), exactly.
struct AxisymmetricPowerLaw {
    Expr C; ///< 1/length^m
    Expr m;
    Expr kappa; ///< delta = kappa a^(m + 1)

    /// Throws InputError for a profile that is no power law.
    [[nodiscard]] static AxisymmetricPowerLaw of(const Profile& profile);
    /// The slope of the plane contact that has the same pressure for the same a.
    [[nodiscard]] Profile plane() const;
    /// The approach delta (length) for the radius a (length).
    [[nodiscard]] Exact approach(const Exact& a) const;
    /// The total force P for E* (stress) and the radius a (length).
    [[nodiscard]] Exact force(const Exact& modulus, const Exact& a) const;
    /// The radius a (length) for E* (stress) and the total force P.
    [[nodiscard]] Exact radius(const Exact& modulus, const Exact& P) const;
    /// The radius a (length) for the approach delta (length).
    [[nodiscard]] Exact radius_at(const Exact& delta) const;

private:
    /// P/a^(m + 2).
    [[nodiscard]] Expr force_factor(const Exact& modulus) const;
};

} // namespace edgeproof::contact

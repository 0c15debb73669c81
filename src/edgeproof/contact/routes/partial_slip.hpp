// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/slip_series.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/shear_traction.hpp"

#include <cstddef>

namespace edgeproof::contact {

/// Partial slip in Real from the pressures inside the slip zones alone (docs/partial-slip.md, "The
/// second route"), without a corrective contact and without the law of the profile. With |q| = f p
/// in the slip zones, the integral equation of the stick zone -beta < x < alpha has a bounded
/// solution with the resultant Q if
///     integral over both slip zones of p sqrt(|s + beta|/|s - alpha|) ds
///         = (|Q| + pi |Q| (sigma_0/Q) (alpha + beta)/8)/f,
/// and the mirror image of this equation holds. Then q/f = (w_s(x)/pi) times the integral of
/// p/(w_s |s - x|) in the stick zone. All terms are positive, so that nothing cancels. Values are
/// estimates.
class PartialSlip {
public:
    /// Keeps references to both arguments. Throws InputError if |Q| >= f P, and BudgetError if no
    /// slip zones are found, for example because the stick zone would reach an edge of the contact.
    PartialSlip(const NormalContact& contact, const ShearSpec& shear);

    [[nodiscard]] Real load_ratio() const;    ///< |Q|/(f P)
    [[nodiscard]] Real size(Edge edge) const; ///< size of the slip zone, a length
    /// The estimated relative error of the sizes.
    [[nodiscard]] Real estimate() const;
    /// True if the point at the distance u from the edge lies in the stick zone.
    [[nodiscard]] bool sticks(Edge edge, const Real& u) const;
    /// q (a stress) at the distance u from the edge.
    [[nodiscard]] Real traction(Edge edge, const Exact& u) const;
    /// The series of both sizes in powers of load_ratio() (slip_series.hpp).
    [[nodiscard]] SlipSeries<Real> series(std::size_t terms) const;

private:
    struct Zones {
        Real right;
        Real left;
    };
    /// The relative residuals of the two equations.
    struct Balance {
        Real right;
        Real left;
    };
    /// The load, and the contact at one number of digits.
    struct Asked {
        const NormalContact& contact;
        Real D;
        Real force; ///< |Q|/f
        Real turn;  ///< pi (sigma_0/Q)/8, 1/length
        unsigned target;
    };
    [[nodiscard]] Asked asked(const NormalContact& contact) const;
    [[nodiscard]] static Balance off(const Asked& at, const Zones& d);
    [[nodiscard]] static Zones solve(const Asked& at, Zones d);
    template <class F>
    [[nodiscard]] static Real over_zone(const Asked& at, Edge edge, const Real& d, const F& kernel);

    const NormalContact& contact_;
    const ShearSpec& shear_;
    Zones d_;
};

/// The energy per unit length that friction dissipates in a cycle of the shear force, from -|Q| to
/// |Q| and back, with P held and without bulk tension (docs/partial-slip.md, "The energy of a
/// cycle"), by tanh-sinh over the right edge:
///     W = 8 f^2/(pi E*) times the integral of (P - L)(L - L_s) dD/D over L_s < L < P.
/// The unit is that of a force. This is an estimate. Throws BudgetError if the quadrature does not
/// converge.
[[nodiscard]] Real cycle_energy(const NormalContact& contact, const PartialSlip& slip,
                                const Exact& friction);

} // namespace edgeproof::contact

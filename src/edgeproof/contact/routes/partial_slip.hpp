// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/law/slip_series.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/shear_traction.hpp"

#include <cstddef>
#include <memory>

namespace edgeproof::contact {

/// Partial slip in Real from the pressures inside the slip zones alone (docs/partial-slip.md, "The
/// second route"): no contact is superposed, and no law of the profile is used. With q = f p where
/// it slips, the integral equation of the stick zone -beta < x < alpha has a bounded solution, of
/// the resultant Q, where
///     integral over both slip zones of p sqrt(|s + beta|/|s - alpha|) ds
///         = (|Q| + pi |Q| (sigma_0/Q) (alpha + beta)/8)/f,
/// and its mirror image; then q/f = (w_s(x)/pi) times the integral of p/(w_s |s - x|) in it. All
/// terms are positive: nothing cancels. Values are estimates.
class PartialSlip {
public:
    /// Keeps references to both. Throws InputError where |Q| >= f P, and where the stick zone would
    /// reach an edge of the contact.
    PartialSlip(const NormalContact& contact, const ShearSpec& shear);

    [[nodiscard]] Real load_ratio() const;    ///< |Q|/(f P)
    [[nodiscard]] Real size(Edge edge) const; ///< d
    /// How far the sizes may be off, relative.
    [[nodiscard]] Real estimate() const;
    [[nodiscard]] bool sticks(Edge edge, const Real& u) const;
    [[nodiscard]] Real traction(Edge edge, const formula::Exact& u) const;
    [[nodiscard]] SlipSeries<Real> series(std::size_t terms) const;

private:
    struct Zones {
        Real right;
        Real left;
    };
    struct Balance {
        Real right;
        Real left;
    };
    /// What the load asks for, at one number of digits.
    struct Asked {
        const NormalContact& contact;
        Real D;
        Real force; ///< |Q|/f
        Real turn;  ///< pi (sigma_0/Q)/8
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

} // namespace edgeproof::contact

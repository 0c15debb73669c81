// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/contact/stress/cauchy_integral.hpp"

#include <vector>

namespace edgeproof::contact {

/// The Cauchy integral of the pressure of a plane contact made by proved_contact(). Enclosed.
[[nodiscard]] CauchyIntegral pressure_integral(const ProvedContact& contact, const Box& zeta);

/// The parts of the traction of partial slip, or after a load history, as contacts: by closed
/// forms, or by rigorous integration for curved slopes and for power laws under a bulk tension.
class TractionParts {
public:
    /// @param slip the state, which does not slide
    /// @param contact the plane contact
    /// @param profile g'(x) of it
    /// @param contact_modulus E* (stress)
    /// @param tilted true if a bulk tension tilts the zones
    TractionParts(const BallSlip& slip, const ProvedContact& contact, const Profile& profile,
                  const formula::Exact& contact_modulus, bool tilted);

    /// The zones of the parts as contacts, in the order of BallSlip::parts(); null without closed
    /// forms.
    [[nodiscard]] const std::vector<BallContact>* closed() const {
        return closed_forms_ ? &closed_ : nullptr;
    }
    /// The Cauchy integral of q. Enclosed. `p` is that of the pressure at the same place.
    [[nodiscard]] CauchyIntegral integral(const CauchyIntegral& p, const Box& zeta) const;

private:
    bool closed_forms_;
    std::vector<BallContact> closed_;
    std::vector<IntegratedContact> integrated_;
    Ball whole_ratio_;
    std::vector<Ball> ratios_;
};

} // namespace edgeproof::contact

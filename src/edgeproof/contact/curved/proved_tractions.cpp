// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/proved_tractions.hpp"

namespace edgeproof::contact {

CauchyIntegral pressure_integral(const ProvedContact& contact, const Box& zeta) {
    const BallContact* const closed = contact.closed_form();
    return closed != nullptr
               ? cauchy_integral(*closed, zeta)
               : dynamic_cast<const IntegratedContact&>(contact).cauchy_integral(zeta);
}

TractionParts::TractionParts(const BallSlip& slip, const ProvedContact& contact,
                             const Profile& profile, const formula::Exact& contact_modulus,
                             bool tilted)
    : whole_ratio_(slip.whole_ratio()) {
    const BallContact* const closed = contact.closed_form();
    const auto* const curved = dynamic_cast<const IntegratedContact*>(&contact);
    closed_forms_ = closed != nullptr && (closed->piecewise_linear() || !tilted);
    for (const ShearPart& part : slip.parts()) {
        ratios_.push_back(part.ratio);
        const auto& [a, b] = part.zone;
        if (closed_forms_) {
            closed_.push_back(closed->between(a, b));
        } else if (curved != nullptr) {
            integrated_.push_back(curved->between(a, b, contact.bits()));
        } else {
            integrated_.push_back(
                IntegratedContact(profile, contact_modulus, a, b, contact.bits()));
        }
    }
}

// docs/stress.md, "The Cauchy integrals of q": in partial slip q = f (p - p*) in the direction of
// Q; after a load history q is a sum of such parts (docs/histories.md).
CauchyIntegral TractionParts::integral(const CauchyIntegral& p, const Box& zeta) const {
    CauchyIntegral q = p * whole_ratio_;
    for (std::size_t i = 0; i < ratios_.size(); ++i) {
        q = q - (closed_forms_ ? contact::cauchy_integral(closed_[i], zeta)
                               : integrated_[i].cauchy_integral(zeta)) *
                    -ratios_[i];
    }
    return q;
}

} // namespace edgeproof::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/proved_slip.hpp"

#include "edgeproof/contact/curved/integrated_zones.hpp"

namespace edgeproof::contact {

ProvedSlip::ProvedSlip(const Profile& profile, const formula::Exact& contact_modulus,
                       const Load& load, const ShearLoad<Ball>& shear, const Ball& friction,
                       long bits) {
    if (BallContact::has_closed_form(profile)) {
        closed_ = std::make_unique<BallContact>(profile, contact_modulus, load, bits);
        const bool tilted = !shear.bulk_tension.is_exact() || !contains_zero(shear.bulk_tension);
        zones_ = tilted && !closed_->piecewise_linear()
                     ? power_law_zones(profile, contact_modulus, closed_->a(), closed_->b(), bits)
                     : closed_form_zones(*closed_);
    } else {
        curved_ = std::make_unique<IntegratedContact>(profile, contact_modulus, load, bits);
        zones_ = integrated_zones(*curved_);
    }
    slip_.emplace(pressure(), *zones_, closed_ ? closed_->force() : curved_->force(), shear,
                  friction);
}

bool ProvedSlip::admissible() const {
    return !slip_->sliding() && !certainly_negative(slip_->size(Edge::right)) &&
           !certainly_negative(slip_->size(Edge::left));
}

} // namespace edgeproof::contact

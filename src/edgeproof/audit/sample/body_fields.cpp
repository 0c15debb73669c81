// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/sample/body_fields.hpp"
#include "edgeproof/contact/stress/plane_stress.hpp"
#include "edgeproof/contact/stress/surface_gap.hpp"
#include "edgeproof/precision/error.hpp"

namespace edgeproof::audit {

BodyFields::BodyFields(const SceneSpec& scene, const std::optional<contact::ShearLoad<Ball>>& load,
                       const std::optional<Ball>& friction, long bits)
    : load_(load) {
    const contact::Profile profile = scene.make_profile();
    const Exact& modulus = scene.parameter("Es");
    const contact::Load edge = contact::Load::right_edge(scene.parameter("a"));
    if (!friction) {
        contact_ = contact::proved_contact(profile, modulus, edge, bits);
        return;
    }
    slip_ = std::make_unique<contact::ProvedSlip>(profile, modulus, edge, *load, *friction, bits,
                                                  scene.force_of_slip(bits));
    if (slip_->slip().admissible()) {
        const Ball& tension = load->bulk_tension;
        parts_.emplace(slip_->slip(), slip_->contact(), profile, modulus,
                       !tension.is_exact() || !contains_zero(tension));
    }
}

const contact::ProvedSlip& BodyFields::partial_slip() const {
    if (!parts_) {
        throw Error("no partial slip: the contact slides, or the stick zone leaves it");
    }
    return *slip_;
}

Ball BodyFields::stress(std::string_view name, const Ball& x, const Ball& z) const {
    if (arb_is_nonnegative(z.data()) == 0) {
        throw DomainError("a stress at a depth that may be negative");
    }
    const Box zeta(x, z);
    const contact::CauchyIntegral p = contact::pressure_integral(contact(), zeta);
    contact::CauchyIntegral q = p * Ball(0, z.bits());
    if (slip_) {
        static_cast<void>(partial_slip());
        q = parts_->integral(p, zeta);
    } else if (load_) {
        q = cauchy_integral(contact::Extent<Ball>{contact().a(), contact().b()}, *load_, zeta);
    }
    const contact::StressState at = stress_of(p, q, zeta, Ball(0, z.bits()));
    return name == "sxx" ? at.sxx : name == "szz" ? at.szz : at.sxz;
}

Ball BodyFields::slip(const Ball& x) const {
    const contact::BallSlip& state = partial_slip().slip();
    if (!certainly_positive(contact().a() - x) || !certainly_positive(x + contact().b())) {
        throw DomainError("the slip at a place that may be outside the contact");
    }
    if (parts_->closed() == nullptr) {
        throw Error("'slip' has an enclosure only for piecewise linear slopes, and for power laws "
                    "without sig0");
    }
    return state.parts().front().ratio * contact::gap_at(parts_->closed()->front(), x);
}

} // namespace edgeproof::audit

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/measures/exact_shear.hpp"

#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/routes/partial_slip.hpp"
#include "edgeproof/precision/exact_rational.hpp"
#include "edgeproof/scene/run_scene.hpp"

namespace edgeproof::comparison {
namespace {

constexpr unsigned traction_digits = 20;
constexpr unsigned zone_digits = 40;
constexpr unsigned slip_digits = 16; ///< for PartialSlip, which needs a quadrature for each place

} // namespace

struct ExactShear::Solved {
    Solved(const scene::Scene& asked, const contact::Profile& profile,
           const contact::Extent<Real>& extent, const Real& normal)
        : spec(*asked.shear), whole(extent),
          P(normal), load{spec.Q.to<Real>(), spec.bulk_tension.to<Real>()} {
        if (!spec.friction) {
            return;
        }
        friction = spec.friction->to<Real>() * spec.Q.sign();
        scene::Scene zone = asked;
        zone.ask = {};
        zone.ask.quantities = {scene::QuantityGroup::slip};
        zone.ask.digits = {zone_digits, Rounding::nearest, false};
        const auto stick_zone = run_scene(zone).stick;
        if (spec.bulk_tension.sign() != 0 && profile.symmetric()) {
            normal_contact.emplace(profile, asked.contact_modulus, asked.load, slip_digits);
            slip.emplace(*normal_contact, spec);
            return;
        }
        const PrecisionScope scope(zone_digits + 20);
        stick = {stick_zone->a.value.midpoint(), stick_zone->b.value.midpoint()};
        stick_pressure.emplace(profile, asked.contact_modulus.to<Real>(), stick, traction_digits);
    }

    contact::ShearSpec spec;
    contact::Extent<Real> whole;
    Real P;
    contact::ShearLoad<Real> load;
    Real friction; ///< in the direction of Q
    contact::Extent<Real> stick{};
    std::optional<contact::BatchPressure> stick_pressure;
    std::optional<contact::NormalContact> normal_contact;
    std::optional<contact::PartialSlip> slip;
};

ExactShear::ExactShear(const scene::Scene& scene, const contact::Profile& profile,
                       const contact::Extent<Real>& whole, const Real& force)
    : solved_(std::make_unique<Solved>(scene, profile, whole, force)) {}
ExactShear::~ExactShear() = default;
ExactShear::ExactShear(ExactShear&&) noexcept = default;
ExactShear& ExactShear::operator=(ExactShear&&) noexcept = default;

Real ExactShear::at(const contact::Point<Real>& place, const Real& p) const {
    const Solved& s = *solved_;
    if (s.slip) {
        const bool right = place.right <= place.left;
        return s.slip->traction(right ? contact::Edge::right : contact::Edge::left,
                                formula::Exact(formula::Expr::number(exact_rational(
                                    (right ? place.right : place.left).convert_to<double>()))));
    }
    if (s.spec.path == contact::LoadingPath::together) {
        return s.load.Q / s.P * p;
    }
    if (!s.spec.friction) {
        return contact::full_stick_traction(place, s.load);
    }
    const Real right = s.stick.a - place.x;
    const Real left = s.stick.b + place.x;
    if (!(right > 0) || !(left > 0)) {
        return s.friction * p;
    }
    return s.friction * (p - (*s.stick_pressure)({right, left, place.x}).value);
}

double ExactShear::scale() const {
    const Solved& s = *solved_;
    const double length = s.whole.length().convert_to<double>();
    return std::abs(force()) / length + std::abs(s.load.bulk_tension.convert_to<double>()) / 4;
}
double ExactShear::force() const { return solved_->load.Q.convert_to<double>(); }
bool ExactShear::singular() const {
    return !solved_->spec.friction && solved_->spec.path != contact::LoadingPath::together;
}

} // namespace edgeproof::comparison

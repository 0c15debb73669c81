// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/stress/surface_gap.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_level.hpp"

namespace edgeproof::scene {

std::optional<contact::BallContact> BallLevel::stick_contact() {
    if (!stick_contact_ && slip() != nullptr && !slip()->sliding()) {
        const contact::BallZone& zone = slip()->stick();
        stick_contact_ = contact_->closed_form()->between(zone.a, zone.b);
    }
    return stick_contact_;
}

// docs/stress.md, "The Cauchy integrals of q": in partial slip q = f (p - p*) in the direction of
// Q.
contact::CauchyIntegral BallLevel::shear_integral(const contact::CauchyIntegral& p,
                                                  const Box& zeta) {
    if (!scene_.shear) {
        return {Box(bits_), Box(bits_)};
    }
    if (scene_.together()) {
        return p * shear_ratio();
    }
    if (!scene_.slips()) {
        return cauchy_integral(contact::Extent<Ball>{a(), b()}, load(), zeta);
    }
    const auto stick = stick_contact();
    if (!stick) {
        const Box unknown(not_known(), not_known());
        return {unknown, unknown};
    }
    const Ball f = ball_of(*scene_.shear->friction, bits_) * scene_.shear->Q.sign();
    return (p - cauchy_integral(*stick, zeta)) * f;
}

Ball BallLevel::bulk_stress(Body body) const {
    Ball bulk(0, bits_);
    if (scene_.shear) {
        bulk = ball_of(scene_.shear->bulk_A, bits_);
        if (body == Body::B) {
            bulk += ball_of(scene_.shear->bulk_tension, bits_);
        }
    }
    return bulk;
}

std::optional<contact::StressField> BallLevel::stress_field(Body body) {
    const contact::BallContact& whole = *contact_->closed_form();
    contact::StressField field{.parts = {{whole, Ball(1, bits_), Ball(0, bits_)}},
                               .bulk = bulk_stress(body)};
    field.mirrored = scene_.symmetric();
    if (!scene_.slips() && !scene_.together()) {
        return field;
    }
    field.mirrored = false;
    const bool no_tension = scene_.shear->bulk_tension.sign() == 0;
    field.untilted = no_tension && scene_.shear->bulk_A.sign() == 0;
    field.surface_mirrored = scene_.symmetric() && field.untilted;
    Ball shear = scene_.together()
                     ? shear_ratio()
                     : ball_of(*scene_.shear->friction, bits_) * scene_.shear->Q.sign();
    if (body == Body::B) { // it carries -q
        shear = -shear;
    }
    field.parts.front().shear = shear;
    if (scene_.slips()) {
        const auto stick = stick_contact();
        if (!stick) {
            return {};
        }
        field.parts.push_back({*stick, Ball(0, bits_), -shear});
    }
    return field;
}

const contact::StressState& BallLevel::stress(const AskedValue& at) {
    const BodyPoint& point = *at.in_body;
    if (last_stress_ && last_stress_->first == point) {
        return last_stress_->second;
    }
    const Box zeta(ball_of(point.x, bits_), ball_of(point.z, bits_));
    const contact::CauchyIntegral p = cauchy_integral(*contact_->closed_form(), zeta);
    contact::CauchyIntegral q = shear_integral(p, zeta);
    if (point.body == Body::B) { // it carries -q
        q = q * Ball(-1, bits_);
    }
    last_stress_.emplace(point, stress_of(p, q, zeta, bulk_stress(point.body)));
    return last_stress_->second;
}

Ball BallLevel::mises(const AskedValue& at) {
    return stress(at).mises(ball_of(*scene_.poisson(at.in_body->body), bits_));
}

Ball BallLevel::gap(const AskedValue& at) {
    const Ball x = at.place->x_enclosure(a(), b(), bits_);
    const Ball right = x - a();
    const Ball left = -x - b();
    if (certainly_negative(right) && certainly_negative(left)) {
        throw DomainError("the place lies inside the contact");
    }
    const contact::BallContact& closed = *contact_->closed_form();
    return certainly_negative(right)
               ? gap_beyond(closed, contact::Edge::left, contact::clamped(left))
               : gap_beyond(closed, contact::Edge::right, contact::clamped(right));
}

// docs/displacement.md, "The slip": -f times the gap of the corrective contact, in the direction of
// Q.
Ball BallLevel::slip_displacement(const AskedValue& at) {
    const Ball x = at.place->x_enclosure(a(), b(), bits_);
    if (certainly_positive(x - a()) || certainly_positive(-x - b())) {
        throw DomainError("the place lies outside the contact");
    }
    if (!scene_.slips()) {
        return {0, bits_};
    }
    const auto stick = stick_contact();
    if (!stick) {
        return not_known();
    }
    const Ball right = x - stick->a();
    const Ball left = -x - stick->b();
    if (certainly_negative(right) && certainly_negative(left)) {
        return {0, bits_};
    }
    const Ball gap = certainly_negative(right)
                         ? gap_beyond(*stick, contact::Edge::left, contact::clamped(left))
                         : gap_beyond(*stick, contact::Edge::right, contact::clamped(right));
    return gap * ball_of(*scene_.shear->friction, bits_) * (-scene_.shear->Q.sign());
}

} // namespace edgeproof::scene

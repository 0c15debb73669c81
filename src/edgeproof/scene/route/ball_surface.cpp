// SPDX-License-Identifier: GPL-3.0-or-later
// Values at the surface of one body (docs/stress.md, "The displacements").
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/route/ball_level.hpp"

#include <cstddef>

namespace edgeproof::scene {
namespace {

/// The compliances of a body in plane strain (1/stress).
struct Compliances {
    Ball along;  ///< (1 - nu^2)/E
    Ball across; ///< (1 + nu)(1 - 2 nu)/E
};

Compliances compliances_of(const Scene& scene, Body body, long bits) {
    const Ball nu = ball_of(*scene.poisson(body), bits);
    const Ball along =
        scene.bodies ? (1 - nu) * (1 + nu) /
                           ball_of(body == Body::A ? scene.bodies->E1 : scene.bodies->E2, bits)
                     : 1 / (ball_of(scene.contact_modulus, bits) * 2); // equal bodies
    return {along, along * (1 - nu * 2) / (1 - nu)};
}

} // namespace

contact::SurfacePotential BallLevel::shear_potential(const contact::SurfacePotential& p,
                                                     const Ball& x) {
    if (!scene_.shear) {
        return p * Ball(0, bits_);
    }
    if (scene_.together()) {
        return p * shear_ratio();
    }
    if (!scene_.slips()) {
        return surface_potential(contact::Extent<Ball>{a(), b()}, load(), x);
    }
    const auto* const zones = part_contacts();
    if (zones == nullptr) {
        return {not_known(), not_known()};
    }
    contact::SurfacePotential sum = p * slip()->whole_ratio();
    for (std::size_t i = 0; i < zones->size(); ++i) {
        sum = sum + surface_potential((*zones)[i], x) * slip()->parts()[i].ratio;
    }
    return sum;
}

BallLevel::Potentials BallLevel::potentials(const AskedValue& at) {
    const auto place = [&](const Distance& distance) {
        return distance.x_enclosure(a(), b(), bits_);
    };
    const Ball x = place(*at.place);
    const Ball from = place(*at.reference);
    const contact::BallContact& form = *contact_->closed_form();
    const contact::SurfacePotential p = surface_potential(form, x);
    const contact::SurfacePotential p_from = surface_potential(form, from);
    const Ball side(at.in_body->body == Body::A ? 1 : -1, bits_); // B carries -q
    return {p - p_from, (shear_potential(p, x) - shear_potential(p_from, from)) * side, x - from};
}

// johnson1985, eqs. 2.25a and 2.25b, integrated; the bulk stress strains the surface evenly.
Ball BallLevel::ux(const AskedValue& at) {
    const Potentials of = potentials(at);
    const Compliances body = compliances_of(scene_, at.in_body->body, bits_);
    return body.across * of.p.carried - body.along * of.q.lift * 2 / Ball::pi(bits_) +
           body.along * bulk_stress(at.in_body->body) * of.distance;
}

Ball BallLevel::uz(const AskedValue& at) {
    const Potentials of = potentials(at);
    const Compliances body = compliances_of(scene_, at.in_body->body, bits_);
    return -(body.along * of.p.lift * 2 / Ball::pi(bits_)) - body.across * of.q.carried;
}

Ball BallLevel::surface_slope(const AskedValue& at) {
    const Box zeta(at.place->x_enclosure(a(), b(), bits_), Ball(0, bits_));
    const contact::CauchyIntegral p = contact::pressure_integral(*contact_, zeta);
    const contact::CauchyIntegral q = shear_integral(p, zeta);
    const Compliances body = compliances_of(scene_, at.in_body->body, bits_);
    const Ball side(at.in_body->body == Body::A ? 1 : -1, bits_);
    return -(body.along * p.value.real() * 2 + side * body.across * q.value.imaginary()) /
           Ball::pi(bits_);
}

// docs/partial-slip.md, "The energy of a cycle": 4 f p times the slip.
Ball BallLevel::dissipation(const AskedValue& at) {
    const Ball slipped = abs(slip_displacement(at));
    const Box zeta(at.place->x_enclosure(a(), b(), bits_), Ball(0, bits_));
    const contact::CauchyIntegral p = contact::pressure_integral(*contact_, zeta);
    return -(ball_of(*scene_.shear->friction, bits_) * p.value.imaginary() * slipped) * 4 /
           Ball::pi(bits_);
}

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/closed_form_contact.hpp"

#include "edgeproof/contact/tilt/tilt_solver.hpp"

#include <utility>

namespace edgeproof::scene {
namespace {

template <class... Rest> ClosedFormContact contact_of(contact::Profile profile, Rest... rest) {
    return {profile,
            [profile, rest...](long bits) { return contact::BallContact(profile, rest..., bits); }};
}

} // namespace

std::optional<ClosedFormContact> closed_form_contact(const Scene& scene, long tilt_bits) {
    if (scene.punch) {
        contact::EnclosedTilt tilt = enclose_tilt(*scene.punch, scene.contact_modulus,
                                                  scene.load.value, *scene.moment, tilt_bits);
        return tilt.exactly_zero
                   ? contact_of(std::move(tilt.near), scene.contact_modulus, scene.load)
                   : contact_of(std::move(tilt.near), tilt.alpha, scene.contact_modulus,
                                scene.load);
    }
    if (scene.profile->axisymmetric() || !contact::BallContact::has_closed_form(*scene.profile)) {
        return {};
    }
    return contact_of(*scene.profile, scene.contact_modulus, scene.load);
}

} // namespace edgeproof::scene

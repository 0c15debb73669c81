// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/curved/curved_body.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/readers.hpp"

namespace edgeproof::scene {

bool is_axisymmetric(const io::TomlSection& profile) {
    const std::string kind = profile.text("kind");
    const bool of_revolution = kind == "sphere" || kind == "cone";
    if (!profile.has("geometry")) {
        return of_revolution;
    }
    const std::string geometry = profile.text("geometry");
    if (of_revolution && geometry == "plane") {
        profile.reject("geometry", "a " + kind + " is axisymmetric",
                       kind == "sphere" ? "write kind = \"hertz\" for cylinders"
                                        : "write kind = \"wedge\" for a plane contact");
    }
    if (geometry != "plane" && geometry != "axisymmetric") {
        profile.reject("geometry", "unknown geometry '" + geometry + "'",
                       "write plane or axisymmetric");
    }
    return geometry == "axisymmetric";
}

void require_axisymmetric(const io::TomlSection& profile, const Scene& scene) {
    if (!scene.profile || !scene.profile->symmetric()) {
        profile.reject("geometry",
                       "only power laws and symmetric slopes are computed as axisymmetric contacts",
                       "write kind = \"sphere\", cone, power-law, "
                       "flat-and-rounded, or piecewise with symmetric = true");
    }
    if (scene.profile->kind() == contact::Profile::Kind::power_law ||
        scene.profile->piecewise_linear()) {
        return;
    }
    if (!contact::CurvedBody::handles(*scene.profile)) {
        profile.reject("geometry",
                       "g' of the axisymmetric contact has a function beyond the rigorous "
                       "integration",
                       "write g' without abs and hypot, in more pieces if necessary");
    }
    if (const auto v = contact::CurvedBody::not_analytic_at(*scene.profile)) {
        profile.reject("geometry",
                       "g' is not analytic at r = " + v->text() +
                           ", so that the axisymmetric contact is not computed",
                       "write pieces that are analytic up to their ends; a power of r alone is "
                       "kind = \"power-law\"");
    }
}

void revolve(Scene& scene) {
    using contact::Load;
    scene.round = Axisymmetric{*scene.profile, scene.load};
    Axisymmetric& round = *scene.round;
    const formula::Exact given = scene.load.value;
    if (scene.load.kind == Load::Kind::force) {
        round.force = given;
    } else if (scene.load.kind == Load::Kind::approach) {
        round.approach = given;
    }
    if (scene.profile->kind() != contact::Profile::Kind::power_law) {
        scene.profile = scene.profile->revolved();
        return;
    }
    round.law = contact::AxisymmetricPowerLaw::of(*scene.profile);
    scene.profile = round.law->plane();
    const formula::Exact a = round.force      ? round.law->radius(scene.contact_modulus, given)
                             : round.approach ? round.law->radius_at(given)
                                              : given;
    if (!round.force) {
        round.force = round.law->force(scene.contact_modulus, a);
    }
    if (!round.approach) {
        round.approach = round.law->approach(a);
    }
    scene.load = Load::right_edge(a);
}

void change_given(Scene& scene, const std::function<void(Scene&)>& change) {
    if (!scene.round) {
        change(scene);
        return;
    }
    scene.profile = scene.round->profile;
    scene.load = scene.round->load;
    change(scene);
    revolve(scene);
}

const char* Axisymmetric::size_from() const {
    return load.kind == contact::Load::Kind::force      ? "from P"
           : load.kind == contact::Load::Kind::approach ? "from delta"
                                                        : "given";
}

std::string Axisymmetric::load_text() const {
    return (load.kind == contact::Load::Kind::force      ? "P = "
            : load.kind == contact::Load::Kind::approach ? "delta = "
                                                         : "a = ") +
           load.value.text();
}

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/readers.hpp"

namespace edgeproof::scene {

bool is_axisymmetric(const io::TomlSection& profile) {
    if (!profile.has("geometry")) {
        return false;
    }
    const std::string geometry = profile.text("geometry");
    if (geometry != "plane" && geometry != "axisymmetric") {
        profile.reject("geometry", "unknown geometry '" + geometry + "'",
                       "write plane or axisymmetric");
    }
    return geometry == "axisymmetric";
}

void make_axisymmetric(const io::TomlSection& profile, const io::TomlSection& load, Scene& scene) {
    if (!scene.profile || !scene.profile->symmetric() ||
        (scene.profile->kind() != contact::Profile::Kind::power_law &&
         !scene.profile->piecewise_linear())) {
        profile.reject("geometry",
                       "only power laws and symmetric, piecewise linear slopes are computed as "
                       "axisymmetric contacts",
                       "write kind = \"power-law\" (sphere: m = 1, C = 1/R; cone: m = 0), "
                       "flat-and-rounded, or piecewise with symmetric = true and linear slopes");
    }
    const bool power_law = scene.profile->kind() == contact::Profile::Kind::power_law;
    const bool by_force = load.has("P") || !scene.steps.empty();
    const formula::Exact given = scene.load.value;
    scene.round = Axisymmetric{{}, {}, load.has("delta") ? "from delta" : "given"};
    scene.round->profile = scene.profile;
    scene.round->load = (load.has("delta") ? "delta = " : "a = ") + given.text();
    if (power_law) {
        scene.round->law = contact::AxisymmetricPowerLaw::of(*scene.profile);
        scene.profile = scene.round->law->plane();
    } else {
        scene.profile = scene.profile->revolved();
    }
    if (by_force) {
        set_total_force(scene, given);
        return;
    }
    if (load.has("delta")) {
        scene.round->approach = given;
        scene.load = contact::Load::approach(given);
    }
    if (power_law) {
        const formula::Exact a = load.has("delta") ? scene.round->law->radius_at(given) : given;
        scene.round->force = scene.round->law->force(scene.contact_modulus, a);
        if (!scene.round->approach) {
            scene.round->approach = scene.round->law->approach(a);
        }
        scene.load = contact::Load::right_edge(a);
    }
}

void set_total_force(Scene& scene, const formula::Exact& P) {
    scene.round->size_from = "from P";
    scene.round->load = "P = " + P.text();
    scene.round->force = P;
    scene.load = contact::Load::force(P);
    if (scene.round->law) {
        const formula::Exact a = scene.round->law->radius(scene.contact_modulus, P);
        scene.round->approach = scene.round->law->approach(a);
        scene.load = contact::Load::right_edge(a);
    }
}

} // namespace edgeproof::scene

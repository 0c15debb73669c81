// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
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

void require_axisymmetric(const io::TomlSection& profile, const Scene& scene) {
    if (!scene.profile || !scene.profile->symmetric() ||
        (scene.profile->kind() != contact::Profile::Kind::power_law &&
         !scene.profile->piecewise_linear())) {
        profile.reject("geometry",
                       "only power laws and symmetric, piecewise linear slopes are computed as "
                       "axisymmetric contacts",
                       "write kind = \"power-law\" (sphere: m = 1, C = 1/R; cone: m = 0), "
                       "flat-and-rounded, or piecewise with symmetric = true and linear slopes");
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

void require_axis_or_surface(const BodyPoint& point) {
    if (point.x.sign() != 0 && point.z.sign() != 0) {
        throw InputError("the point x = " + point.x.text() + ", z = " + point.z.text() +
                             " is inside the body: the stresses of an axisymmetric contact are "
                             "computed on the axis and on the surface",
                         "give points with x = 0 or z = 0");
    }
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

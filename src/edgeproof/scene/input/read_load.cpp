// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/readers.hpp"

#include <string>
#include <utility>

namespace edgeproof::scene {
namespace {

void check_poisson(const io::TomlSection& load, const char* key, const formula::Exact& nu) {
    if (sign_of(load, key, formula::Exact(nu.expr() + whole(1))) <= 0 ||
        sign_of(load, key, formula::Exact(whole(1) - whole(2) * nu.expr())) < 0) {
        load.reject(key, std::string(key) + " = " + nu.text() + " is no Poisson's ratio",
                    "give -1 < nu <= 1/2");
    }
}

formula::Exact modulus_of_bodies(const io::TomlSection& load, Scene& scene) {
    const auto body = [&](const char* E_key, const char* nu_key) {
        const formula::Exact E = contact_constant(load, E_key);
        const formula::Exact nu = contact_constant(load, nu_key);
        require_positive(load, E_key, E, "give Young's modulus > 0");
        check_poisson(load, nu_key, nu);
        return std::pair{E, nu};
    };
    const auto [E1, nu1] = body("E1", "nu1");
    const auto [E2, nu2] = body("E2", "nu2");
    scene.bodies = Bodies{E1, nu1, E2, nu2};
    return formula::Exact(composite_modulus(E1.expr(), nu1.expr(), E2.expr(), nu2.expr()));
}

formula::Exact read_modulus(const io::TomlSection& load, Scene& scene) {
    const bool by_bodies = load.has("E1") || load.has("nu1") || load.has("E2") || load.has("nu2");
    if (load.has("contact_modulus")) {
        if (by_bodies) {
            load.reject("contact_modulus", "the contact modulus is given twice",
                        "give contact_modulus, or E1, nu1, E2 and nu2");
        }
        formula::Exact modulus = contact_constant(load, "contact_modulus");
        require_positive(load, "contact_modulus", modulus, "give E* > 0");
        if (load.has("nu")) {
            scene.nu = contact_constant(load, "nu");
            check_poisson(load, "nu", *scene.nu);
        }
        return modulus;
    }
    if (load.has("nu")) {
        load.reject("nu", "nu is given in addition to nu1 and nu2",
                    "leave nu out; it belongs to a contact_modulus");
    }
    if (!by_bodies) {
        load.reject(load.line(), "there is no contact_modulus",
                    "add contact_modulus = \"...\" (E*), or E1, nu1, E2 and nu2");
    }
    return modulus_of_bodies(load, scene);
}

} // namespace

void read_load(const io::TomlSection& load, Scene& scene) {
    load.allow(
        {"a", "width", "P", "delta", "M", "contact_modulus", "nu", "E1", "nu1", "E2", "nu2"});
    scene.load_line = load.line();
    scene.contact_modulus = read_modulus(load, scene);
    std::string given;
    for (const char* const key : {"a", "width", "P", "delta"}) {
        if (load.has(key) && !given.empty()) {
            load.reject(key, "both " + given + " and " + key + " are given",
                        "give one of a = \"...\" and P = \"...\"");
        }
        given = load.has(key) ? key : given;
    }
    if (!scene.steps.empty()) {
        if (!given.empty()) {
            load.reject(given, given + " is given in addition to the steps",
                        "leave it out: P of the steps is the load");
        }
        if (load.has("M")) {
            load.reject("M", "M is given in addition to the steps",
                        "leave it out: the tilt alpha is given in [profile], and keeps its value");
        }
        scene.load = contact::Load::force(scene.steps.back().P);
        return;
    }
    if (given.empty()) {
        load.reject(load.line(), "neither a nor P is given",
                    "give one of a = \"...\" and P = \"...\"");
    }
    const formula::Exact value = contact_constant(load, given);
    require_positive(load, given, value, "give " + given + " > 0");
    scene.load = given == "P"       ? contact::Load::force(value)
                 : given == "delta" ? contact::Load::approach(value)
                 : given == "a"
                     ? contact::Load::right_edge(value)
                     : contact::Load::right_edge(formula::Exact(value.expr() / whole(2)));
    scene.load_line = load.line(given);
    if (load.has("M")) {
        if (given != "P") {
            load.reject("M", "a moment M is given with " + given,
                        "give P and M, or a and the tilt alpha in [profile]");
        }
        scene.moment = contact_constant(load, "M");
    }
}

void check_reach(const io::TomlSection& load, const Scene& scene) {
    if (load.has("width") && !scene.symmetric()) {
        load.reject("width",
                    "the width is given, but the edges are at different distances from the origin",
                    "give a (the right edge) or P");
    }
    if (scene.load.kind != contact::Load::Kind::right_edge || !scene.profile ||
        scene.profile->kind() != contact::Profile::Kind::flat_and_rounded) {
        return;
    }
    const formula::Exact& t = scene.profile->parameters().at("t");
    if (sign_of(load, "a", formula::Exact(scene.load.value.expr() - t.expr())) <= 0) {
        load.reject(load.has("a") ? "a" : "width",
                    "the half-width a = " + scene.load.value.text() +
                        " does not reach beyond the flat, t = " + t.text(),
                    "give a > t: under any load the whole flat is in contact");
    }
}

} // namespace edgeproof::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/scene/input/readers.hpp"
#include "edgeproof/scene/input/scene_words.hpp"

#include <array>
#include <string>
#include <utility>

namespace edgeproof::scene {

namespace {

void check_poisson(const io::TomlSection& load, const char* key, const Exact& nu) {
    load.require(sign_of(load, key, Exact(nu.expr() + whole(1))) > 0 &&
                     sign_of(load, key, Exact(whole(1) - whole(2) * nu.expr())) >= 0,
                 key, std::string(key) + " = " + nu.text() + " is no Poisson's ratio",
                 "give -1 < nu <= 1/2");
}

/// `keys`: of E and nu of the one body, then of the other.
Exact modulus_of_bodies(const io::TomlSection& load, const std::array<const char*, 4>& keys,
                        Scene& scene) {
    const auto body = [&](const char* E_key, const char* nu_key) {
        const Exact E = contact_constant(load, E_key);
        const Exact nu = contact_constant(load, nu_key);
        require_positive(load, E_key, E, "give Young's modulus > 0");
        check_poisson(load, nu_key, nu);
        return std::pair{E, nu};
    };
    const auto [E1, nu1] = body(keys[0], keys[1]);
    const auto [E2, nu2] = body(keys[2], keys[3]);
    scene.bodies = Bodies{E1, nu1, E2, nu2};
    return Exact(composite_modulus(E1.expr(), nu1.expr(), E2.expr(), nu2.expr()));
}

Exact read_modulus(const io::TomlSection& load, Scene& scene) {
    if (load.has("E")) {
        for (const char* const key : {"contact_modulus", "E1", "nu1", "E2", "nu2"}) {
            load.require(!load.has(key), "E", std::string("E and ") + key + " are both given",
                         "give E and nu for two equal bodies, or E1, nu1, E2 and nu2, or "
                         "contact_modulus");
        }
        load.require(load.has("nu"), "E", "E is given without nu",
                     "add nu = \"0.3\", Poisson's ratio");
        return modulus_of_bodies(load, {"E", "nu", "E", "nu"}, scene);
    }
    const bool by_bodies = load.has("E1") || load.has("nu1") || load.has("E2") || load.has("nu2");
    if (load.has("contact_modulus")) {
        load.require(!by_bodies, "contact_modulus", "the contact modulus is given twice",
                     "give contact_modulus, or E1, nu1, E2 and nu2");
        Exact modulus = contact_constant(load, "contact_modulus");
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
    load.require(by_bodies, load.line(), "there is no contact_modulus",
                 "add contact_modulus = \"...\" (E*), or E and nu of two equal bodies, or E1, nu1, "
                 "E2 and nu2");
    return modulus_of_bodies(load, {"E1", "nu1", "E2", "nu2"}, scene);
}

void read_friction(const io::TomlSection& shear, ShearSpec& spec, Scene& scene) {
    spec.friction = contact_constant(shear, "friction");
    scene.friction_line = shear.line("friction");
    scene.tension_line = shear.line(shear.has("bulk_tension") ? "bulk_tension" : "friction");
    require_positive(shear, "friction", *spec.friction,
                     "give a coefficient of friction > 0, or leave it out: nothing slips then");
    shear.require(spec.path != contact::LoadingPath::together, "friction",
                  "P and Q grow together: nothing slips as long as |Q| < f P",
                  "leave friction out, or write path = \"normal-first\"");
    shear.require(sign_of(shear, "Q", spec.Q) != 0, "friction",
                  "without a shear force Q the two edges slip in opposite directions, outwards",
                  "give Q that is not zero, or leave friction out: nothing slips then");
    // Slip zones of unequal size under steep flanks need integrals that take too much work.
    if (scene.profile && scene.profile->kind() == Profile::Kind::power_law &&
        spec.bulk_tension.sign() != 0 &&
        is_less(whole(1000), scene.profile->parameters().at("m").expr())) {
        shear.reject("friction", "slip under a bulk tension is not found for an exponent m > 1000",
                     "leave friction or the bulk tension out, or give a lower m");
    }
}

/// q = f p everywhere if body A is pulled to the right, q = -f p if to the left.
void read_sliding(const io::TomlSection& shear, ShearSpec& spec) {
    for (const char* const key : {"Q", "q_ratio", "path"}) {
        shear.require(!shear.has(key), key, std::string(key) + " is given, but the contact slides",
                      std::string("leave ") + key + " out: Q = f P follows; or leave out sliding");
    }
    const std::string direction = shear.text("sliding");
    shear.require(direction == "right" || direction == "left", "sliding",
                  "unknown direction '" + direction + "'",
                  "write right (q = f p on body A) or left (q = -f p)");
    shear.require(shear.has("friction"), "sliding", "sliding is given without friction",
                  "add friction = \"0.3\"");
    const Exact friction = contact_constant(shear, "friction");
    require_positive(shear, "friction", friction,
                     "give a coefficient of friction > 0, or leave [shear] out");
    spec.sliding = direction == "right" ? friction : Exact(-friction.expr());
}

/// Bodies of different materials couple q to p, unless Dundurs' beta is 0: (1 - 2 nu)(1 + nu)/E is
/// the same for both (J. Dundurs, J. Appl. Mech. 36, 650, 1969), decided symbolically.
void check_materials(const io::TomlSection& shear, const ShearSpec& spec, const Scene& scene) {
    if (!scene.bodies) {
        return;
    }
    const auto& [E1, nu1, E2, nu2] = *scene.bodies;
    if (contact::certainly_zero(E1.expr() - E2.expr()) &&
        contact::certainly_zero(nu1.expr() - nu2.expr())) {
        return;
    }
    const auto dilation = [](const Exact& E, const Exact& nu) {
        return (whole(1) - whole(2) * nu.expr()) * (whole(1) + nu.expr()) / E.expr();
    };
    shear.require(contact::certainly_zero(dilation(E1, nu1) - dilation(E2, nu2)), shear.line(),
                  "bodies of different materials couple the shear to the pressure: "
                  "(1 - 2 nu)(1 + nu)/E is not the same in both",
                  "give both bodies the same E and nu, or nu = \"1/2\", or leave [shear] out");
    shear.require(spec.bulk_tension.sign() == 0, "bulk_tension",
                  "a bulk tension strains bodies of different stiffness differently, so that the "
                  "difference of their tensions does not determine the mismatch",
                  "give both bodies the same E and nu, or bulk_tension = \"0\"");
}

/// Q = (Q/(f P)) f P.
Exact force_of_ratio(const io::TomlSection& shear, const Scene& scene) {
    const Load& load = scene.given_load();
    shear.require(!shear.has("Q"), "q_ratio", "q_ratio and Q are both given",
                  "give one of the two");
    shear.require(shear.has("friction") && load.kind == Load::Kind::force, "q_ratio",
                  std::string("q_ratio is given without ") +
                      (shear.has("friction") ? "P" : "friction"),
                  "add friction, and P to [load]: Q is the ratio times f P");
    return Exact(contact_constant(shear, "q_ratio").expr() *
                 contact_constant(shear, "friction").expr() * load.value.expr());
}

[[noreturn]] void refuse_round_shear(const io::TomlSection& section, std::size_t line,
                                     const char* instead) {
    section.reject(
        line,
        "of the shear of axisymmetric contacts only partial slip and sliding without bulk "
        "stresses are computed",
        instead);
}

} // namespace

void read_load(const io::TomlSection& load, Scene& scene) {
    load.allow(keys_of_section("load"));
    scene.load_line = load.line();
    scene.contact_modulus = read_modulus(load, scene);
    std::string given;
    for (const char* const key : {"a", "width", "P", "delta"}) {
        load.require(!load.has(key) || given.empty(), key,
                     "both " + given + " and " + key + " are given",
                     "give one of a = \"...\" and P = \"...\"");
        given = load.has(key) ? key : given;
    }
    if (!scene.steps.empty()) {
        load.require(given.empty(), given, given + " is given in addition to the steps",
                     "leave it out: P of the steps is the load");
        load.require(!load.has("M"), "M", "M is given in addition to the steps",
                     "leave it out: the tilt alpha is given in [profile], and keeps its value");
        scene.load = Load::force(scene.steps.back().P);
        return;
    }
    load.require(!given.empty(), load.line(), "neither a nor P is given",
                 "give one of a = \"...\" and P = \"...\"");
    const Exact value = contact_constant(load, given);
    require_positive(load, given, value, "give " + given + " > 0");
    scene.load = given == "P"       ? Load::force(value)
                 : given == "delta" ? Load::approach(value)
                 : given == "a"     ? Load::right_edge(value)
                                    : Load::right_edge(Exact(value.expr() / whole(2)));
    scene.load_line = load.line(given);
    if (load.has("M")) {
        load.require(given == "P", "M", "a moment M is given with " + given,
                     "give P and M, or a and the tilt alpha in [profile]");
        scene.moment = contact_constant(load, "M");
    }
}

void check_reach(const io::TomlSection& load, const Scene& scene) {
    load.require(!load.has("width") || scene.symmetric(), "width",
                 "the width is given, but the edges are at different distances from the origin",
                 "give a (the right edge) or P");
    if (scene.load.kind != Load::Kind::right_edge || !scene.profile) {
        return;
    }
    const auto knot = scene.profile->flat_end(Edge::right);
    if (!knot) {
        return;
    }
    const Exact& end = scene.profile->knots()[*knot];
    load.require(sign_of(load, "a", Exact(scene.load.value.expr() - end.expr())) > 0,
                 load.has("a") ? "a" : "width",
                 (scene.symmetric() ? "the half-width a = " : "the right edge a = ") +
                     scene.load.value.text() +
                     " does not reach beyond the flat, which ends at x = " + end.text(),
                 "give a > " + end.text() + ": under any load the whole flat is in contact");
}

void read_shear(const io::TomlSection& shear, Scene& scene) {
    shear.allow(keys_of_section("shear"));
    shear.require(shear.has("Q") || shear.has("q_ratio") || shear.has("bulk_tension") ||
                      shear.has("sliding"),
                  shear.line(), "the shear section has no load",
                  "add Q = \"...\" or bulk_tension = \"...\", or leave [shear] out");
    const auto or_zero = [&](const char* key) {
        return shear.has(key) ? contact_constant(shear, key) : Exact();
    };
    ShearSpec spec;
    spec.Q = shear.has("q_ratio") ? force_of_ratio(shear, scene) : or_zero("Q");
    spec.bulk_tension = or_zero("bulk_tension");
    spec.bulk_A = or_zero("bulk_A");
    if (shear.has("sliding")) {
        read_sliding(shear, spec);
    }
    shear.require(spec.sliding || sign_of(shear, "Q", spec.Q) != 0 ||
                      sign_of(shear, "bulk_tension", spec.bulk_tension) != 0,
                  shear.line(), "the shear section has no load: Q and bulk_tension are zero",
                  "give one that is not, or leave [shear] out");
    if (shear.has("path")) {
        const std::string path = shear.text("path");
        if (path == "together") {
            spec.path = contact::LoadingPath::together;
        } else if (path != "normal-first") {
            shear.reject("path", "unknown path '" + path + "'",
                         "write normal-first (P held, then Q) or together (P and Q in proportion)");
        }
    }
    shear.require(spec.path != contact::LoadingPath::together || spec.bulk_tension.sign() == 0,
                  "bulk_tension", "P and Q grow together under a bulk tension",
                  "give bulk_tension = \"0\": only then is q = (Q/P) p");
    if (scene.round &&
        (!shear.has("friction") || spec.bulk_tension.sign() != 0 || spec.bulk_A.sign() != 0)) {
        refuse_round_shear(shear, shear.line(),
                           "give Q and friction without bulk stresses, or leave [shear] out");
    }
    if (shear.has("friction") && !spec.sliding) {
        read_friction(shear, spec, scene);
    }
    check_materials(shear, spec, scene);
    scene.shear = spec;
}

void read_shear_of_steps(const io::TomlSection& top, Scene& scene) {
    for (const LoadStep& step : scene.steps) {
        if (scene.round && step.bulk_tension.sign() != 0) {
            refuse_round_shear(top, step.line, "leave bulk_tension out of the step");
        }
    }
    if (top.has("shear")) {
        const io::TomlSection shear = top.section("shear");
        shear.require(!shear.has("sliding"), "sliding", "sliding is given in addition to the steps",
                      "leave it out: P and Q of the steps determine what slips");
        shear.allow({"friction", "bulk_A"});
        ShearSpec spec;
        spec.bulk_A = shear.has("bulk_A") ? contact_constant(shear, "bulk_A") : spec.bulk_A;
        if (shear.has("friction")) {
            spec.friction = contact_constant(shear, "friction");
            scene.friction_line = scene.tension_line = shear.line("friction");
            require_positive(shear, "friction", *spec.friction,
                             "give a coefficient of friction > 0");
        }
        if (scene.round && spec.bulk_A.sign() != 0) {
            refuse_round_shear(shear, shear.line("bulk_A"), "leave bulk_A out");
        }
        check_materials(shear, spec, scene);
        scene.shear = spec;
    }
}

} // namespace edgeproof::scene

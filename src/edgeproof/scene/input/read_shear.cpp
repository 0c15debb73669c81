// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/enclosure/proved_contact.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <string>

namespace edgeproof::scene {
namespace {

void read_friction(const io::TomlSection& shear, contact::ShearSpec& spec, Scene& scene) {
    spec.friction = contact_constant(shear, "friction");
    scene.friction_line = shear.line("friction");
    scene.tension_line = shear.line(shear.has("bulk_tension") ? "bulk_tension" : "friction");
    require_positive(shear, "friction", *spec.friction,
                     "give a coefficient of friction > 0, or leave it out: nothing slips then");
    if (spec.path == contact::LoadingPath::together) {
        shear.reject("friction", "P and Q grow together: nothing slips as long as |Q| < f P",
                     "leave friction out, or write path = \"normal-first\"");
    }
    if (sign_of(shear, "Q", spec.Q) == 0) {
        shear.reject("friction",
                     "without a shear force Q the two edges slip in opposite directions, outwards",
                     "give Q that is not zero, or leave friction out: nothing slips then");
    }
    // Slip zones of unequal size under steep flanks need integrals that take too much work.
    if (scene.profile && scene.profile->kind() == contact::Profile::Kind::power_law &&
        spec.bulk_tension.sign() != 0 &&
        is_less(whole(1000), scene.profile->parameters().at("m").expr())) {
        shear.reject("friction", "slip under a bulk tension is not found for an exponent m > 1000",
                     "leave friction or the bulk tension out, or give a lower m");
    }
}

/// Bodies of different materials couple q to p, unless Dundurs' beta is 0: (1 - 2 nu)(1 + nu)/E is
/// the same for both (J. Dundurs, J. Appl. Mech. 36, 650, 1969), decided symbolically.
void check_materials(const io::TomlSection& shear, const contact::ShearSpec& spec,
                     const Scene& scene) {
    if (!scene.bodies) {
        return;
    }
    const auto& [E1, nu1, E2, nu2] = *scene.bodies;
    if (contact::certainly_zero(E1.expr() - E2.expr()) &&
        contact::certainly_zero(nu1.expr() - nu2.expr())) {
        return;
    }
    const auto dilation = [](const formula::Exact& E, const formula::Exact& nu) {
        return (whole(1) - whole(2) * nu.expr()) * (whole(1) + nu.expr()) / E.expr();
    };
    if (!contact::certainly_zero(dilation(E1, nu1) - dilation(E2, nu2))) {
        shear.reject(shear.line(),
                     "bodies of different materials couple the shear to the pressure: "
                     "(1 - 2 nu)(1 + nu)/E is not the same in both",
                     "give both bodies the same E and nu, or nu = \"1/2\", or leave [shear] out");
    }
    if (spec.bulk_tension.sign() != 0) {
        shear.reject(
            "bulk_tension",
            "a bulk tension strains bodies of different stiffness differently, so that the "
            "difference of their tensions does not determine the mismatch",
            "give both bodies the same E and nu, or bulk_tension = \"0\"");
    }
}

[[noreturn]] void refuse_round_shear(const io::TomlSection& section, std::size_t line,
                                     const char* instead) {
    section.reject(line, "of the shear of axisymmetric contacts only partial slip is computed",
                   instead);
}

} // namespace

void read_shear(const io::TomlSection& shear, Scene& scene) {
    shear.allow({"Q", "bulk_tension", "bulk_A", "path", "friction"});
    if (!shear.has("Q") && !shear.has("bulk_tension")) {
        shear.reject(shear.line(), "the shear section has no load",
                     "add Q = \"...\" or bulk_tension = \"...\", or leave [shear] out");
    }
    const auto or_zero = [&](const char* key) {
        return shear.has(key) ? contact_constant(shear, key) : formula::Exact();
    };
    contact::ShearSpec spec;
    spec.Q = or_zero("Q");
    spec.bulk_tension = or_zero("bulk_tension");
    spec.bulk_A = or_zero("bulk_A");
    if (sign_of(shear, "Q", spec.Q) == 0 &&
        sign_of(shear, "bulk_tension", spec.bulk_tension) == 0) {
        shear.reject(shear.line(), "the shear section has no load: Q and bulk_tension are zero",
                     "give one that is not, or leave [shear] out");
    }
    if (shear.has("path")) {
        const std::string path = shear.text("path");
        if (path == "together") {
            spec.path = contact::LoadingPath::together;
        } else if (path != "normal-first") {
            shear.reject("path", "unknown path '" + path + "'",
                         "write normal-first (P held, then Q) or together (P and Q in proportion)");
        }
    }
    if (spec.path == contact::LoadingPath::together && spec.bulk_tension.sign() != 0) {
        shear.reject("bulk_tension", "P and Q grow together under a bulk tension",
                     "give bulk_tension = \"0\": only then is q = (Q/P) p");
    }
    if (scene.round &&
        (!shear.has("friction") || spec.bulk_tension.sign() != 0 || spec.bulk_A.sign() != 0)) {
        refuse_round_shear(shear, shear.line(),
                           "give Q and friction without bulk stresses, or leave [shear] out");
    }
    if (shear.has("friction")) {
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
        shear.allow({"friction", "bulk_A"});
        contact::ShearSpec spec;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/file_kind.hpp"
#include "edgeproof/scene/input/read_ask.hpp"
#include "edgeproof/scene/input/read_profile.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::scene {
namespace {

formula::Expr number(long k) { return formula::Expr::number(Rational(k)); }

/// The effect of the materials of the two bodies on the shear.
struct Materials {
    bool alike = true;     ///< both bodies have the same material
    bool uncoupled = true; ///< Dundurs' beta = 0: p and q are uncoupled
};

/// 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2. beta = 0 if (1 - 2 nu_1)(1 + nu_1)/E_1 is the same
/// for both bodies (J. Dundurs, J. Appl. Mech. 36, 650, 1969): decided symbolically.
formula::Exact composite_modulus(const io::TomlSection& load, Materials& materials,
                                 std::optional<Bodies>& bodies) {
    const auto body = [&](const char* E_key, const char* nu_key) {
        const formula::Exact E = contact_constant(load, E_key);
        const formula::Exact nu = contact_constant(load, nu_key);
        if (sign_of(load, E_key, E) <= 0) {
            load.reject(E_key, std::string(E_key) + " = " + E.text() + " is not positive",
                        "give Young's modulus > 0");
        }
        if (sign_of(load, nu_key, formula::Exact(nu.expr() + number(1))) <= 0 ||
            sign_of(load, nu_key, formula::Exact(number(1) - number(2) * nu.expr())) < 0) {
            load.reject(nu_key, std::string(nu_key) + " = " + nu.text() + " is no Poisson's ratio",
                        "give -1 < nu <= 1/2");
        }
        return std::pair{E, nu};
    };
    const auto [E1, nu1] = body("E1", "nu1");
    const auto [E2, nu2] = body("E2", "nu2");
    bodies = Bodies{E1, nu1, E2, nu2};
    materials.alike = contact::certainly_zero(E1.expr() - E2.expr()) &&
                      contact::certainly_zero(nu1.expr() - nu2.expr());
    const auto dilation = [](const formula::Exact& E, const formula::Exact& nu) {
        return (number(1) - number(2) * nu.expr()) * (number(1) + nu.expr()) / E.expr();
    };
    materials.uncoupled =
        materials.alike || contact::certainly_zero(dilation(E1, nu1) - dilation(E2, nu2));
    const auto compliance = [](const formula::Exact& E, const formula::Exact& nu) {
        return (number(1) - nu.expr() * nu.expr()) / E.expr();
    };
    return formula::Exact(number(1) / (compliance(E1, nu1) + compliance(E2, nu2)));
}

formula::Exact read_modulus(const io::TomlSection& load, Materials& materials,
                            std::optional<Bodies>& bodies) {
    const bool by_bodies = load.has("E1") || load.has("nu1") || load.has("E2") || load.has("nu2");
    if (load.has("contact_modulus")) {
        if (by_bodies) {
            load.reject("contact_modulus", "the contact modulus is given twice",
                        "give contact_modulus, or E1, nu1, E2 and nu2");
        }
        formula::Exact modulus = contact_constant(load, "contact_modulus");
        if (sign_of(load, "contact_modulus", modulus) <= 0) {
            load.reject("contact_modulus",
                        "contact_modulus = " + modulus.text() + " is not positive", "give E* > 0");
        }
        return modulus;
    }
    if (!by_bodies) {
        load.reject(load.line(), "there is no contact_modulus",
                    "add contact_modulus = \"...\" (E*), or E1, nu1, E2 and nu2");
    }
    return composite_modulus(load, materials, bodies);
}

void read_load(const io::TomlSection& load, Scene& scene, Materials& materials) {
    load.allow({"a", "width", "P", "M", "contact_modulus", "E1", "nu1", "E2", "nu2"});
    scene.load_line = load.line();
    scene.contact_modulus = read_modulus(load, materials, scene.bodies);
    const char* key = nullptr;
    for (const char* const one : {"a", "width", "P"}) {
        if (load.has(one) && key != nullptr) {
            load.reject(one, std::string("both ") + key + " and " + one + " are given",
                        "give one of a = \"...\" and P = \"...\"");
        }
        key = load.has(one) ? one : key;
    }
    if (key == nullptr) {
        load.reject(load.line(), "neither a nor P is given",
                    "give one of a = \"...\" and P = \"...\"");
    }
    const std::string_view given = key;
    const formula::Exact value = contact_constant(load, key);
    if (sign_of(load, key, value) <= 0) {
        load.reject(key, std::string(key) + " = " + value.text() + " is not positive",
                    std::string("give ") + key + " > 0");
    }
    scene.load = given == "P" ? contact::Load::force(value)
                 : given == "a"
                     ? contact::Load::right_edge(value)
                     : contact::Load::right_edge(formula::Exact(value.expr() / number(2)));
    scene.load_line = load.line(key);
    if (load.has("M")) {
        if (given != "P") {
            load.reject("M", "a moment M is given with " + std::string(given),
                        "give P and M, or a and the tilt alpha in [profile]");
        }
        scene.moment = contact_constant(load, "M");
    }
}

/// A contact that ends on the flat carries no load; half the width is an edge only if b = a.
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

/// Slip zones of unequal size under steep flanks need integrals that take too much work.
void check_exponent_under_tension(const io::TomlSection& shear, const contact::ShearSpec& spec,
                                  const Scene& scene) {
    const formula::Expr most = formula::Expr::number(Rational(1000));
    if (scene.profile && scene.profile->kind() == contact::Profile::Kind::power_law &&
        spec.bulk_tension.sign() != 0 &&
        formula::Exact(most - scene.profile->parameters().at("m").expr()).sign() < 0) {
        shear.reject("friction", "slip under a bulk tension is not found for an exponent m > 1000",
                     "leave friction or the bulk tension out, or give a lower m");
    }
}

void read_friction(const io::TomlSection& shear, contact::ShearSpec& spec, Scene& scene) {
    if (!shear.has("friction")) {
        return;
    }
    spec.friction = contact_constant(shear, "friction");
    scene.friction_line = shear.line("friction");
    scene.tension_line = shear.line(shear.has("bulk_tension") ? "bulk_tension" : "friction");
    if (sign_of(shear, "friction", *spec.friction) <= 0) {
        shear.reject("friction", "friction = " + spec.friction->text() + " is not positive",
                     "give a coefficient of friction > 0, or leave it out: nothing slips then");
    }
    if (spec.path == contact::LoadingPath::together) {
        shear.reject("friction", "P and Q grow together: nothing slips as long as |Q| < f P",
                     "leave friction out, or write path = \"normal-first\"");
    }
    if (sign_of(shear, "Q", spec.Q) == 0) {
        shear.reject("friction",
                     "without a shear force Q the two edges slip in opposite directions, outwards",
                     "give Q that is not zero, or leave friction out: nothing slips then");
    }
}

void read_shear(const io::TomlSection& shear, const Materials& materials, Scene& scene) {
    shear.allow({"Q", "bulk_tension", "path", "friction"});
    if (!shear.has("Q") && !shear.has("bulk_tension")) {
        shear.reject(shear.line(), "the shear section has no load",
                     "add Q = \"...\" or bulk_tension = \"...\", or leave [shear] out");
    }
    contact::ShearSpec spec;
    spec.Q = shear.has("Q") ? contact_constant(shear, "Q") : formula::Exact();
    spec.bulk_tension =
        shear.has("bulk_tension") ? contact_constant(shear, "bulk_tension") : formula::Exact();
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
    read_friction(shear, spec, scene);
    if (spec.friction) {
        check_exponent_under_tension(shear, spec, scene);
    }
    if (!materials.uncoupled) {
        shear.reject(shear.line(),
                     "bodies of different materials couple the shear to the pressure: "
                     "(1 - 2 nu)(1 + nu)/E is not the same in both",
                     "give both bodies the same E and nu, or nu = \"1/2\", or leave [shear] out");
    }
    if (!materials.alike && spec.bulk_tension.sign() != 0) {
        shear.reject(
            "bulk_tension",
            "a bulk tension strains bodies of different stiffness differently, so that the "
            "difference of their tensions does not determine the mismatch",
            "give both bodies the same E and nu, or bulk_tension = \"0\"");
    }
    scene.shear = spec;
}

void read_sections(const io::TomlSection& top, Scene& scene) {
    Materials materials;
    if (top.has("units")) {
        scene.units = read_units(top.section("units"));
    }
    const io::TomlSection load = top.section("load");
    const auto reading = [&](const io::TomlSection& section, const auto& read) {
        io::at_place(section.file(), section.line(), [&] { read(section); });
    };
    reading(load, [&](const io::TomlSection& s) { read_load(s, scene, materials); });
    reading(top.section("profile"),
            [&](const io::TomlSection& s) { read_profile(s, scene.moment.has_value(), scene); });
    reading(load, [&](const io::TomlSection& s) { check_reach(s, scene); });
    if (top.has("shear")) {
        reading(top.section("shear"),
                [&](const io::TomlSection& s) { read_shear(s, materials, scene); });
    }
}

/// Errors in an [ask] given on the command line, and errors of its points, have no line numbers.
void read_asked_instead(const std::vector<io::TomlEntry>& asked, const io::TomlSection& profile,
                        Scene& scene) {
    const std::vector<AskedPoint> points = std::exchange(scene.ask.u, {});
    const std::size_t line = scene.ask_line;
    try {
        read_ask(io::TomlSection::made({{"ask", 0, asked}}, "").section("ask"), profile, scene);
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead());
    }
    scene.ask_line = scene.ask.u.empty() ? line : 0;
    if (scene.ask.u.empty()) {
        scene.ask.u = points;
    }
    for (AskedPoint& point : scene.ask.u) {
        point.line = scene.ask_line == 0 ? 0 : point.line;
    }
}

} // namespace

Scene read_contact(const io::TomlSection& top) {
    Scene scene;
    scene.file = top.file();
    read_sections(top, scene);
    return scene;
}

Scene scene_of(const io::TomlSection& top, const std::vector<io::TomlEntry>& asked) {
    expect_file_kind(top, FileKind::scene);
    top.allow({"title", "units", "profile", "load", "shear", "ask"});
    Scene scene;
    scene.file = top.file();
    if (top.has("title")) {
        scene.title = top.text("title");
    }
    read_sections(top, scene);
    if (top.has("ask")) {
        const io::TomlSection ask = top.section("ask");
        const io::TomlSection profile = top.section("profile");
        io::at_place(ask.file(), ask.line(), [&] { read_ask(ask, profile, scene); });
    }
    if (!asked.empty()) {
        read_asked_instead(asked, top.section("profile"), scene);
    }
    default_quantities(scene.ask, scene.shear.has_value(), scene.slips());
    return scene;
}

Scene parse_scene(std::string_view text, const std::string& file,
                  const std::vector<io::TomlEntry>& asked) {
    return scene_of(io::TomlSection::parse(text, file), asked);
}

Scene read_scene(const std::filesystem::path& file, const std::vector<io::TomlEntry>& asked) {
    return parse_scene(io::read_text(file, "scene (TOML)", io::most_toml_bytes),
                       io::input_name(file), asked);
}

namespace {

constexpr int shown_digits = 8;

} // namespace

void refuse_sliding(const Scene& scene, const Real& force) {
    const contact::ShearSpec& shear = *scene.shear;
    const Real most = force * shear.friction->to<Real>();
    throw InputError("the contact slides: Q = " + shear.Q.text() +
                         ", but f P = " + most.str(shown_digits),
                     "give a smaller Q, or a greater friction, so that |Q| < f P")
        .at(scene.file, scene.friction_line);
}

void refuse_tension(const Scene& scene, contact::Edge edge, bool reached, const Real& least,
                    const Real& most) {
    throw InputError("bulk_tension = " + scene.shear->bulk_tension.text() +
                         " moves the stick zone " + (reached ? "to the " : "beyond the ") +
                         edge_name(edge) +
                         (reached ? " edge to within all digits, so that nothing slips there"
                                  : " edge, which would slip in the direction opposite to Q"),
                     "give a bulk_tension between " + least.str(shown_digits) + " and " +
                         most.str(shown_digits) + ", the bounds for this Q")
        .at(scene.file, scene.tension_line);
}

} // namespace edgeproof::scene

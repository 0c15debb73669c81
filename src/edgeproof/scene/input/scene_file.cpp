// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/file_kind.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <array>
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

constexpr long most_cycles = 1000;

/// What a step leaves out keeps its value; the contact begins unloaded. `cycles` in a step is the
/// number of times that the steps from this one to the last are gone through.
void read_steps(const io::TomlSection& top, Scene& scene) {
    const std::vector<io::TomlSection> sections = top.sections_or_none("step");
    std::size_t first = sections.size(); // the step with `cycles`
    std::size_t cycles = 1;
    LoadStep now;
    const auto read = [&](const io::TomlSection& section) {
        for (const auto& [key, member] :
             {std::pair{"P", &LoadStep::P}, std::pair{"Q", &LoadStep::Q},
              std::pair{"bulk_tension", &LoadStep::bulk_tension}}) {
            if (section.has(key)) {
                now.*member = contact_constant(section, key);
                (void)sign_of(section, key, now.*member);
            }
        }
        now.line = section.line();
        scene.steps.push_back(now);
    };
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const io::TomlSection& section = sections[i];
        section.allow({"P", "Q", "bulk_tension", "cycles"});
        if (section.has("cycles")) {
            if (first < i) {
                section.reject("cycles", "cycles is given in two steps", "give it in one");
            }
            first = i;
            cycles = section.count("cycles", 1, most_cycles);
        }
        read(section);
    }
    scene.pass = sections.size() - first;
    for (std::size_t k = 1; k < cycles; ++k) {
        std::for_each(sections.begin() + static_cast<std::ptrdiff_t>(first), sections.end(), read);
    }
}

/// [shear] of a scene with steps: the friction, and bulk_A.
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
    set_step(scene, scene.steps.size());
}

void read_sections(const io::TomlSection& top, Scene& scene) {
    read_steps(top, scene);
    if (top.has("units")) {
        scene.units = read_units(top.section("units"));
    }
    const io::TomlSection load = top.section("load");
    const auto reading = [&](const io::TomlSection& section, const auto& read) {
        io::at_place(section.file(), section.line(), [&] { read(section, scene); });
    };
    reading(load, read_load);
    reading(top.section("profile"), [](const io::TomlSection& profile, Scene& s) {
        read_profile(profile, s.moment.has_value(), s);
    });
    const io::TomlSection profile = top.section("profile");
    if (is_axisymmetric(profile)) {
        reading(profile, [](const io::TomlSection& section, Scene& s) {
            require_axisymmetric(section, s);
            revolve(s);
        });
    } else if (load.has("delta")) {
        load.reject("delta", "the approach delta of a plane contact is undetermined",
                    "give a or P, or write geometry = \"axisymmetric\" in [profile]");
    }
    reading(load, check_reach);
    if (!scene.steps.empty()) {
        read_shear_of_steps(top, scene);
    } else if (top.has("shear")) {
        reading(top.section("shear"), read_shear);
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
    top.allow({"title", "units", "profile", "load", "shear", "step", "ask"});
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

std::string toml_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
    return out + "\"";
}

std::vector<std::string> texts_of(const io::TomlEntry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) {
        return {*text};
    }
    const auto* list = std::get_if<std::vector<std::string>>(&entry.value);
    return list != nullptr ? *list : std::vector<std::string>();
}

/// Refuses control characters, tab and newline included.
void check_characters(const std::string& key, const std::string& text) {
    if (std::any_of(text.begin(), text.end(),
                    [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; })) {
        throw InputError(key + " holds a control character", "write a number or a word");
    }
}

std::string toml_entry(const io::TomlEntry& entry) {
    if (const auto* yes = std::get_if<bool>(&entry.value)) {
        return *yes ? "true" : "false";
    }
    std::string list;
    for (const std::string& text : texts_of(entry)) {
        list += (list.empty() ? "" : ", ") + toml_string(text);
    }
    return std::holds_alternative<std::string>(entry.value) ? list : "[" + list + "]";
}

std::array<std::pair<const char*, const SceneEntries::Section*>, 4>
sections_of(const SceneEntries& entries) {
    return {{{"profile", &entries.profile},
             {"load", &entries.load},
             {"shear", &entries.shear},
             {"ask", &entries.ask}}};
}

constexpr int shown_digits = 8;

} // namespace

std::string scene_text(const SceneEntries& entries) {
    std::string text;
    if (!entries.title.empty()) {
        text += "title = " + toml_string(entries.title) + "\n";
    }
    for (const auto& [name, section] : sections_of(entries)) {
        if (section->empty()) {
            continue;
        }
        text += std::string(text.empty() ? "" : "\n") + "[" + name + "]\n";
        for (const io::TomlEntry& entry : *section) {
            text += entry.key + " = " + toml_entry(entry) + "\n";
        }
    }
    return text;
}

Scene make_scene(const SceneEntries& entries) {
    check_characters("title", entries.title);
    std::vector<io::TomlTable> tables;
    for (const auto& [name, section] : sections_of(entries)) {
        for (const io::TomlEntry& entry : *section) {
            for (const std::string& text : texts_of(entry)) {
                check_characters(entry.key, text);
            }
        }
        if (!section->empty()) {
            tables.push_back({name, 0, *section});
        }
    }
    try {
        Scene scene = scene_of(io::TomlSection::made(tables, ""));
        scene.title = entries.title;
        return scene;
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()); // without the line 0
    }
}

void set_step(Scene& scene, std::size_t count) {
    const LoadStep& last = scene.steps.at(count - 1);
    const auto none = [](const LoadStep& step) {
        return step.Q.sign() == 0 && step.bulk_tension.sign() == 0;
    };
    const auto reject = [&](const std::string& problem, const std::string& instead) {
        throw InputError("step " + std::to_string(count) + ": " + problem, instead)
            .at(scene.file, last.line);
    };
    scene.load_line = last.line;
    scene.history.reset();
    if (last.P.sign() <= 0) {
        reject("there is no contact: P = " + last.P.text(), "give P > 0");
    }
    change_given(scene, [&](Scene& s) { s.load = contact::Load::force(last.P); });
    const auto begin = scene.steps.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    if (std::all_of(begin, end, none)) {
        if (scene.shear && scene.shear->bulk_A.sign() != 0) {
            reject("bulk_A is given, but no shear load", "leave bulk_A out, or add Q to a step");
        }
        scene.shear.reset();
        scene.ask.quantities.erase(QuantityGroup::shear);
        scene.ask.quantities.erase(QuantityGroup::slip);
        return;
    }
    if (!scene.shear || !scene.shear->friction) {
        reject("a shear load of a history needs a friction", "add [shear] with friction = \"0.6\"");
    }
    scene.shear->Q = last.Q;
    scene.shear->bulk_tension = last.bulk_tension;
    if (std::any_of(begin, end, [](const LoadStep& s) { return s.bulk_tension.sign() != 0; })) {
        const bool once = count > 1 && std::all_of(begin, end - 1, none) &&
                          formula::Exact(last.P.expr() - (end - 2)->P.expr()).sign() == 0;
        if (!once || last.Q.sign() == 0) {
            reject("a bulk tension is computed only where it is applied once, together with Q, in "
                   "the last step and at constant P: the zones of slip that it changes are no "
                   "superposition",
                   "apply P first, then Q and bulk_tension in one step, and ask for the state "
                   "after it");
        }
        return;
    }
    scene.history =
        history_after(scene.steps, count, scene.pass, *scene.shear->friction, scene.file);
}

void require_no_history(const Scene& scene, const std::string& command) {
    if (!scene.steps.empty()) {
        throw InputError(command + " computes no load histories",
                         "give P and Q in [load] and [shear] instead of steps")
            .at(scene.file, scene.steps.front().line);
    }
}

void require_plane(const Scene& scene, const std::string& command) {
    require_no_history(scene, command);
    if (scene.round) {
        throw InputError(command + " computes plane contacts only",
                         "leave geometry out of [profile], or use edgeproof pressure, expand or "
                         "extent")
            .at(scene.file, scene.profile_line);
    }
}

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

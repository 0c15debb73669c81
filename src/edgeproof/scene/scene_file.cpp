// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/scene_file.hpp"

#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml_limits.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/scene/file_kind.hpp"
#include "edgeproof/scene/points.hpp"
#include "edgeproof/scene/read_profile.hpp"

#include <algorithm>
#include <array>

namespace edgeproof::scene {
namespace {

constexpr long most_terms_allowed = 400;
constexpr long most_digits = 100'000;

formula::Expr number(long k) { return formula::Expr::number(Rational(k)); }

/// The sign of the value of a key, or of what follows from it.
int sign_of(const io::TomlSection& section, std::string_view key, const formula::Exact& value) {
    return io::at_place(
        section.file(), section.line(key), [&] { return value.sign(); },
        "write " + std::string(key) + " as a simpler number, or 0 where it is zero");
}

/// How the materials of the two bodies bear on the shear.
struct Materials {
    bool alike = true; ///< one material
    bool uncoupled =
        true; ///< Dundurs' beta = 0: shear does not part the surfaces, nor p shear them
};

/// 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2. beta = 0 where (1 - 2 nu_1)(1 + nu_1)/E_1 is that of
/// the other body (J. Dundurs, J. Appl. Mech. 36, 650, 1969): decided by symbols.
formula::Exact composite_modulus(const io::TomlSection& load, Materials& materials) {
    const auto body = [&](const char* E_key, const char* nu_key) {
        const formula::Exact E = load.exact(E_key);
        const formula::Exact nu = load.exact(nu_key);
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

formula::Exact read_modulus(const io::TomlSection& load, Materials& materials) {
    const bool by_bodies = load.has("E1") || load.has("nu1") || load.has("E2") || load.has("nu2");
    if (load.has("contact_modulus")) {
        if (by_bodies) {
            load.reject("contact_modulus", "the contact modulus is given twice",
                        "give contact_modulus, or E1, nu1, E2 and nu2");
        }
        formula::Exact modulus = load.exact("contact_modulus");
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
    return composite_modulus(load, materials);
}

void read_load(const io::TomlSection& load, Scene& scene, Materials& materials) {
    load.allow({"a", "P", "M", "contact_modulus", "E1", "nu1", "E2", "nu2"});
    scene.load_line = load.line();
    scene.contact_modulus = read_modulus(load, materials);
    if (load.has("a") == load.has("P")) {
        load.reject(load.has("a") ? load.line("P") : load.line(),
                    load.has("a") ? "both a and P are given" : "neither a nor P is given",
                    "give one of a = \"...\" and P = \"...\"");
    }
    const char* key = load.has("a") ? "a" : "P";
    const formula::Exact value = load.exact(key);
    if (sign_of(load, key, value) <= 0) {
        load.reject(key, std::string(key) + " = " + value.text() + " is not positive",
                    std::string("give ") + key + " > 0");
    }
    scene.load = load.has("a") ? contact::Load::right_edge(value) : contact::Load::force(value);
    scene.load_line = load.line(key);
    if (load.has("M")) {
        if (load.has("a")) {
            load.reject("M", "a moment M is given with a",
                        "give P and M, or a and the tilt alpha in [profile]");
        }
        scene.moment = load.exact("M");
    }
}

/// A contact that ends on the flat carries no load.
void check_reach(const io::TomlSection& load, const Scene& scene) {
    if (scene.load.kind != contact::Load::Kind::right_edge || !scene.profile ||
        scene.profile->kind() != contact::Profile::Kind::flat_and_rounded) {
        return;
    }
    const formula::Exact& t = scene.profile->parameters().at("t");
    if (sign_of(load, "a", formula::Exact(scene.load.value.expr() - t.expr())) <= 0) {
        load.reject("a",
                    "the half-width a = " + scene.load.value.text() +
                        " does not reach beyond the flat, t = " + t.text(),
                    "give a > t: any load at all takes in the whole flat");
    }
}

void read_shear(const io::TomlSection& shear, const Materials& materials, Scene& scene) {
    shear.allow({"Q", "bulk_tension", "path"});
    if (!shear.has("Q") && !shear.has("bulk_tension")) {
        shear.reject(shear.line(), "the shear section has no load",
                     "add Q = \"...\" or bulk_tension = \"...\", or leave [shear] out");
    }
    contact::ShearSpec spec;
    spec.Q = shear.has("Q") ? shear.exact("Q") : formula::Exact();
    spec.bulk_tension = shear.has("bulk_tension") ? shear.exact("bulk_tension") : formula::Exact();
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
            "difference of their tensions does not tell the mismatch",
            "give both bodies the same E and nu, or bulk_tension = \"0\"");
    }
    scene.shear = spec;
}

Quantity quantity_of(const io::TomlSection& ask, const std::string& name) {
    if (const auto quantity = quantity_named(name)) {
        return *quantity;
    }
    static constexpr std::array<std::string_view, 5> names{"pressure", "coefficients", "shear",
                                                           "extent", "contact"};
    ask.reject("quantities", "unknown quantity '" + name + "'", one_of(name, names));
}

/// What f refuses, told with the line of a key.
template <class F> auto at_key(const io::TomlSection& ask, std::string_view key, const F& f) {
    return io::at_place(ask.file(), ask.line(key), f);
}

std::vector<AskedPoint> read_points(const io::TomlSection& ask) {
    std::vector<AskedPoint> points;
    if (!ask.is_table("u")) {
        for (const auto& item : ask.exacts("u")) {
            if (sign_of(ask, "u", item.value) <= 0) {
                ask.reject(item.line, "u = " + item.value.text() + " is not inside the contact",
                           "give distances from the edge, 0 < u < a + b");
            }
            points.push_back({item.value, item.line});
        }
        return points;
    }
    const io::TomlSection range = ask.section("u");
    range.allow({"from", "to", "per_decade", "points"});
    const std::size_t line = ask.line("u");
    if (range.has("per_decade") == range.has("points")) {
        ask.reject(line, "a range of u needs one of per_decade and points",
                   "write u = { from = \"1e-12\", to = \"0.9\", per_decade = 5 }");
    }
    at_key(ask, "u", [&] {
        const formula::Exact from = range.exact("from");
        const formula::Exact to = range.exact("to");
        if (sign_of(range, "from", from) <= 0) {
            ask.reject(line, "u = " + from.text() + " is not inside the contact",
                       "give distances from the edge, 0 < u < a + b");
        }
        const auto list = range.has("per_decade")
                              ? geometric_points(from, to, range.count("per_decade", 1, 10'000))
                              : even_points(from, to, range.count("points", 2, 100'000));
        for (const formula::Exact& u : list) {
            points.push_back({u, line});
        }
    });
    return points;
}

void read_edges(const io::TomlSection& ask, Ask& result) {
    result.edges.clear();
    for (const std::string& name : ask.texts("edges")) {
        if (name != "right" && name != "left") {
            ask.reject("edges", "there is no edge '" + name + "'", "write \"right\" or \"left\"");
        }
        const contact::Edge edge =
            name == edge_name(contact::Edge::right) ? contact::Edge::right : contact::Edge::left;
        if (std::find(result.edges.begin(), result.edges.end(), edge) != result.edges.end()) {
            ask.reject("edges", "the edge '" + name + "' is asked for twice", "name each once");
        }
        result.edges.push_back(edge);
    }
    if (result.edges.empty()) {
        ask.reject("edges", "no edge is asked for", "write \"right\" or \"left\"");
    }
}

contact::Route route_of(const io::TomlSection& ask) {
    const std::string name = ask.text("route");
    for (const contact::Route route :
         {contact::Route::automatic, contact::Route::closed_form, contact::Route::singular_integral,
          contact::Route::barber_mossakovskii}) {
        if (name == route_name(route)) {
            return route;
        }
    }
    static constexpr std::array<std::string_view, 4> names{
        "automatic", "closed-form", "singular-integral", "barber-mossakovskii"};
    ask.reject("route", "unknown route '" + name + "'", one_of(name, names));
}

void read_ask(const io::TomlSection& ask, Scene& scene) {
    ask.allow({"edges", "terms", "u", "quantities", "tolerance", "process_zone", "part", "route",
               "digits"});
    Ask& result = scene.ask;
    scene.ask_line = ask.line();
    if (ask.has("edges")) {
        read_edges(ask, result);
    }
    if (ask.has("terms")) {
        result.terms = ask.counts("terms", 1, most_terms_allowed);
    }
    if (ask.has("digits")) {
        result.digits.count = static_cast<unsigned>(ask.count("digits", 2, most_digits));
    }
    if (ask.has("u")) {
        result.u = read_points(ask);
    }
    if (ask.has("tolerance")) {
        result.tolerance =
            at_key(ask, "tolerance", [&] { return parse_tolerance(ask.written("tolerance")); });
    }
    if (ask.has("process_zone")) {
        const formula::Exact zone = ask.exact("process_zone");
        if (sign_of(ask, "process_zone", zone) <= 0) {
            ask.reject("process_zone", "process_zone = " + zone.text() + " is not positive",
                       "give the length of the process zone, or leave it out");
        }
        result.process_zone = zone;
    }
    if (ask.has("part")) {
        const auto part = ask.exacts("part");
        if (part.size() != 2 || sign_of(ask, "part", part[0].value) < 0 ||
            sign_of(ask, "part", formula::Exact(part[1].value.expr() - part[0].value.expr())) <=
                0 ||
            sign_of(ask, "part", formula::Exact(number(1) - part[1].value.expr())) < 0) {
            ask.reject("part", "the part of the contact does not ascend within 0 ... 1",
                       "write part = [\"0\", \"1/2\"], fractions of a + b from the edge");
        }
        if (result.process_zone && part[0].value.sign() != 0) {
            ask.reject("part", "a process zone begins at the edge, and this part does not",
                       "write part = [\"0\", \"...\"], or leave process_zone out");
        }
        result.part = {part[0].value, part[1].value};
    }
    if (ask.has("route")) {
        result.route = route_of(ask);
        if (result.route == contact::Route::closed_form && scene.profile &&
            !contact::BallContact::has_closed_form(*scene.profile)) {
            ask.reject("route",
                       "only a power law or a piecewise linear g' has its pressure in closed form",
                       "write route = \"automatic\"");
        }
    }
    if (ask.has("quantities")) {
        for (const std::string& name : ask.texts("quantities")) {
            const Quantity quantity = quantity_of(ask, name);
            if (quantity == Quantity::shear && !scene.shear) {
                ask.reject("quantities", "shear is asked for and there is no [shear]",
                           "add [shear] with Q or bulk_tension");
            }
            result.quantities.insert(quantity);
        }
    }
}

/// What a scene that does not name its quantities asks for: whatever it gives the means for.
void default_quantities(Ask& ask, bool shear) {
    if (!ask.quantities.empty()) {
        return;
    }
    if (!ask.u.empty()) {
        ask.quantities.insert(Quantity::pressure);
        if (shear) {
            ask.quantities.insert(Quantity::shear);
        }
    }
    if (ask.tolerance) {
        ask.quantities.insert(Quantity::extent);
    }
    if (ask.quantities.empty()) {
        ask.quantities.insert(Quantity::coefficients);
    }
}

} // namespace

std::string quantity_name(Quantity quantity) {
    switch (quantity) {
    case Quantity::pressure:
        return "pressure";
    case Quantity::coefficients:
        return "coefficients";
    case Quantity::shear:
        return "shear";
    case Quantity::extent:
        return "extent";
    case Quantity::contact:
        break;
    }
    return "contact";
}

std::optional<Quantity> quantity_named(std::string_view name) {
    for (const Quantity q : {Quantity::pressure, Quantity::coefficients, Quantity::shear,
                             Quantity::extent, Quantity::contact}) {
        if (name == quantity_name(q)) {
            return q;
        }
    }
    return {};
}

std::string edge_name(contact::Edge edge) {
    return edge == contact::Edge::right ? "right" : "left";
}

std::size_t Ask::most_terms() const {
    return terms.empty() ? 0 : *std::max_element(terms.begin(), terms.end());
}

formula::Exact parse_tolerance(std::string_view text) {
    const bool percent = !text.empty() && text.back() == '%';
    const formula::Exact given = [&] {
        try {
            return formula::Exact::parse(percent ? text.substr(0, text.size() - 1) : text);
        } catch (const InputError& error) {
            throw InputError("tolerance \"" + std::string(text) + "\": " + error.problem(),
                             "write it as 1%, 0.01 or 1/100");
        }
    }();
    if (given.sign() <= 0) {
        throw InputError("a tolerance of " + std::string(text) + " is not positive",
                         "give a tolerance > 0, such as 1%");
    }
    return percent ? formula::Exact(given.expr() / number(100)) : given;
}

Scene parse_scene(std::string_view text, const std::string& file) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    expect_file_kind(top, FileKind::scene);
    top.allow({"title", "profile", "load", "shear", "ask"});
    Scene scene;
    scene.file = file;
    if (top.has("title")) {
        scene.title = top.text("title");
    }
    Materials materials;
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
    if (top.has("ask")) {
        reading(top.section("ask"), [&](const io::TomlSection& s) { read_ask(s, scene); });
    }
    default_quantities(scene.ask, scene.shear.has_value());
    return scene;
}

Scene read_scene(const std::filesystem::path& file) {
    return parse_scene(io::read_text(file, "scene (TOML)", io::most_toml_bytes), file.string());
}

} // namespace edgeproof::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/axisymmetric/axisymmetric_contact.hpp"
#include "edgeproof/formula/exact/exact.hpp"
#include "edgeproof/formula/parse.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <string>

namespace edgeproof::scene {

namespace {

/// Two cylinders or spheres, or one on a flat: g' = x/R with 1/R = 1/R1 + 1/R2 (`johnson1985`,
/// section 4.2). A negative radius is that of a hollow; the sum of the curvatures must be positive.
Profile read_round_bodies(const io::TomlSection& section, std::vector<std::string_view> keys,
                          std::optional<Radii>& radii) {
    const bool two = keys.size() > 1;
    keys.insert(keys.begin(), {"kind", "geometry"});
    section.allow(keys);
    const auto curvature = [&](std::string_view key) {
        const Exact R = contact_constant(section, key);
        if (io::at_place(section.file(), section.line(key), [&] { return R.sign(); }) == 0) {
            section.reject(key, std::string(key) + " is zero",
                           "give a radius; a flat body is left out");
        }
        return whole(1) / R.expr();
    };
    const bool pair = section.has("R1") || section.has("R2");
    const char* const first = !pair ? "R" : section.has("R1") ? "R1" : "R2";
    if (section.has("R") && pair) {
        section.reject("R", "the radius is given twice",
                       "give R, or R1 and R2 (one of them alone where the other body is flat)");
    }
    if (!section.has("R") && !pair) {
        section.reject(section.line(), "there is no radius",
                       two ? "add R = \"...\", or R1 and R2 of the two bodies" : "add R = \"...\"");
    }
    Expr sum = curvature(first);
    if (section.has("R1") && section.has("R2")) {
        sum = sum + curvature("R2");
        radii = Radii{contact_constant(section, "R1"), contact_constant(section, "R2")};
    }
    const Exact C(sum);
    if (io::at_place(section.file(), section.line(first), [&] { return C.sign(); }) <= 0) {
        section.reject(
            first, "the bodies do not separate outside the contact: 1/R1 + 1/R2 is not positive",
            "give a positive radius, or a hollow with a larger radius than the body in it");
    }
    return Profile::power_law(C, Exact(whole(1)));
}

/// Runs a maker; its errors get the line of the parameter that they name.
template <class Make>
auto located(const io::TomlSection& section, const std::vector<std::string_view>& parameters,
             const Make& make) {
    try {
        return make();
    } catch (const Error& error) {
        const auto* input = dynamic_cast<const InputError*>(&error);
        if (input != nullptr && !input->file().empty()) {
            throw;
        }
        const std::string problem = input != nullptr ? input->problem() : error.what();
        // The parameter that the message names first is at fault.
        std::size_t line = section.line();
        std::size_t first = std::string::npos;
        for (const std::string_view key : parameters) {
            const std::size_t named = problem.find(std::string(key) + " = ");
            if (section.has(key) && named < first) {
                first = named;
                line = section.line(key);
            }
        }
        io::rethrow_at(section.file(), line);
    }
}

Profile read_piecewise(const io::TomlSection& section) {
    section.allow({"kind", "geometry", "knots", "slopes", "symmetric"});
    const bool symmetric = section.has("symmetric") && section.flag("symmetric");
    std::vector<Exact> knots;
    if (section.has("knots")) {
        for (const auto& item : section.exacts("knots")) {
            check_size(section, "knots", item.value.expr(), item.value.text());
            knots.push_back(item.value);
        }
    }
    std::vector<Expr> slopes;
    for (const std::string& text : section.texts("slopes")) {
        try {
            slopes.push_back(parse(text, formula::Symbols{"x"}));
        } catch (const InputError& error) {
            throw InputError("slope \"" + text + "\": " + error.problem(), error.instead())
                .at(section.file(), section.line("slopes"));
        }
        check_size(section, "slopes", slopes.back(), text);
    }
    return located(section, {}, [&] {
        return symmetric ? Profile::piecewise_symmetric(knots, slopes)
                         : Profile::piecewise(knots, slopes);
    });
}

using Get = std::function<Exact(std::string_view key)>;

/// A wedge, or a cone: g' = phi.
Profile wedge(const Get& get) {
    const Exact phi = get("phi");
    require(phi.sign() > 0, "the slope phi = " + phi.text() + " is not positive", "give phi > 0");
    return Profile::power_law(phi, Exact(whole(0)));
}

/// A kind of profile with its numbers; without `profile` it has a reader of its own.
struct ProfileKind {
    std::string_view name;
    std::vector<std::string_view> parameters;
    Profile (*profile)(const Get&) = nullptr;
    contact::TiltedPunch (*punch)(const Get&) = nullptr; ///< if the tilt can be solved for
};

const std::vector<ProfileKind>& all_kinds() {
    static const std::vector<ProfileKind> kinds{
        {"power-law",
         {"m", "C"},
         [](const Get& get) { return Profile::power_law(get("C"), get("m")); }},
        {"hertz", {"R", "R1", "R2"}},
        {"cylinder-on-flat", {"R"}},
        {"sphere", {"R", "R1", "R2"}},
        {"wedge", {"phi"}, wedge},
        {"cone", {"phi"}, wedge},
        {"flat-and-rounded",
         {"t", "R"},
         [](const Get& get) { return Profile::flat_and_rounded(get("t"), get("R")); }},
        {"tilted-wedge",
         {"phi", "alpha"},
         [](const Get& get) { return Profile::tilted_wedge(get("phi"), get("alpha")); },
         [](const Get& get) { return contact::TiltedPunch::wedge(get("phi")); }},
        {"tilted-flat-and-rounded",
         {"alpha", "t", "R"},
         [](const Get& get) {
             return Profile::tilted_flat_and_rounded(get("alpha"), get("t"), get("R"));
         },
         [](const Get& get) { return contact::TiltedPunch::flat_and_rounded(get("t"), get("R")); }},
        {"piecewise", {}},
    };
    return kinds;
}

/// The tilt is given, or it is solved for; other profiles have none.
void check_tilt(const io::TomlSection& section, const std::string& kind, bool tilted,
                bool tilt_unknown) {
    section.require(!tilted || !tilt_unknown || !section.has("alpha"), "alpha",
                    "both the tilt alpha and the moment M are given",
                    "give alpha with a or P, or P and M without alpha");
    section.require(!tilted || tilt_unknown || section.has("alpha"), section.line(),
                    "there is no tilt alpha",
                    "add alpha = \"...\", or give P and M in [load] so that it is solved for");
    section.require(tilted || !tilt_unknown, "kind",
                    "a moment M is given, and a " + kind + " profile has no tilt",
                    "leave M out, or take a tilted-wedge or tilted-flat-and-rounded profile");
}

} // namespace

/// Below this range, the pressure at the apex agrees with that of a wedge to more digits than any
/// search can resolve; above it, the flanks are practically vertical.
void check_exponent(const io::TomlSection& section) {
    static const Expr least = Expr::number(parse_decimal("1e-10"));
    const Exact m = section.has("m") ? section.exact("m") : Exact();
    if (m.sign() > 0 && (is_less(m.expr(), least) || is_less(whole(1'000'000), m.expr()))) {
        section.reject("m", "the power-law exponent m = " + m.text() + " is out of range",
                       "give 0 (a wedge), or a number from 1e-10 to 1000000");
    }
}

const std::vector<std::string_view>& profile_kinds() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        std::ranges::transform(all_kinds(), std::back_inserter(all), &ProfileKind::name);
        return all;
    }();
    return names;
}

std::vector<std::string_view> keys_of_profile(std::string_view kind) {
    const auto row = std::ranges::find(all_kinds(), kind, &ProfileKind::name);
    std::vector<std::string_view> keys =
        row != all_kinds().end() ? row->parameters : std::vector<std::string_view>();
    if (kind == "flat-and-rounded") {
        keys.emplace_back("flat_width");
    }
    return keys;
}

void read_profile(const io::TomlSection& section, bool tilt_unknown, Scene& scene) {
    scene.profile_line = section.line();
    const std::string kind = section.text("kind");
    const auto row = std::ranges::find(all_kinds(), kind, &ProfileKind::name);
    const bool known = row != all_kinds().end();
    check_tilt(section, kind, known && row->punch != nullptr, tilt_unknown);
    section.require(known, "kind", "unknown kind of profile '" + kind + "'",
                    one_of(kind, profile_kinds()));
    if (row->profile == nullptr) {
        scene.profile = kind == "piecewise"
                            ? read_piecewise(section)
                            : read_round_bodies(section, row->parameters, scene.radii);
        return;
    }
    std::vector<std::string_view> parameters = row->parameters;
    const bool by_width = kind == "flat-and-rounded" && section.has("flat_width");
    section.require(!by_width || !section.has("t"), "flat_width", "the flat is given twice",
                    "give t, its half-length, or flat_width, its length");
    if (by_width) {
        parameters.front() = "flat_width";
    }
    const Get get = [&](std::string_view name) {
        const bool half = by_width && name == "t";
        const std::string_view key = half ? "flat_width" : name;
        Exact value = contact_constant(section, key);
        (void)sign_of(section, key, value); // every parameter is compared with zero
        return half ? Exact(value.expr() / whole(2)) : value;
    };
    std::vector<std::string_view> keys{"kind", "geometry"};
    keys.insert(keys.end(), parameters.begin(), parameters.end());
    section.allow(keys);
    located(section, parameters, [&] {
        if (tilt_unknown) {
            scene.punch = row->punch(get);
            (void)scene.punch->at(Exact());
        } else {
            scene.profile = row->profile(get);
        }
    });
}

namespace {

constexpr long bits_of_size = 64;
constexpr std::size_t most_shown = 60;

/// Of what defines a contact.
const Rational& largest_size() {
    static const Rational q = parse_decimal("1e10000");
    return q;
}

bool numbers_in_range(const Expr& e) {
    if (const Rational* q = e.rational()) {
        const Rational size = abs(*q);
        return size == 0 || (1 / largest_size() <= size && size <= largest_size());
    }
    return std::ranges::all_of(e.args(), numbers_in_range);
}

/// False only where the value is proved to be beyond the range.
bool value_in_range(const Expr& e) {
    const auto x = formula::enclose(e, bits_of_size);
    const Ball largest(largest_size(), bits_of_size);
    return !x || (!certainly_less(largest, abs(*x)) &&
                  (contains_zero(*x) || !certainly_less(abs(*x) * largest, Ball(1, bits_of_size))));
}

} // namespace

void check_size(const io::TomlSection& section, std::string_view key, const Expr& e,
                std::string_view text) {
    if (!numbers_in_range(e) ||
        (formula::free_symbols(e).empty() && !formula::has_binder(e) && !value_in_range(e))) {
        section.reject(key,
                       std::string(key) + " = " + shortened(text, most_shown) +
                           " is beyond the range of what defines a contact",
                       "write 0, or a number between 1e-10000 and 1e10000");
    }
}

Exact contact_constant(const io::TomlSection& section, std::string_view key) {
    Exact value = section.exact(key);
    check_size(section, key, value.expr(), value.text());
    return value;
}

bool is_axisymmetric(const io::TomlSection& profile) {
    const std::string kind = profile.text("kind");
    const bool of_revolution = kind == "sphere" || kind == "cone";
    if (!profile.has("geometry")) {
        return of_revolution;
    }
    const std::string geometry = profile.text("geometry");
    profile.require(!of_revolution || geometry != "plane", "geometry",
                    "a " + kind + " is axisymmetric",
                    kind == "sphere" ? "write kind = \"hertz\" for cylinders"
                                     : "write kind = \"wedge\" for a plane contact");
    profile.require(geometry == "plane" || geometry == "axisymmetric", "geometry",
                    "unknown geometry '" + geometry + "'", "write plane or axisymmetric");
    return geometry == "axisymmetric";
}

void require_axisymmetric(const io::TomlSection& profile, const Scene& scene) {
    if (!scene.profile || !scene.profile->symmetric()) {
        profile.reject("geometry",
                       "only power laws and symmetric slopes are computed as axisymmetric contacts",
                       "write kind = \"sphere\", cone, power-law, "
                       "flat-and-rounded, or piecewise with symmetric = true");
    }
    if (scene.profile->kind() == Profile::Kind::power_law || scene.profile->piecewise_linear()) {
        return;
    }
    if (const auto v = contact::AxisymmetricContact::not_analytic_at(*scene.profile)) {
        profile.reject("geometry",
                       "g' is not analytic at r = " + v->text() +
                           ", so that the axisymmetric contact is not computed",
                       "write pieces that are analytic up to their ends; a power of r alone is "
                       "kind = \"power-law\"");
    }
}

void revolve(Scene& scene) {
    scene.round = Axisymmetric{*scene.profile, scene.load};
    Axisymmetric& round = *scene.round;
    const Exact given = scene.load.value;
    if (scene.load.kind == Load::Kind::force) {
        round.force = given;
    } else if (scene.load.kind == Load::Kind::approach) {
        round.approach = given;
    }
    if (scene.profile->kind() != Profile::Kind::power_law) {
        scene.profile = scene.profile->revolved();
        return;
    }
    round.law = contact::AxisymmetricPowerLaw::of(*scene.profile);
    scene.profile = round.law->plane();
    const Exact a = round.force      ? round.law->radius(scene.contact_modulus, given)
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

} // namespace edgeproof::scene

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/witness/witness.hpp"
#include "edgeproof/cost/cost.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "edgeproof/scene/route/scene_values.hpp"

#include <filesystem>
#include <iterator>
#include <memory>
#include <sstream>
#include <utility>

namespace edgeproof::cost {
namespace {

constexpr std::size_t many = 40;
constexpr std::size_t some = 10;
constexpr unsigned digits_of_places = 6;

/// Returns a geometric sequence from 1e-8 to 1, as decimals of 6 digits, times `unit`.
std::vector<formula::Exact> geometric_places(std::size_t count, const std::string& unit) {
    const PrecisionScope scope(30);
    std::vector<formula::Exact> u;
    for (std::size_t k = 0; k < count; ++k) {
        const Real exponent = Real(8 * k) / Real(count - 1) - 8;
        const std::string text = to_decimal(Real(pow(Real(10), exponent)), digits_of_places);
        u.push_back(formula::Exact::parse(unit == "1" ? text : "(" + unit + ")*" + text));
    }
    return u;
}

std::vector<formula::Exact> listed(const std::vector<const char*>& texts) {
    std::vector<formula::Exact> u;
    u.reserve(texts.size());
    for (const char* text : texts) {
        u.push_back(formula::Exact::parse(text));
    }
    return u;
}

/// Returns the scene of words such as "kind=hertz R=1 a=1", with the contact modulus 1.
scene::Scene made_scene(const std::string& name, const std::string& words) {
    std::istringstream in(words + " contact_modulus=1");
    const std::vector<std::string> list{std::istream_iterator<std::string>(in), {}};
    return scene::parse_scene("", name, scene::given_scene(list).instead);
}

} // namespace

std::vector<CostCase> usual_cases() {
    const char* const flat = "kind=flat-and-rounded t=0.4 R=1";
    const char* const wedge = "kind=power-law m=0 C=1";
    const char* const power = "kind=power-law m=1/2 C=1";
    const char* const tilted_wedge = "kind=tilted-wedge phi=pi/16 alpha=pi/32";
    const char* const tilted_flat = "kind=tilted-flat-and-rounded alpha=1/10 t=1/2 R=2";
    const char* const curved = "kind=piecewise symmetric=true knots=1/2 slopes=x/10,x/10+(x-1/2)^3";
    std::vector<CostCase> cases;
    const auto add = [&](const std::string& name, const std::string& profile,
                         std::vector<formula::Exact> u) {
        cases.push_back(
            {name, made_scene(name, profile + " a=1"), contact::Edge::right, std::move(u)});
    };
    const std::vector<formula::Exact> by_the_apex =
        listed({"1 - 1e-2", "1 - 1e-4", "1 - 1e-8", "1 - 1e-12", "1 - 1e-20", "1 - 1e-30"});
    std::vector<formula::Exact> off_centre = geometric_places(some, "1");
    off_centre.back() =
        formula::Exact::parse("1/2"); // u = a is the apex, where p is infinite for some profiles
    add("flat-and-rounded", flat, geometric_places(many, "1"));
    add("wedge", wedge, off_centre);
    add("power law, m = 1/2", power, off_centre);
    add("tilted wedge", tilted_wedge, off_centre);
    add("tilted flat-and-rounded", tilted_flat, off_centre);
    add("curved", curved, off_centre);
    add("by the end of the flat", flat,
        listed({"0.6 - 1e-2", "0.6 + 1e-3", "0.6 - 1e-4", "0.6 + 1e-6", "0.6 - 1e-8", "0.6 + 1e-10",
                "0.6 - 1e-12", "0.6 + 1e-16", "0.6 - 1e-20", "0.6 - 1e-30"}));
    add("by the apex of a wedge", wedge, by_the_apex);
    add("by the apex of a power law", power, by_the_apex);
    add("within 1e-300 of the edge", tilted_flat,
        listed({"1e-12", "1e-20", "1e-30", "1e-60", "1e-100", "1e-300"}));
    return cases;
}

CostCase case_of(const scene::Scene& scene) {
    if (!scene.profile) {
        throw InputError("the cost of a scene with P and M is not measured: its tilt is found "
                         "once, and its pressures cost as much as those of the tilted profile",
                         "give alpha, and a or P")
            .at(scene.file, scene.load_line);
    }
    CostCase c{std::filesystem::path(scene.file).stem().string(),
               scene,
               scene.ask.edges.empty() ? contact::Edge::right : scene.ask.edges.front(),
               {}};
    for (const scene::AskedPoint& point : scene.ask.u) {
        const auto u = point.distance(c.edge).number();
        if (!u) {
            throw InputError(point.text() + " has no numerical value, because a has none",
                             "give a, or u as numbers")
                .at(scene.file, point.line);
        }
        c.u.push_back(*u);
    }
    if (c.u.empty()) {
        const contact::Witness contact(*scene.profile, scene.contact_modulus, scene.load, 20);
        const Real size = c.edge == contact::Edge::right ? contact.a() : contact.b();
        c.u = geometric_places(many, to_decimal(size, digits_of_places));
    }
    return c;
}

namespace {

/// A route of the witness, at the digits asked for.
template <contact::Route route> ReadyContact in_mpfr(const CostCase& c, unsigned digits) {
    const auto contact = std::make_shared<contact::Witness>(
        *c.scene.profile, c.scene.contact_modulus, c.scene.load, digits);
    return [&c, contact](std::size_t i) -> CostValue {
        const auto p = contact->pressure(c.edge, c.u[i], route);
        return {p.value, p.evaluations};
    };
}

/// An enclosure with as many bits as the digits need if nothing cancels.
template <class Contact> ReadyContact in_balls(const CostCase& c, unsigned digits) {
    const auto contact =
        std::make_shared<Contact>(*c.scene.profile, c.scene.contact_modulus, c.scene.load,
                                  static_cast<long>(static_cast<double>(digits) * 3.3219281) + 64);
    return [&c, contact](std::size_t i) -> CostValue {
        const Ball p = contact->pressure(c.edge, c.u[i]);
        return {p.midpoint(), 0, p};
    };
}

/// The method of `edgeproof pressure`: more and more bits until the value rounds as asked.
ReadyContact as_printed(const CostCase& c, unsigned digits) {
    scene::Scene scene = c.scene;
    scene.shear.reset();
    scene.ask = {};
    scene.ask.quantities = {scene::QuantityGroup::pressure};
    scene.ask.edges = {c.edge};
    scene.ask.digits.count = digits;
    for (const formula::Exact& u : c.u) {
        scene.ask.u.push_back({u, 0});
    }
    const auto values = std::make_shared<scene::SceneValues>(std::move(scene));
    return [&c, values](std::size_t i) -> CostValue {
        const Ball p =
            values->value({.quantity = scene::Quantity::p, .edge = c.edge, .u = c.u[i]}).value;
        return {p.midpoint(), 0, p};
    };
}

bool any(const scene::Scene&) { return true; }
bool closed(const scene::Scene& scene) { return scene.profile->has_closed_form(); }
bool curved(const scene::Scene& scene) { return !closed(scene); }

} // namespace

const std::vector<CostRoute>& cost_routes() {
    using contact::Route;
    static const std::vector<CostRoute> routes{
        // For a curved g', this integrand is itself an integral: minutes for each point.
        {"Barber-Mossakovskii", "MPFR", true, closed, in_mpfr<Route::barber_mossakovskii>},
        {"singular integral", "MPFR", true, any, in_mpfr<Route::singular_integral>},
        {"enclosure", "balls", false, closed, in_balls<contact::BallContact>},
        {"enclosure", "balls", false, curved, in_balls<contact::IntegratedContact>},
        {"rounded", "balls", false, any, as_printed}};
    return routes;
}

} // namespace edgeproof::cost

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "lab/cost/cost.hpp"

#include <algorithm>

namespace edgeproof::cost {
namespace {

constexpr double enough_seconds_of_an_effect = 0.05;
constexpr std::size_t fewest_runs = 3;
constexpr std::size_t most_runs = 9;

using Section = std::vector<io::TomlEntry>;
using Texts = std::vector<std::string>;

struct Added {
    const char* name;
    const char* base;
    Section profile;
    Section load;
    Section shear = {};
    Section ask = {};
    /// Adds what entries cannot state: points of bodies, steps.
    void (*more)(scene::Scene&) = nullptr;
};

const Section flat{{"kind", "flat-and-rounded"}, {"t", "0.4"}, {"R", "1"}};
const Section tilted{
    {"kind", "tilted-flat-and-rounded"}, {"alpha", "1/10"}, {"t", "0.4"}, {"R", "1"}};
const Section untilted{{"kind", "tilted-flat-and-rounded"}, {"t", "0.4"}, {"R", "1"}};
const Section by_edge{{"a", "1"}};
const Section by_edge_with_nu{{"a", "1"}, {"nu", "0.3"}};
const Section by_force{{"P", "1/2"}};
const Section by_moment{{"P", "1/2"}, {"M", "-1/50"}};
const Section both_edges{{"edges", Texts{"right", "left"}}};
const Section extents_of_terms{
    {"terms", Texts{"1", "3"}}, {"tolerance", "5%"}, {"quantities", Texts{"extent"}}};

const Section cubic_then_linear{{"kind", "piecewise"},
                                {"symmetric", true},
                                {"knots", Texts{"1/2"}},
                                {"slopes", Texts{"x + x^3", "5/8 + 2*(x - 1/2)"}}};
const Section sphere{{"kind", "hertz"}, {"R", "1"}, {"geometry", "axisymmetric"}};
const Section flat_of_revolution{
    {"kind", "flat-and-rounded"}, {"t", "0.4"}, {"R", "1"}, {"geometry", "axisymmetric"}};
const Section shear_with_slip{{"Q", "0.1"}, {"friction", "0.6"}};

/// p and q, as `pressure` computes them: without the sizes of slip zones and the energy of a cycle.
const io::TomlEntry tractions{"quantities", Texts{"pressure", "shear"}};

/// Asks for a group of quantities alone, at no point of the contact.
Section only(const char* group) { return {{"quantities", Texts{group}}}; }
Section displacement_at(const Texts& x) {
    return {{"quantities", Texts{"displacement"}}, {"x", x}};
}
Section surface_at(const Texts& x) {
    return {{"quantities", Texts{"surface"}}, {"x", x}, {"reference", "0"}};
}
const Texts inside{"-0.97", "-0.9", "-0.7", "-0.5", "-0.3", "0.3", "0.5", "0.7", "0.9", "0.97"};
const Texts outside{"-9", "-3", "-2", "-1.5", "-1.1", "1.1", "1.5", "2", "3", "9"};

/// Ten points below the surface.
void in_bodies(scene::Scene& scene) {
    for (const std::string& x : inside) {
        scene.ask.in_bodies.push_back({formula::Exact::parse(x), formula::Exact::parse("0.3")});
    }
}
/// Two cycles of Q under a constant P.
void in_cycles(scene::Scene& scene) {
    const auto step = [&](const char* Q) {
        scene.steps.push_back({formula::Exact::parse("1/2"), formula::Exact::parse(Q), {}});
    };
    for (const char* Q : {"0", "0.2", "-0.2", "0.2", "-0.2"}) {
        step(Q);
    }
    set_step(scene, scene.steps.size());
}

constexpr const char* plain = "pressures of a symmetric punch";
constexpr const char* slipping = "shear in partial slip";
constexpr const char* of_revolution = "pressures under a sphere";

const Added effects[] = {
    {plain, "", flat, by_edge},
    {"P given instead of a", plain, flat, by_force},
    {"tilt", plain, tilted, by_edge},
    {"tilt found from P and M", "tilt", untilted, by_moment},
    {"both edges of a tilted punch", "tilt", tilted, by_edge, {}, both_edges},
    {"shear under full stick", plain, flat, by_edge, {{"Q", "0.1"}}},
    {"shear and bulk tension", plain, flat, by_edge, {{"Q", "0.1"}, {"bulk_tension", "0.2"}}},
    {"shear in proportion to P", plain, flat, by_edge, {{"Q", "0.1"}, {"path", "together"}}},
    {"expansion to 3 terms", plain, flat, by_edge, {}, {{"terms", "3"}}},
    {"expansion to 10 terms", plain, flat, by_edge, {}, {{"terms", "10"}}},
    {"expansion to 3 terms, tilted", "tilt", tilted, by_edge, {}, {{"terms", "3"}}},
    {"extents of 1 and 3 terms", plain, flat, by_edge, {}, extents_of_terms},
    {slipping, plain, flat, by_edge, shear_with_slip, {tractions}},
    {"shear after 5 steps of a history",
     slipping,
     flat,
     by_force,
     shear_with_slip,
     {tractions},
     in_cycles},
    {"slip zones and the energy of a cycle", slipping, flat, by_edge, shear_with_slip,
     only("slip")},
    {"greatest pressure", plain, flat, by_edge, {}, only("peak")},
    {"gap at ten places", plain, flat, by_edge, {}, displacement_at(outside)},
    {"slip at ten places", slipping, flat, by_edge, shear_with_slip, displacement_at(inside)},
    {"displacements of a surface at ten places", slipping, flat, by_edge_with_nu, shear_with_slip,
     surface_at(inside)},
    {"energy of a cycle, curved slopes", "slip zones and the energy of a cycle", cubic_then_linear,
     by_edge, shear_with_slip, only("slip")},
    {"stresses at ten points", plain, flat, by_edge, {}, only("stress"), in_bodies},
    {"stresses in partial slip", slipping, flat, by_edge, shear_with_slip, only("stress"),
     in_bodies},
    {of_revolution, plain, sphere, by_edge},
    {"pressures under a flat punch of revolution", of_revolution, flat_of_revolution, by_edge},
    {"shear under a sphere", of_revolution, sphere, by_edge, shear_with_slip, {tractions}},
    {"gap around a sphere", of_revolution, sphere, by_edge, {}, displacement_at(outside)},
};

scene::Scene scene_of(const Added& e, unsigned digits) {
    Section load = e.load;
    Section ask = e.ask;
    load.push_back({"contact_modulus", "1"});
    ask.push_back({"digits", std::to_string(digits)});
    const bool only_others = std::ranges::any_of(e.ask, [](const io::TomlEntry& entry) {
        using List = std::vector<std::string>;
        return entry.key == "quantities" &&
               std::get<List>(entry.value) != std::get<List>(tractions.value);
    });
    if (!only_others) {
        ask.push_back({"u", Texts{"1e-8", "1e-6", "1e-4", "1e-3", "0.01", "0.03", "0.1", "0.2",
                                  "0.3", "0.45"}});
    }
    scene::Scene scene = scene::make_scene(
        {{"profile", 0, e.profile}, {"load", 0, load}, {"shear", 0, e.shear}, {"ask", 0, ask}});
    scene.file = e.name;
    if (e.more != nullptr) {
        e.more(scene);
    }
    return scene;
}

} // namespace

std::vector<EffectCost>
effect_costs(unsigned digits, bool timed,
             const std::function<void(std::size_t, std::size_t)>& progress) {
    std::vector<EffectCost> costs;
    for (const Added& e : effects) {
        check_interruption();
        if (progress) {
            progress(costs.size(), std::size(effects));
        }
        const scene::Scene scene = scene_of(e, digits);
        EffectCost cost{e.name, e.base, 0, 1};
        std::vector<double> seconds;
        double spent = 0;
        while (timed && (seconds.size() < fewest_runs ||
                         (spent < enough_seconds_of_an_effect && seconds.size() < most_runs))) {
            const double begun = parallel::thread_seconds();
            (void)run_scene(scene);
            seconds.push_back(parallel::thread_seconds() - begun);
            spent += seconds.back();
        }
        cost.seconds = quartiles(std::move(seconds)).median;
        const auto base = std::ranges::find(costs, cost.base, &EffectCost::effect);
        cost.ratio = base != costs.end() && base->seconds > 0 ? cost.seconds / base->seconds : 1;
        costs.push_back(std::move(cost));
    }
    return costs;
}

} // namespace edgeproof::cost

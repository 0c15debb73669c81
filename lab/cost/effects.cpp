// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "lab/cost/cost.hpp"

#include <algorithm>

namespace edgeproof::cost {
namespace {

constexpr double enough_seconds_of_an_effect = 0.05;
constexpr std::size_t fewest_runs = 3;
constexpr std::size_t most_runs = 9;

struct Added {
    const char* name;
    const char* base;
    std::string words; ///< of the scene
    /// Adds what words cannot state: points of bodies, steps.
    void (*more)(scene::Scene&) = nullptr;
};

const std::string flat = "kind=flat-and-rounded t=0.4 R=1 a=1 ";
const std::string flat_by_force = "kind=flat-and-rounded t=0.4 R=1 P=1/2 ";
const std::string tilted = "kind=tilted-flat-and-rounded alpha=1/10 t=0.4 R=1 a=1 ";
const std::string cubic_then_linear =
    "kind=piecewise symmetric=true knots=1/2 slopes=x+x^3,5/8+2*(x-1/2) a=1 ";
const std::string sphere = "kind=hertz R=1 geometry=axisymmetric a=1 ";
const std::string with_slip = "Q=0.1 friction=0.6 ";
/// p and q, as `pressure` computes them: without the sizes of slip zones and the energy of a cycle.
const std::string tractions = "quantities=pressure,shear ";
const std::string inside = "-0.97,-0.9,-0.7,-0.5,-0.3,0.3,0.5,0.7,0.9,0.97";
const std::string outside = "-9,-3,-2,-1.5,-1.1,1.1,1.5,2,3,9";

/// Ten points below the surface.
void in_bodies(scene::Scene& scene) {
    for (const std::string& x : scene::parts_of(inside)) {
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
    {plain, "", flat},
    {"P given instead of a", plain, flat_by_force},
    {"tilt", plain, tilted},
    {"tilt found from P and M", "tilt", "kind=tilted-flat-and-rounded t=0.4 R=1 P=1/2 M=-1/50"},
    {"both edges of a tilted punch", "tilt", tilted + "edges=right,left"},
    {"shear under full stick", plain, flat + "Q=0.1"},
    {"shear and bulk tension", plain, flat + "Q=0.1 bulk_tension=0.2"},
    {"shear in proportion to P", plain, flat + "Q=0.1 path=together"},
    {"expansion to 3 terms", plain, flat + "terms=3"},
    {"expansion to 10 terms", plain, flat + "terms=10"},
    {"expansion to 3 terms, tilted", "tilt", tilted + "terms=3"},
    {"extents of 1 and 3 terms", plain, flat + "terms=1,3 tolerance=5% quantities=extent"},
    {slipping, plain, flat + with_slip + tractions},
    {"shear after 5 steps of a history", slipping, flat_by_force + with_slip + tractions,
     in_cycles},
    {"slip zones and the energy of a cycle", slipping, flat + with_slip + "quantities=slip"},
    {"greatest pressure", plain, flat + "quantities=peak"},
    {"gap at ten places", plain, flat + "quantities=displacement x=" + outside},
    {"slip at ten places", slipping, flat + with_slip + "quantities=displacement x=" + inside},
    {"displacements of a surface at ten places", slipping,
     flat + "nu=0.3 " + with_slip + "quantities=surface reference=0 x=" + inside},
    {"energy of a cycle, curved slopes", "slip zones and the energy of a cycle",
     cubic_then_linear + with_slip + "quantities=slip"},
    {"stresses at ten points", plain, flat + "quantities=stress", in_bodies},
    {"stresses in partial slip", slipping, flat + with_slip + "quantities=stress", in_bodies},
    {of_revolution, plain, sphere},
    {"pressures under a flat punch of revolution", of_revolution, flat + "geometry=axisymmetric"},
    {"shear under a sphere", of_revolution, sphere + with_slip + tractions},
    {"gap around a sphere", of_revolution, sphere + "quantities=displacement x=" + outside},
};

scene::Scene scene_of(const Added& e, unsigned digits) {
    const bool pressures = e.words.find("quantities=") == std::string::npos ||
                           e.words.find(tractions) != std::string::npos;
    scene::Scene scene = made_scene(
        e.name, e.words + " digits=" + std::to_string(digits) +
                    (pressures ? " u=1e-8,1e-6,1e-4,1e-3,0.01,0.03,0.1,0.2,0.3,0.45" : ""));
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

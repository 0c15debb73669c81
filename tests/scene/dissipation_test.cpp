// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using scene::Quantity, scene::Scene;

namespace {

using Loads = std::vector<std::pair<double, double>>; ///< (P, Q) at the ends of the steps

const double circle = std::acos(-1.0);

/// `before` once, then `pass` a number of times.
Scene repeated_steps(const std::string& profile, const Loads& before, const Loads& pass,
                     std::size_t cycles) {
    std::string text = "[profile]\n" + profile +
                       "\n[load]\ncontact_modulus = \"1\"\n[shear]\nfriction = \"1/2\"\n";
    const auto add = [&](const Loads& loads, const std::string& first) {
        for (std::size_t i = 0; i < loads.size(); ++i) {
            text += "[[step]]\nP = \"" + std::to_string(loads[i].first) + "\"\nQ = \"" +
                    std::to_string(loads[i].second) + "\"\n" + (i == 0 ? first : "");
        }
    };
    add(before, "");
    add(pass, "cycles = " + std::to_string(cycles) + "\n");
    return scene::parse_scene(text, "steps.toml");
}

Ball energy_value(const Scene& s, Quantity quantity) {
    const scene::BoundedValue value =
        scene::SceneValues(s, {{quantity}}, {20, Rounding::nearest, false}).value({quantity});
    CHECK(value.proved);
    return value.value;
}
double energy_number(const Scene& s, Quantity quantity) {
    return energy_value(s, quantity).midpoint().convert_to<double>();
}

/// The layers (force, ratio) of a scene.
Loads layers_of(const Scene& s) {
    Loads layers;
    if (s.history) {
        for (const scene::LoadHistory::Layer& layer : s.history->layers) {
            layers.emplace_back(layer.force.to<double>(), layer.ratio.to<double>());
        }
    }
    return layers;
}

/// Each step of a path divided into `parts`.
Loads divided(const Loads& path, std::pair<double, double> from, int parts) {
    Loads fine;
    for (const auto& [P, Q] : path) {
        for (int k = 1; k <= parts; ++k) {
            const double t = static_cast<double>(k) / parts;
            fine.emplace_back(from.first + (P - from.first) * t,
                              from.second + (Q - from.second) * t);
        }
        from = {P, Q};
    }
    return fine;
}

const Loads first_loads{{1, 0.1}, {1, 0.3}};
const std::vector<Loads> passes{
    {{1, -0.2}, {1, 0.3}},
    {{1.25, 0.25}, {0.75, -0.25}, {1, 0.3}},
    {{1.5, -0.375}, {0.625, 0.125}, {1, 0.0625}, {1, 0.3}},
    {{0.5, 0.125}, {0.5, -0.125}, {1, 0.3}},
};

} // namespace

// The energy is the area of the loop of Q over the displacement of the bodies: a punch of force
// kappa dL over the length D moves them by -(2/(pi E*)) kappa ln D dL (docs/partial-slip.md). D(L)
// comes from the edges of the contacts.
TEST_CASE("the energy of a cycle is the area of the loop of shear force and displacement") {
    constexpr std::size_t grid = 150;
    constexpr double most = 1.5;
    constexpr int parts = 16;
    const std::string profiles[] = {"kind = \"hertz\"\nR = \"2\"",
                                    "kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"3\"",
                                    "kind = \"power-law\"\nm = \"5/8\"\nC = \"1/3\"",
                                    "kind = \"tilted-wedge\"\nphi = \"1/3\"\nalpha = \"1/10\"",
                                    "kind = \"tilted-flat-and-rounded\"\nalpha = \"1/20\"\nt = "
                                    "\"1/2\"\nR = \"3\"",
                                    "kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\n"
                                    "slopes = [\"x/2 + x^3\", \"3/8 + 2*sinh(x - 1/2)\"]"};
    std::vector<std::vector<double>> log_lengths; // ln D at the middle of each part of L
    for (const std::string& profile : profiles) {
        std::vector<double>& list = log_lengths.emplace_back();
        for (std::size_t i = 0; i < grid; ++i) {
            const double L = most * (static_cast<double>(i) + 0.5) / grid;
            const Scene s =
                scene::parse_scene("[profile]\n" + profile + "\n[load]\nP = \"" +
                                       std::to_string(L) + "\"\ncontact_modulus = \"1\"\n",
                                   "contact.toml");
            scene::SceneValues edges(s, {{Quantity::a}}, {10, Rounding::nearest, false});
            const Ball D = edges.value({Quantity::a}).value + edges.value({Quantity::b}).value;
            list.push_back(std::log(D.midpoint().convert_to<double>()));
        }
    }
    for (const Loads& pass : passes) {
        CAPTURE(pass.size());
        // The first pass reaches the steady state, the next one is measured.
        Loads path = first_loads;
        path.insert(path.end(), pass.begin(), pass.end());
        const std::size_t begin = path.size();
        const Loads fine = divided(pass, pass.back(), parts);
        path.insert(path.end(), fine.begin(), fine.end());
        Scene states = repeated_steps(profiles[0], path, {fine.back()}, 1);
        std::vector<Loads> layers; // they do not depend on the profile
        for (std::size_t k = begin; k <= path.size(); ++k) {
            set_step(states, k);
            layers.push_back(layers_of(states));
        }
        for (std::size_t which = 0; which < std::size(profiles); ++which) {
            CAPTURE(which);
            double area = 0;
            double last_moved = 0;
            for (std::size_t k = 0; k < layers.size(); ++k) {
                double moved = 0;
                double from = 0;
                for (const auto& [force, ratio] : layers[k]) {
                    for (std::size_t i = 0; i < grid; ++i) {
                        const double lo = std::max(from, most * static_cast<double>(i) / grid);
                        const double hi = std::min(force, most * static_cast<double>(i + 1) / grid);
                        moved -=
                            hi > lo ? ratio * (hi - lo) * log_lengths[which][i] * 2 / circle : 0;
                    }
                    from = force;
                }
                if (k > 0) {
                    const double Q = path[begin + k - 1].second;
                    area += (Q + path[begin + k - 2].second) / 2 * (moved - last_moved);
                }
                last_moved = moved;
            }
            const Scene s = repeated_steps(profiles[which], first_loads, pass, 2);
            CHECK(s.history->steady);
            const double energy = energy_number(s, Quantity::cycle_energy);
            CAPTURE(energy);
            CAPTURE(area);
            CHECK(std::abs(area - energy) < 1.5e-2 * energy);
            CHECK(energy > 1e-4);
        }
    }
}

// E* = 1, f = 1/2: the integral over the step of the traction f p times the rate of slip, over both
// slip zones. A part of q in proportion to the pressure of the half-width c moves a place x > c by
// the integral of its gap, whose derivative by the force is -(2/pi) acosh(x/c) (johnson1985,
// eqs. 2.24 and 4.41). The stick zone at each time is the one with which the layers of the last
// state and the new slip balance Q, found anew at each time. For the cylinder, mpmath at 25 digits
// and its p; for the other profiles, numpy's Gauss-Legendre rule of 40 points and p as the integral
// of the pressures of flat punches, which has 12 digits right for the cylinder.
TEST_CASE("the energy of a step is traction times slip") {
    const struct {
        const char* profile;
        const char* tolerance;
    } bodies[] = {{"kind = \"hertz\"\nR = \"2\"", "1e-16"},
                  {"kind = \"power-law\"\nm = \"5/8\"\nC = \"1/3\"", "1e-11"},
                  {"kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"3\"", "1e-11"}};
    const std::vector<std::pair<Loads, std::array<const char*, 3>>> steps{
        // P is constant
        {{{1, 0}, {1, 0.375}},
         {"0.00972248976808152015", "0.01196614125302342", "0.007691231270749974"}},
        // reversed
        {{{1, 0}, {1, 0.375}, {1, -0.125}},
         {"0.00452420362129785256", "0.005568250610828138", "0.003695232630493849"}},
        // P increases
        {{{1, 0.25}, {1.25, -0.25}},
         {"0.00711698478302410557", "0.008759365886798922", "0.005850467579816356"}},
        // P decreases
        {{{1, 0.25}, {0.75, -0.125}},
         {"0.00399168745571932862", "0.00491284609934687", "0.00316967395074341"}},
        // through several layers
        {{{1, 0.25}, {2, 0.25}, {0.75, -0.125}},
         {"0.0099980584035962268", "0.01230530265058004", "0.008191026912748672"}},
        // without slip at first
        {{{1, 0.25}, {2, 0.25}, {0.75, 0.25}},
         {"0.000306877461513463935", "0.0003776953372473408", "0.000248605224253905"}},
        // P falls to L_s, and the slip changes its sign
        {{{1, -0.4}, {1.5, -0.2}, {0.45, -0.2}},
         {"0.00225403402266076655", "0.002774195720197882", "0.001884660846650073"}},
        // P increases, and the slip is reversed
        {{{1, -0.25}, {2, 0.125}, {1, 0.25}},
         {"0.0267585009558054369", "0.03293353963791458", "0.02212010626627606"}},
    };
    for (const auto& each : steps) {
        const auto& path = each.first;
        const auto& values = each.second;
        for (std::size_t i = 0; i < values.size(); ++i) {
            CAPTURE(path.size());
            CAPTURE(path.back().first);
            CAPTURE(i);
            Scene s = repeated_steps(bodies[i].profile, path, {path.back()}, 1);
            set_step(s, path.size());
            const Ball expected = formula::enclosed_constant(Exact::parse(values[i]), 200);
            const Ball energy = energy_value(s, Quantity::step_energy);
            CHECK(abs(Ball(energy / expected - 1)).upper() < Real(bodies[i].tolerance));
        }
    }
}

// E* = 1, f = 1/2: as above, by numpy; the rule is of tanh-sinh in the angle whose sine squared is
// the part of the slip zone, and Gauss-Legendre's of 16 times in the step. p is the integral of the
// Green function over g''. The values of the cylinder agree with those above to 12 digits (P
// constant) and 15 digits. The slip zones of the second body pass its corner and its knot.
TEST_CASE("the energy of a step is traction times slip: bodies that are not symmetric") {
    const struct {
        const char* profile;
        std::array<const char*, 3> energies;
    } bodies[] = {
        {"kind = \"tilted-flat-and-rounded\"\nalpha = \"1/20\"\nt = \"1/2\"\nR = \"3\"",
         {"0.00772928530378536", "0.005866036462859534", "0.003183950826051014"}},
        {"kind = \"piecewise\"\nknots = [\"-1/2\", \"0\", \"2/5\"]\n"
         "slopes = [\"-1\", \"x\", \"x\", \"11/20 + x/4\"]",
         {"0.01283016193658318", "0.01060931596453044", "0.005390778311561346"}},
    };
    const Loads paths[] = {
        {{1, 0}, {1, 0.375}}, {{1, 0.25}, {1.25, -0.25}}, {{1, 0.25}, {0.75, -0.125}}};
    for (const auto& body : bodies) {
        for (std::size_t i = 0; i < std::size(paths); ++i) {
            CAPTURE(body.profile);
            CAPTURE(i);
            Scene s = repeated_steps(body.profile, paths[i], {paths[i].back()}, 1);
            set_step(s, paths[i].size());
            const Ball expected = formula::enclosed_constant(Exact::parse(body.energies[i]), 200);
            const Ball energy = energy_value(s, Quantity::step_energy);
            CHECK(abs(Ball(energy / expected - 1)).upper() < Real("1e-10"));
        }
    }
}

TEST_CASE("energies of histories: nothing slips, cycles that are not steady, what is refused") {
    const std::string cylinder = "kind = \"hertz\"\nR = \"2\"";
    const Scene stuck = repeated_steps(cylinder, {{1, 0.1}}, {{2, 0.3}}, 1);
    const Ball none = energy_value(stuck, Quantity::step_energy);
    CHECK((none.is_exact() && contains_zero(none)));
    // Q = 2/5 and back at constant P: each half of Mindlin's loop of amplitude 1/5.
    const Scene loop = repeated_steps(cylinder, {{1, 0.4}}, {{1, 0}, {1, 0.4}}, 2);
    CHECK(loop.history->steady);
    const Scene plain =
        scene::parse_scene("[profile]\n" + cylinder +
                               "\n[load]\nP = \"1\"\ncontact_modulus = \"1\"\n[shear]\nQ = "
                               "\"1/5\"\nfriction = \"1/2\"\n",
                           "plain.toml");
    CHECK(overlaps(energy_value(loop, Quantity::cycle_energy),
                   energy_value(plain, Quantity::cycle_energy)));
    CHECK(overlaps(energy_value(loop, Quantity::step_energy) * 2,
                   energy_value(plain, Quantity::cycle_energy)));
    const Scene first = repeated_steps(cylinder, {{1, 0}}, {{1, 0.4}, {1, 0}}, 1);
    CHECK_FALSE(first.history->steady);
    Scene part = repeated_steps(cylinder, {{1, 0}}, {{1, 0.4}, {1, 0}}, 3);
    set_step(part, 6);
    CHECK(lack_of(part, {Quantity::cycle_energy})->problem.find("not the end of a cycle") !=
          std::string::npos);
    set_step(part, 5);
    CHECK_FALSE(lack_of(part, {Quantity::cycle_energy}));
    CHECK(part.history->steady);
    CHECK(lack_of(plain, {Quantity::step_energy})->problem.find("no steps") != std::string::npos);
    const auto lack_for = [](const std::string& slopes) {
        const Scene curved =
            repeated_steps("kind = \"piecewise\"\n" + slopes, {{1, 0}}, {{1, 0.4}}, 1);
        const auto lack = lack_of(curved, {Quantity::step_energy});
        return lack ? lack->problem : "";
    };
    CHECK(lack_for("symmetric = true\nknots = []\nslopes = [\"x + x^3\"]").empty());
    CHECK(lack_for("knots = [\"0\"]\nslopes = [\"x\", \"x + x^3\"]").find("not symmetric") !=
          std::string::npos);
    CHECK(lack_for("symmetric = true\nknots = [\"1/4\"]\nslopes = [\"0\", \"(x - 1/4)^(3/2)\"]")
              .find("not analytic") != std::string::npos);
}

// E* = 1, f = 3/5. mpmath 1.2 at 40 digits: 8 f^2/pi times the integral of (P - L)(L - L_s) ds/s
// over the half widths s from the stick zone to the contact (docs/partial-slip.md), in pieces
// between the knots v with s = v + y^2, where L is an integral of g' over the angle.
TEST_CASE("the energy of a cycle of curved slopes that are symmetric") {
    const std::string cubic = "knots = []\nslopes = [\"x + x^3\"]\n";
    const std::string bent = "knots = [\"1/2\"]\nslopes = [\"x + x^3\", \"5/8 + 2*(x - 1/2)\"]\n";
    const std::string corner = "knots = [\"1/4\", \"1/2\"]\nslopes = [\"0\", \"2*sinh(x - 1/4)\", "
                               "\"2*sinh(1/4) + 1/10 + exp(x) - exp(1/2)\"]\n";
    // The third case with lengths doubled, which multiplies the energy by 4.
    const std::string doubled = "knots = [\"1\"]\nslopes = [\"x/2 + x^3/8\", \"5/8 + x - 1\"]\n";
    const std::array<std::array<std::string, 4>, 6> cases{{
        {cubic, "P = 1", "3/10", "0.009873165875667185367180741970571674403104534"},
        {bent, "P = 1", "3/10", "0.01109080190809416256991316672922870394796933"},
        {bent, "P = 1", "59/100", "0.1705836201317539501644297603705037813336993"},
        {doubled, "P = 2", "59/50", "0.6823344805270158006577190414820151253347972"},
        {bent, "a = \"1/2\"", "1/20", "0.0002053543448911557864587511871417865323593143"},
        {corner, "P = 1", "59/100", "0.1280400060365598300257863046886212273543636"},
    }};
    for (const auto& each : cases) {
        CAPTURE(each[0]);
        CAPTURE(each[2]);
        const Scene s =
            scene::parse_scene("[profile]\nkind = \"piecewise\"\nsymmetric = true\n" + each[0] +
                                   "[load]\ncontact_modulus = 1\n" + each[1] +
                                   "\n[shear]\nfriction = \"3/5\"\nQ = \"" + each[2] + "\"\n",
                               "curved.toml");
        const Ball expected = formula::enclosed_constant(Exact::parse(each[3]), 200);
        const Ball energy = energy_value(s, Quantity::cycle_energy);
        CHECK(abs(Ball(energy / expected - 1)).upper() < Real("1e-19"));
    }
}

// mpmath 1.2 at 30 digits: 16 f^2/(pi E*) times the integral of (P - L)(L - L_s)/2 over dD/D
// (docs/partial-slip.md), where the force L of each contact is an integral of g' alone.
TEST_CASE("the energy of a cycle where an edge of the contact or of the stick zone is on a knot") {
    const std::array<std::array<std::string, 2>, 3> cases{{
        {"knots = [\"1/2\"]\nslopes = [\"x/10\", \"x - 9/20\"]\n[load]\nP = \"1/2\"\n"
         "contact_modulus = \"1\"\n[shear]\nQ = \"(1/2 - pi/160)/2\"\n",
         "0.0161404559926031199634882912354"},
        {"knots = [\"1/2\"]\nslopes = [\"x/10\", \"x/10 + 1/20\"]\n[load]\nP = \"1/2\"\n"
         "contact_modulus = \"1\"\n[shear]\nQ = \"(1/2 - pi/160)/2\"\n",
         "0.0323485568171839578196458699399"},
        {"knots = [\"1/4\", \"1/2\"]\nslopes = [\"x/10\", \"x/5 - 1/40\", \"x - 17/40\"]\n"
         "[load]\na = \"1/2\"\ncontact_modulus = \"1\"\n[shear]\nQ = \"1/200\"\n",
         "0.00000197292306989810306102699564460"},
    }};
    for (const auto& each : cases) {
        CAPTURE(each[0]);
        const Scene s = scene::parse_scene("[profile]\nkind = \"piecewise\"\nsymmetric = true\n" +
                                               each[0] + "friction = \"1/2\"\n",
                                           "knot.toml");
        const PrecisionScope precision(40);
        const Real W = energy_value(s, Quantity::cycle_energy).midpoint();
        CHECK(abs(Real(W / Real(each[1]) - 1)) < Real("1e-19"));
    }
}

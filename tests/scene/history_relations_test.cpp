// SPDX-License-Identifier: BSD-3-Clause
// Load histories: the layers of the traction, the law of friction, and the energy of a cycle.
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ios>
#include <optional>

using namespace edgeproof::scenes;

namespace {

const std::vector<std::string> rubbed_profiles{
    "hertz R=2 ", "flat-and-rounded t=1/2 R=3 ", "power-law m=5/8 C=1/3 ",
    "tilted-wedge phi=1/3 alpha=1/10 ", "tilted-flat-and-rounded alpha=1/20 t=1/2 R=3 "};

/// (P, Q) at the ends of the steps.
using LoadPath = std::vector<std::pair<double, double>>;

std::string steps_of(const LoadPath& path) {
    std::string words = "friction=1/2";
    for (const auto& [P, Q] : path) {
        words += " [P=" + std::to_string(P) + ",Q=" + std::to_string(Q) + "]";
    }
    return words;
}

/// All with |Q| < P/2.
const std::vector<LoadPath> load_paths{
    {{1, 0}, {1, 0.3}},
    {{1, 0}, {1, 0.3}, {1, -0.1}},
    {{1, 0.2}},
    {{1, 0.2}, {1.5, 0.7}},
    {{1, 0}, {1, 0.4}, {0.9, 0.3}, {0.9, -0.2}, {1.4, -0.1}},
    {{2, 0.5}, {1, -0.2}, {1.25, -0.25}, {0.75, 0.25}, {0.75, 0.0}, {0.75, 0.1}}};

/// (force, ratio) of each layer.
LoadPath layers_of(const Scene& s) {
    LoadPath layers;
    for (const LoadHistory::Layer& layer : s.history->layers) {
        layers.emplace_back(layer.force.to<double>(), layer.ratio.to<double>());
    }
    return layers;
}

/// The shear force of thin layers `width` wide, by dL, that take up small increments of the load
/// from the newest layer inwards.
std::vector<double> thin_layers(const LoadPath& path, double width) {
    constexpr double f = 0.5;
    std::vector<double> q;
    double P = 0;
    double Q = 0;
    for (const auto& [P_end, Q_end] : path) {
        const auto grown = std::lround((P_end - P) / width);
        const long increments = grown == 0 ? 2000 : std::abs(grown);
        const double Q_begin = Q;
        for (long k = 1; k <= increments; ++k) {
            Q = Q_begin +
                (Q_end - Q_begin) * static_cast<double>(k) / static_cast<double>(increments);
            if (grown < 0) {
                q.pop_back();
            } else if (grown > 0) { // a new layer takes the ratio of the increments
                q.push_back(std::clamp((Q_end - Q_begin) / (P_end - P), -f, f));
            }
            double missing = Q;
            for (const double of_layer : q) {
                missing -= of_layer * width;
            }
            for (std::size_t j = q.size(); j-- > 0 && std::abs(missing) > 1e-13;) {
                const double room = (missing > 0 ? f : -f) - q[j];
                const double taken =
                    std::abs(room * width) < std::abs(missing) ? room : missing / width;
                q[j] += taken;
                missing -= taken * width;
            }
        }
        P = P_end;
    }
    return q;
}

} // namespace

// A second way to follow a history, which shares no formula with the exact one (`jaeger1998`).
TEST_CASE("the layers of a load history agree with small increments of the load") {
    constexpr double width = 0.0005; // all forces above are whole multiples of it
    for (const LoadPath& path : load_paths) {
        CAPTURE(steps_of(path));
        const std::vector<double> q = thin_layers(path, width);
        const LoadPath layers = layers_of(made("hertz R=2 " + steps_of(path)));
        double off = 0;
        std::size_t layer = 0;
        for (std::size_t j = 0; j < q.size(); ++j) {
            while (layer + 1 < layers.size() &&
                   layers[layer].first < (static_cast<double>(j) + 0.5) * width) {
                ++layer;
            }
            off += std::abs(q[j] - layers[layer].second) * width;
        }
        CHECK(off < 0.002); // some layers are cut by an edge of a zone
    }
}

TEST_CASE("the traction after a load history obeys the law of friction") {
    const std::string places = " x=-0.9*b;-b/2;0.003*a;a/4;a/2;3/4*a;0.97*a digits=25 "
                               "quantities=pressure;shear";
    for (const std::string& profile : rubbed_profiles) {
        for (const LoadPath& path : load_paths) {
            const std::string words = profile + steps_of(path);
            CAPTURE(words);
            const SceneResult result = run_scene(made(words + places));
            for (const RowsAt& at : result.points()) {
                const Ball ratio =
                    abs(at.at(Quantity::q).value / at.at(Quantity::p).value * 2); // f = 1/2
                CHECK(at.at(Quantity::q).proved);
                CHECK(ratio.lower() <= 1);
                if (at.row(Quantity::q).state == SlipState::slip) {
                    CHECK(contains(ratio, Rational(1)));
                }
            }
        }
    }
}

// q is a sum of pressures, whose square-root cusps at the edges of the zones limit the accuracy.
TEST_CASE("the resultant of the traction after a load history is Q") {
    const Scene s = made("flat-and-rounded t=1/2 R=3 friction=1/2 [P=1] [Q=0.375] [P=0.875,Q=1/4]");
    AskedValue asked{Quantity::q};
    asked.u = Exact::parse("1/9");
    SceneValues values(s, {asked}, {15});
    const double a = values.value({Quantity::a}).value.midpoint().convert_to<double>();
    const double circle = std::acos(-1.0);
    constexpr int parts = 1000;
    double sum = 0;
    for (int k = 0; k < parts; ++k) { // x = a sin(angle), u = 2 a sin^2(pi/4 - angle/2)
        const double angle = circle * ((2 * k + 1) / (2.0 * parts) - 0.5);
        asked.u = Exact::of(exact_rational(2 * a * std::pow(std::sin(circle / 4 - angle / 2), 2)));
        sum += values.value(asked).value.midpoint().convert_to<double>() * a * std::cos(angle) *
               circle / parts;
    }
    CHECK(std::abs(sum - 0.25) < 1e-4);
}

namespace {

/// Each step of a path divided into 16 parts.
LoadPath divided(const LoadPath& path) {
    LoadPath fine;
    std::pair<double, double> from = path.back();
    for (const auto& [P, Q] : path) {
        for (int k = 1; k <= 16; ++k) {
            fine.emplace_back(from.first + (P - from.first) * k / 16,
                              from.second + (Q - from.second) * k / 16);
        }
        from = {P, Q};
    }
    return fine;
}

/// The displacement of the bodies: a punch of force kappa dL over the length D moves them by
/// -(2/(pi E*)) kappa ln D dL (docs/partial-slip.md); `logs` has ln D at the middle of each part of
/// L up to 3/2.
double moved_by(const LoadPath& layers, const std::vector<double>& logs) {
    double moved = 0;
    double from = 0;
    const double part = 1.5 / static_cast<double>(logs.size());
    for (const auto& [force, ratio] : layers) {
        for (std::size_t i = 0; i < logs.size(); ++i) {
            const double lo = std::max(from, part * static_cast<double>(i));
            const double hi = std::min(force, part * static_cast<double>(i + 1));
            moved -= hi > lo ? ratio * (hi - lo) * logs[i] * 2 / std::acos(-1.0) : 0;
        }
        from = force;
    }
    return moved;
}

} // namespace

// D(L) comes from the edges of the contacts.
TEST_CASE("the energy of a cycle is the area of the loop of shear force and displacement") {
    const std::vector<LoadPath> passes{{{1, -0.2}, {1, 0.3}},
                                       {{1.25, 0.25}, {0.75, -0.25}, {1, 0.3}},
                                       {{1.5, -0.375}, {0.625, 0.125}, {1, 0.0625}, {1, 0.3}},
                                       {{0.5, 0.125}, {0.5, -0.125}, {1, 0.3}}};
    std::vector<std::string> profiles = rubbed_profiles;
    profiles.emplace_back("piecewise symmetric knots=1/2 slopes=x/2+x^3;3/8+2*sinh(x-1/2) ");
    const LoadPath first{{1, 0.1}, {1, 0.3}};
    for (const std::string& profile : profiles) {
        CAPTURE(profile);
        std::vector<double> logs;
        for (int i = 0; i < 60; ++i) {
            const Scene s = made(profile + "P=" + std::to_string(0.025 * i + 0.0125));
            SceneValues values(s, {{Quantity::a}}, {10});
            const Ball D = values.value({Quantity::a}).value + values.value({Quantity::b}).value;
            logs.push_back(std::log(D.midpoint().convert_to<double>()));
        }
        for (const LoadPath& pass : passes) {
            CAPTURE(steps_of(pass));
            // The first pass reaches the steady state, the next one is measured.
            LoadPath path = first;
            path.insert(path.end(), pass.begin(), pass.end());
            const std::size_t begin = path.size();
            const LoadPath fine = divided(pass);
            path.insert(path.end(), fine.begin(), fine.end());
            Scene states = made("hertz R=2 " + steps_of(path)); // the layers are those of all
            double area = 0;
            double before = 0;
            for (std::size_t k = begin; k <= path.size(); ++k) {
                set_step(states, k);
                const double moved = moved_by(layers_of(states), logs);
                area += k == begin
                            ? 0
                            : (path[k - 1].second + path[k - 2].second) / 2 * (moved - before);
                before = moved;
            }
            std::string words = profile + steps_of(first);
            for (std::size_t i = 0; i < pass.size(); ++i) {
                words += " [P=" + std::to_string(pass[i].first) +
                         ",Q=" + std::to_string(pass[i].second) + (i == 0 ? ",cycles=2]" : "]");
            }
            const Scene s = made(words);
            CHECK(s.history->steady);
            const double energy = number_of(s, {Quantity::cycle_energy});
            CHECK(std::abs(area - energy) < 1.5e-2 * energy);
            CHECK(energy > 1e-4);
        }
    }
}

TEST_CASE("energies of histories: cycles that are not steady, and what is not computed") {
    const std::string loop = "hertz R=2 friction=1/2 [P=1] ";
    CHECK_FALSE(made(loop + "[Q=0.4] [Q=0]").history->steady);
    Scene part = made(loop + "[Q=0.4,cycles=3] [Q=0]");
    set_step(part, 6);
    CHECK(lack_of(part, {Quantity::cycle_energy})->problem.find("not the end of a cycle") !=
          std::string::npos);
    set_step(part, 5);
    CHECK_FALSE(lack_of(part, {Quantity::cycle_energy}));
    CHECK(part.history->steady);
    CHECK(lack_of(made("hertz R=2 P=1 Q=1/5 friction=1/2"), {Quantity::step_energy})
              ->problem.find("no steps") != std::string::npos);
    const auto lack_for = [](const std::string& slopes) {
        const auto lack = lack_of(made("piecewise " + slopes + " friction=1/2 [P=1] [P=1,Q=0.4]"),
                                  {Quantity::step_energy});
        return lack ? lack->problem : "";
    };
    CHECK(lack_for("symmetric slopes=x+x^3").empty());
    CHECK(lack_for("knots=0 slopes=x;x+x^3").find("not symmetric") != std::string::npos);
    CHECK(lack_for("symmetric knots=1/4 slopes=0;(x-1/4)^(3/2)").find("not analytic") !=
          std::string::npos);
}

TEST_CASE("the dissipation at all places of the slip zones adds up to the energy of a cycle") {
    const Scene s = made("hertz R=2 a=1 E1=2 nu1=0.3 E2=2 nu2=0.3 friction=0.6 Q=0.1");
    AskedValue asked{Quantity::dissipation};
    asked.in_body = BodyPoint{};
    const auto density = [&](double x) {
        asked.place =
            Place::parse(std::to_string(x), Place::From::origin, {}).distance(Edge::right);
        asked.reference = asked.place;
        return number_of(s, asked);
    };
    const double from = number_of(s, {Quantity::stick_a});
    const double circle = std::acos(-1.0);
    double sum = 0;
    constexpr int parts = 40; // trapezoidal rule in t, x = from + (1 - from) sin^2(t/2)
    for (int i = 1; i < parts; ++i) {
        const double t = circle * i / parts;
        const double x = from + (1 - from) * (1 - std::cos(t)) / 2;
        sum += density(x) * (1 - from) * std::sin(t) * circle / parts / 2;
    }
    // The places have six decimals.
    CHECK(2 * sum == doctest::Approx(number_of(s, {Quantity::cycle_energy})).epsilon(1e-5));
    CHECK(density(0.1) == 0);
}

TEST_CASE("the state of a place, and a tension that is not in proportion") {
    const std::string words = "hertz R=1 P=1 Q=0.3 friction=0.6 u=0.1;0.8 quantities=shear;slip ";
    const SceneResult mild = run_scene(made(words + "bulk_tension=0.3"));
    CHECK(mild.in_proportion);
    CHECK_FALSE(run_scene(made(words + "bulk_tension=0.39")).in_proportion);
    CHECK(mild.points()[0].row(Quantity::q).state == SlipState::slip);
    CHECK(mild.points()[1].row(Quantity::q).state == SlipState::stick);
}

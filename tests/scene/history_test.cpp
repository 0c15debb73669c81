// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/quadrature/tanh_sinh.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <ios>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const history_profiles[] = {
    "kind = \"hertz\"\nR = \"2\"",
    "kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"3\"",
    "kind = \"power-law\"\nm = \"5/8\"\nC = \"1/3\"",
    "kind = \"tilted-wedge\"\nphi = \"1/3\"\nalpha = \"1/10\"",
    "kind = \"tilted-flat-and-rounded\"\nalpha = \"1/20\"\nt = \"1/2\"\nR = \"3\"",
};

/// (P, Q) at the ends of the steps.
using LoadPath = std::vector<std::pair<double, double>>;

std::string history_text(const std::string& profile, const LoadPath& path,
                         const std::string& rest = "") {
    std::string text = "[profile]\n" + profile +
                       "\n[load]\ncontact_modulus = \"1\"\n[shear]\nfriction = \"1/2\"\n";
    for (const auto& [P, Q] : path) {
        text += "[[step]]\nP = \"" + std::to_string(P) + "\"\nQ = \"" + std::to_string(Q) + "\"\n";
    }
    return text + rest;
}

Real history_number(const Ball& x) { return at_working_precision(x.midpoint()); }

/// q or another quantity at a place x.
Real history_value(const scene::Scene& s, scene::Quantity quantity, const Real& x,
                   std::optional<contact::SlipState>* state = nullptr) {
    scene::Scene asked = s;
    const std::string place = x.str(30, std::ios_base::scientific);
    asked.ask = scene::Ask{};
    asked.ask.digits = {25, Rounding::nearest, false};
    asked.ask.u.push_back({Exact(), 0});
    asked.ask.u[0].place = scene::Place::parse(place, scene::Place::From::origin, {});
    asked.ask.quantities = {scene::QuantityGroup::pressure, scene::QuantityGroup::shear};
    const scene::SceneResult result = run_scene(asked);
    const scene::Row row = result.points().at(0).row(quantity);
    CHECK(row.value->proved);
    if (state != nullptr) {
        *state = row.state;
    }
    return history_number(row.value->value);
}

std::string history_refusal(const std::string& text) {
    try {
        (void)run_scene(scene::parse_scene(text, "steps.toml"));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// The loads of drawn histories, all with |Q| < P/2.
std::vector<LoadPath> load_paths() {
    return {{{1, 0}, {1, 0.3}},
            {{1, 0}, {1, 0.3}, {1, -0.1}},
            {{1, 0.2}},
            {{1, 0.2}, {1.5, 0.7}},
            {{1, 0}, {1, 0.4}, {0.9, 0.3}, {0.9, -0.2}, {1.4, -0.1}},
            {{2, 0.5}, {1, -0.2}, {1.25, -0.25}, {0.75, 0.25}, {0.75, 0.0}, {0.75, 0.1}}};
}

} // namespace

// A second way to follow a history, which shares no formula with the exact one: the contact is a
// pile of thin layers dL, each carries a shear force of at most f dL, and small increments of the
// load are taken up from the newest layer inwards (`jaeger1998`).
TEST_CASE("the layers of a load history agree with small increments of the load") {
    constexpr double f = 0.5;
    constexpr double width = 0.0005; // all forces below are whole multiples of it
    for (const LoadPath& path : load_paths()) {
        std::vector<double> q; // shear force of each layer, by dL
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
                double carried = 0;
                for (const double of_layer : q) {
                    carried += of_layer * width;
                }
                double missing = Q - carried;
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
        const std::size_t top = q.size();
        const scene::Scene s = scene::parse_scene(history_text(history_profiles[0], path), "steps");
        REQUIRE(s.history);
        double off = 0;
        std::size_t layer = 0;
        for (std::size_t j = 0; j < top; ++j) {
            const double middle = (static_cast<double>(j) + 0.5) * width;
            while (layer + 1 < s.history->layers.size() &&
                   s.history->layers[layer].force.to<double>() < middle) {
                ++layer;
            }
            off += std::abs(q[j] - s.history->layers[layer].ratio.to<double>()) * width;
        }
        CAPTURE(path.size());
        CHECK(off < 0.002); // some layers are cut by an edge of a zone
    }
}

// The traction carries Q and nowhere exceeds f p.
TEST_CASE("the traction after a load history carries Q and obeys the law of friction") {
    const PrecisionScope precision(30);
    for (const char* profile : history_profiles) {
        for (const LoadPath& path : load_paths()) {
            CAPTURE(std::string(profile));
            CAPTURE(path.size());
            const scene::Scene s = scene::parse_scene(history_text(profile, path), "steps");
            const Real a = history_number(
                scene::SceneValues(s, {{scene::Quantity::a}}, {20, Rounding::nearest, false})
                    .value({scene::Quantity::a})
                    .value);
            const Real b = history_number(
                scene::SceneValues(s, {{scene::Quantity::b}}, {20, Rounding::nearest, false})
                    .value({scene::Quantity::b})
                    .value);
            for (int k = 1; k < 8; ++k) {
                const Real x = -b + (a + b) * (k * Real("0.1237") + Real("0.003"));
                std::optional<contact::SlipState> state;
                const Real q = history_value(s, scene::Quantity::q, x, &state);
                const Real p = history_value(s, scene::Quantity::p, x);
                CHECK(abs(q) <= p / 2 * Real("1.00000000000000000001"));
                if (state == contact::SlipState::slip) {
                    CHECK(abs(Real(abs(q) - p / 2)) < p * Real("1e-20"));
                }
            }
        }
    }
}

// The moments of q by quadrature: q is a sum of pressures, whose square-root cusps at the edges of
// the zones limit the accuracy.
TEST_CASE("the resultant of the traction after a load history") {
    const PrecisionScope precision(30);
    const LoadPath path{{1, 0}, {1, 0.375}, {0.875, 0.25}};
    const scene::Scene s = scene::parse_scene(history_text(history_profiles[1], path), "steps");
    scene::AskedValue first{scene::Quantity::q};
    first.u = Exact::parse("1/9");
    scene::SceneValues values(s, {first}, {15, Rounding::nearest, false});
    const Real a = history_number(values.value({scene::Quantity::a}).value);
    constexpr int parts = 4000;
    Real sum = 0;
    for (int k = 0; k < parts; ++k) { // x = a sin(angle), u = 2 a sin^2(pi/4 - angle/2)
        const Real angle = edgeproof::pi<Real>() * (Real(2 * k + 1) / (2 * parts) - Real(1) / 2);
        const Real half = sin(Real(edgeproof::pi<Real>() / 4 - angle / 2));
        scene::AskedValue asked{scene::Quantity::q};
        asked.u = Exact::parse(Real(2 * a * half * half).str(25, std::ios_base::scientific));
        sum += history_number(values.value(asked).value) * a * cos(angle) * edgeproof::pi<Real>() /
               parts;
    }
    CHECK(abs(Real(sum - Real("0.25"))) < Real("1e-5"));
}

TEST_CASE("a history of one step of Q is the partial slip of a scene without steps") {
    const char* const ask =
        "[ask]\nx = [\"-1/5\", \"1/3\", \"4/5\"]\ndigits = 30\n"
        "points = [[\"1/3\", \"1/5\"], [\"-2\", \"0\"]]\nquantities = [\"pressure\", "
        "\"shear\", \"stress\", \"displacement\"]\n";
    for (const char* profile : history_profiles) {
        CAPTURE(std::string(profile));
        const scene::SceneResult by_steps = run_scene(
            scene::parse_scene(history_text(profile, {{1, 0}, {1, 0.25}}, ask), "steps.toml"));
        const scene::SceneResult plain = run_scene(scene::parse_scene(
            "[profile]\n" + std::string(profile) +
                "\n[load]\nP = \"1\"\ncontact_modulus = \"1\"\n[shear]\nQ = \"1/4\"\nfriction = "
                "\"1/2\"\n" +
                ask,
            "plain.toml"));
        REQUIRE(by_steps.rows.size() > 10);
        std::size_t compared = 0;
        for (const scene::Row& row : by_steps.rows) {
            for (const scene::Row& other : plain.rows) {
                if (other.asked.quantity == row.asked.quantity && other.point == row.point &&
                    other.asked.edge == row.asked.edge && row.value && other.value) {
                    CHECK(overlaps(row.value->value, other.value->value));
                    ++compared;
                }
            }
        }
        CHECK(compared > 10);
    }
}

// The steps of a body of revolution are total forces: each state of an increasing P is that of a
// scene without steps, and so is one step of Q.
TEST_CASE("the steps of bodies of revolution are total forces") {
    for (const char* profile :
         {"kind = \"hertz\"\nR = \"2\"", "kind = \"power-law\"\nm = \"3/2\"\nC = \"1/3\"",
          "kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = \"3\""}) {
        CAPTURE(std::string(profile));
        const std::string round = std::string("geometry = \"axisymmetric\"\n") + profile;
        const std::string ask = "[ask]\nu = [\"1/100\", \"a/2\", \"a\"]\ndigits = 25\n";
        for (const auto& each :
             {std::pair{std::size_t{1}, "P = \"1/2\"\n"}, std::pair{std::size_t{2}, "P = 1\n"},
              std::pair{std::size_t{3}, "P = 1\n"}}) {
            const auto& count = each.first;
            const auto& loads = each.second;
            CAPTURE(count);
            scene::Scene steps = scene::parse_scene(
                history_text(round, {{0.5, 0}, {1, 0}, {1, 0.25}}, ask), "steps");
            set_step(steps, count);
            const scene::SceneResult after = run_scene(steps);
            const scene::SceneResult plain = run_scene(scene::parse_scene(
                "[profile]\n" + round + "\n[load]\n" + loads + "contact_modulus = \"1\"\n" +
                    (count == 3 ? "[shear]\nQ = \"1/4\"\nfriction = \"1/2\"\n" : "") + ask,
                "plain"));
            REQUIRE(after.rows.size() == plain.rows.size());
            for (std::size_t i = 0; i < plain.rows.size(); ++i) {
                REQUIRE(after.rows[i].asked.quantity == plain.rows[i].asked.quantity);
                CHECK(overlaps(after.rows[i].value->value, plain.rows[i].value->value));
                CHECK(after.rows[i].value->proved);
            }
        }
    }
}

// johnson1985, section 7.4 (after Mindlin and Deresiewicz): Q is unloaded from Q_1 to 0 at constant
// P; the zone |x| > c' slips back, with c'/a = (1 - (Q_1 - Q)/(2 f P))^(1/2) for cylinders, and
// there q = -f p.
TEST_CASE("unloading of the shear force of a cylinder") {
    const scene::Scene s = scene::parse_scene(
        history_text(history_profiles[0], {{1, 0}, {1, 0.375}, {1, 0}}), "steps.toml");
    const Ball stick =
        scene::SceneValues(s, {{scene::Quantity::stick_a}}, {30, Rounding::nearest, false})
            .value({scene::Quantity::stick_a})
            .value;
    const Ball a = scene::SceneValues(s, {{scene::Quantity::a}}, {30, Rounding::nearest, false})
                       .value({scene::Quantity::a})
                       .value;
    CHECK(overlaps(stick * stick, a * a * Ball(Rational(5, 8), stick.bits())));
}

// Cylinders with g' = x/2 and E* = 1, P = pi a^2/8. A part of q in proportion to the pressure of
// the half-width a moves x by minus the ratio times this (johnson1985, eqs. 2.24 and 4.41: the
// strain is that of PV int p/(x - s) ds = pi (x - sqrt(x^2 - a^2))/4). The slip is the change of
// u_A - u_B since P rose to pi x^2/8, relative to the middle.
TEST_CASE("the slip displacement of a history is the movement since the place came into contact") {
    const auto half_width = [](double P) { return std::sqrt(8 * P / std::acos(-1.0)); };
    using Layers = std::vector<std::pair<double, double>>; // force, ratio
    const auto moved = [&](const Layers& layers, double x) {
        double sum = 0;
        for (std::size_t j = 0; j < layers.size(); ++j) {
            const double a = half_width(layers[j].first);
            // At the edge both terms cancel, and their rounding errors are like the root of theirs.
            const double beyond = x > a * (1 + 1e-12)
                                      ? x * std::sqrt(x * x - a * a) - a * a * std::acosh(x / a)
                                      : 0.0;
            const double next = j + 1 < layers.size() ? layers[j + 1].second : 0.0;
            sum -= (layers[j].second - next) * (x * x - beyond) / 4;
        }
        return sum;
    };
    const auto slip = [](const LoadPath& path, double x) {
        const scene::SceneResult result = run_scene(scene::parse_scene(
            history_text(history_profiles[0], path,
                         "[ask]\nx = [\"" + std::to_string(x) +
                             "\"]\ndigits = 15\nquantities = [\"displacement\"]\n"),
            "steps.toml"));
        return result.at_places(scene::QuantityRow::Place::surface)
            .at(0)
            .at(scene::Quantity::slip_displacement)
            .value;
    };
    const LoadPath grown{{1, 0.1}, {2, 0.3}};
    const LoadPath reversed{{1, 0.1}, {2, 0.3}, {2, -0.6}};
    const LoadPath reloaded{{1, 0.1}, {2, 0.3}, {1.2, -0.2}, {1.8, 0}};
    struct Case {
        LoadPath path;
        double force; ///< P when the place comes into contact
        Layers then;
        Layers now;
    };
    const std::vector<Case> cases{
        {reversed, 1.5, {{1, 0.1}, {1.5, 0.2}}, {{2.0 / 3, 0.1}, {2, -0.5}}},
        {reversed, 0.9, {{0.9, 0.1}}, {{2.0 / 3, 0.1}, {2, -0.5}}},
        {reloaded, 1.1, {{1, 0.1}, {1.1, 0.2}}, {{2.0 / 3, 0.1}, {1.2, -0.5}, {1.8, 1.0 / 3}}},
    };
    for (const auto& each : cases) {
        const auto& path = each.path;
        const auto& force = each.force;
        const auto& then = each.then;
        const auto& now = each.now;
        const double x = std::stod(std::to_string(half_width(force)));
        Layers exact = then;
        exact.back().first = std::acos(-1.0) * x * x / 8;
        const double expected = moved(now, x) - moved(exact, x);
        CAPTURE(force);
        CHECK(std::abs(expected) > 1e-3);
        CHECK(slip(path, x).midpoint().convert_to<double>() ==
              doctest::Approx(expected).epsilon(1e-11));
        CHECK(slip(path, -x).midpoint().convert_to<double>() ==
              doctest::Approx(expected).epsilon(1e-11));
    }
    for (const double force : {0.5, 1.5}) {
        const Ball none = slip(grown, half_width(force));
        CHECK((none.is_exact() && contains_zero(none)));
    }
    const Ball again = slip(reloaded, half_width(1.6)); // it left the contact, and stuck since then
    CHECK((again.is_exact() && contains_zero(again)));
    const scene::Scene stuck =
        scene::parse_scene(history_text(history_profiles[0], grown), "steps.toml");
    const Ball size =
        scene::SceneValues(stuck, {{scene::Quantity::slip}}, {20, Rounding::nearest, false})
            .value({scene::Quantity::slip})
            .value;
    CHECK((size.is_exact() && contains_zero(size)));
    CHECK_THROWS_WITH_AS((void)slip({{1, 0}, {2, 0.9}}, half_width(1.5)),
                         doctest::Contains("while the edges slipped"), Error);
    CHECK(certainly_negative(slip({{1, 0}, {2, 0.9}}, half_width(0.9))));
}

// A step that leaves out a load keeps that of the step before, also in later passes.
TEST_CASE("cycles repeat the steps from one to the last") {
    const std::string head = "[profile]\n" + std::string(history_profiles[0]) +
                             "\n[load]\ncontact_modulus = \"1\"\n[shear]\nfriction = \"1/2\"\n";
    const std::string first = "[[step]]\nP = \"1\"\n";
    const std::string grow = "[[step]]\nQ = \"0.3\"\n";
    const std::string rest = "[[step]]\nP = \"1.25\"\n[[step]]\nQ = \"-1/4\"\n";
    const auto history = [&](const std::string& steps) {
        return scene::parse_scene(head + steps, "steps.toml");
    };
    const std::string again = grow + rest;
    const scene::Scene by_cycles = history(first + grow + "cycles = 3\n" + rest);
    const scene::Scene explicitly = history(first + again + again + again);
    REQUIRE(by_cycles.steps.size() == 10);
    REQUIRE(explicitly.steps.size() == 10);
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(by_cycles.steps[i].P == explicitly.steps[i].P);
        CHECK(by_cycles.steps[i].Q == explicitly.steps[i].Q);
    }
    CHECK(by_cycles.steps[4].P.text() == "1.25");
    REQUIRE(by_cycles.history->layers.size() == explicitly.history->layers.size());
    for (std::size_t j = 0; j < by_cycles.history->layers.size(); ++j) {
        const auto& one = by_cycles.history->layers[j];
        const auto& other = explicitly.history->layers[j];
        CHECK(one.force.to<double>() == other.force.to<double>());
        CHECK(one.ratio.to<double>() == other.ratio.to<double>());
    }
    CHECK(history_refusal(head + first + "cycles = 2\n" + grow + "cycles = 2\n")
              .find("cycles is given in two steps") != std::string::npos);
    for (const char* count : {"0", "1001", "\"2\"", "1.5"}) {
        CAPTURE(count);
        CHECK_FALSE(history_refusal(head + first + "cycles = " + count + "\n").empty());
    }
}

// Return-point memory: at constant P each pass ends in the state of the first.
TEST_CASE("at constant P the first cycle is the steady state") {
    for (const std::string cycles : {"1", "2", "5"}) {
        const scene::Scene s = scene::parse_scene(
            "[profile]\n" + std::string(history_profiles[0]) +
                "\n[load]\ncontact_modulus = \"1\"\n[shear]\nfriction = \"1/2\"\n"
                "[[step]]\nP = \"1\"\n[[step]]\nQ = \"0.4\"\ncycles = " +
                cycles + "\n[[step]]\nQ = \"-0.2\"\n[[step]]\nQ = \"0.1\"\n",
            "steps.toml");
        // The layers, found by hand: from 0.4 (slip outside L = 1/5) down by 0.6 (outside 2/5),
        // then up by 0.3 (outside 7/10).
        REQUIRE(s.history->layers.size() == 4);
        const double forces[] = {0.2, 0.4, 0.7, 1};
        const double ratios[] = {0, 0.5, -0.5, 0.5};
        for (std::size_t j = 0; j < 4; ++j) {
            CHECK(s.history->layers[j].force.to<double>() == doctest::Approx(forces[j]));
            CHECK(s.history->layers[j].ratio.to<double>() == doctest::Approx(ratios[j]));
        }
    }
}

TEST_CASE("load histories that are not computed are refused") {
    const std::string hertz = history_profiles[0];
    CHECK(history_refusal(history_text(hertz, {{1, 0}, {1, 0.6}})).find("slide") !=
          std::string::npos);
    CHECK(history_refusal(history_text(hertz, {{1, 0}, {0, 0}})).find("no contact") !=
          std::string::npos);
    CHECK(history_refusal(history_text(hertz, {{1, 0.1}, {-1, 0}, {1, 0.2}}))
              .find("ends without contact") != std::string::npos);
    const std::string tension = "[[step]]\nbulk_tension = \"1/100\"\n";
    CHECK(history_refusal(history_text(hertz, {{1, 0}, {1, 0.1}}, tension)).find("applied once") !=
          std::string::npos);
    CHECK(history_refusal("[profile]\n" + hertz +
                          "\n[load]\nM = \"1\"\ncontact_modulus = \"1\"\n[[step]]\nP = \"1\"\n")
              .find("in addition to the steps") != std::string::npos);
    CHECK(history_refusal("[profile]\n" + hertz +
                          "\n[load]\nP = \"1\"\ncontact_modulus = \"1\"\n[[step]]\nP = \"1\"\n")
              .find("in addition to the steps") != std::string::npos);
    CHECK(history_refusal("[profile]\n" + hertz +
                          "\n[load]\ncontact_modulus = \"1\"\n[[step]]\nP = \"1\"\nQ = \"0.1\"\n")
              .find("needs a friction") != std::string::npos);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

using namespace edgeproof::scenes;
using scene::Body, scene::Quantity;

namespace {

const std::string equal_bodies = "E1 = 2\nnu1 = 0.3\nE2 = 2\nnu2 = 0.3\n";

/// One value of the surface of a body at the place x, with the displacement 0 at `reference`.
std::optional<Ball> surface_value(const std::string& text, Quantity quantity, const std::string& x,
                                  Body body = Body::A, const std::string& reference = "0.3") {
    Scene scene = parsed(text + "[ask]\ndigits = 16\nx = [\"" + x + "\"]\nreference = \"" +
                         reference + "\"\nquantities = [\"displacement\", \"surface\"]\n");
    scene.ask.surface_of = body;
    const SceneResult result = run_scene(scene);
    for (const scene::RowsAt& at : result.at_places(scene::QuantityRow::Place::surface)) {
        const scene::Row* const row = at.find(quantity);
        if (row != nullptr && row->value) {
            CHECK(row->value->proved);
            return row->value->value;
        }
    }
    return {};
}

bool is_surface_value(const std::optional<Ball>& found, const char* expected) {
    const Ball value = formula::enclosed_constant(Exact::parse(expected), 128);
    return found && abs(Ball(*found - value)).upper() < Real("1e-13");
}

} // namespace

// mpmath 1.3 at 25 digits: p = (E*/4) sqrt(1 - x^2) and q of full stick (Johnson, eq. 7.22), their
// integrals with ln|x - s|, and the integrals of p and q from the reference 0.3 (johnson1985, eqs.
// 2.25, integrated).
TEST_CASE("displacements of the surface under full stick, of both bodies") {
    const std::string plain =
        "[profile]\nkind = \"power-law\"\nm = 1\nC = \"1/2\"\n[load]\na = 1\n" + equal_bodies +
        "[shear]\nQ = 0.1\n";
    struct Row {
        const char* x;
        const char* ux;
        const char* uz;
    };
    for (const Row& row : {Row{"-2", "0.0390552611093046711", "-0.235878689007920368"},
                           Row{"-0.9", "0.0751051726556348858", "-0.101788930163191273"},
                           Row{"0.6", "-0.0190223819411715476", "-0.0309460019023601658"},
                           Row{"0.95", "-0.0342499602852434851", "-0.0937123020112483922"},
                           Row{"1.5", "-0.0628749667457478368", "-0.170193237158833215"},
                           Row{"30", "-0.153586763629737548", "-0.552547358126424291"}}) {
        CAPTURE(row.x);
        CHECK(is_surface_value(surface_value(plain, Quantity::ux, row.x), row.ux));
        CHECK(is_surface_value(surface_value(plain, Quantity::uz, row.x), row.uz));
    }
    const std::string tension = plain + "bulk_tension = 0.05\n";
    for (const Row& row : {Row{"-2", "0.0694852138999834586", "-0.207935683843450223"},
                           Row{"-0.9", "0.0614551726556348163", "-0.0798947300847630819"},
                           Row{"0.6", "-0.0156098819411715289", "-0.0370543005022449075"},
                           Row{"1.5", "0.0192481810567482315", "-0.194250231994363013"},
                           Row{"30", "0.762490205294060527", "-0.576604352961954089"}}) {
        CAPTURE(row.x);
        CHECK(is_surface_value(surface_value(tension, Quantity::ux, row.x, Body::B), row.ux));
        CHECK(is_surface_value(surface_value(tension, Quantity::uz, row.x, Body::B), row.uz));
    }
}

// The bodies approach each other by the gap less the profile, and u_A - u_B is the slip; the slip
// follows from the gap of the stick zone alone.
TEST_CASE("displacements of both bodies add up to the gap and to the slip") {
    struct Shape {
        std::string profile;
        std::string a;
        double (*g)(double x); ///< the integral of g' from 0
    };
    const Shape bodies[] = {
        {"kind = \"flat-and-rounded\"\nt = \"1/2\"\nR = 2\n", "1",
         [](double x) { return std::pow(std::max(std::abs(x) - 0.5, 0.0), 2) / 4; }},
        {"kind = \"tilted-flat-and-rounded\"\nt = \"1/2\"\nR = 2\nalpha = \"1/20\"\n", "1",
         [](double x) {
             return x > -0.1   ? x * x / 4
                    : x > -1.1 ? 0.0025 - (x + 0.1) / 20
                               : 0.0525 + ((x + 1) * (x + 1) - 0.01) / 4;
         }},
        {"kind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\n"
         "slopes = [\"x/10\", \"x/5 + 1/20\"]\n",
         "3/4",
         [](double x) {
             return std::abs(x) < 0.5 ? x * x / 20
                                      : 0.0125 + (x * x - 0.25) / 10 + (std::abs(x) - 0.5) / 20;
         }},
        {"kind = \"power-law\"\nm = \"5/2\"\nC = 1\n", "1",
         [](double x) { return std::pow(std::abs(x), 3.5) / 3.5; }}};
    for (const Shape& one : bodies) {
        CAPTURE(one.profile);
        for (const std::string steps : {"", "reversed"}) {
            const std::string head = "[profile]\n" + one.profile + "[load]\n" + equal_bodies;
            const std::string text =
                steps.empty() ? head + "a = \"" + one.a + "\"\n[shear]\nfriction = 0.6\nQ = 0.01\n"
                              : head + "[shear]\nfriction = 0.6\n[[step]]\nP = 0.05\n[[step]]\nQ = "
                                       "0.02\n[[step]]\nQ = -0.01\n";
            for (const std::string x : {"-1.4", "-0.45", "0.1", "0.55", "0.72", "1.3"}) {
                CAPTURE(x);
                const auto ux = surface_value(text, Quantity::ux, x, scene::Body::A, "0");
                const auto other = surface_value(text, Quantity::ux, x, scene::Body::B, "0");
                REQUIRE(ux);
                if (const auto slip = surface_value(text, Quantity::slip_displacement, x)) {
                    CHECK(abs(Ball(*ux - *other - *slip)).upper() < Real("1e-14"));
                }
                const Ball uz = *surface_value(text, Quantity::uz, x, scene::Body::A, "0") +
                                *surface_value(text, Quantity::uz, x, scene::Body::B, "0");
                const auto gap = surface_value(text, Quantity::gap, x);
                const double expected =
                    (gap ? gap->midpoint().convert_to<double>() : 0) - one.g(std::stod(x));
                CHECK(uz.midpoint().convert_to<double>() ==
                      doctest::Approx(expected).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("the dissipation at all places of the slip zones adds up to the energy of a cycle") {
    const std::string text = "[profile]\nkind = \"hertz\"\nR = 2\n[load]\na = 1\n" + equal_bodies +
                             "[shear]\nfriction = 0.6\nQ = 0.1\n";
    const Scene plain = parsed(text);
    const auto number = [&](Quantity quantity) {
        return SceneValues(plain, {{quantity}}, {20, Rounding::nearest, false})
            .value({quantity})
            .value.midpoint()
            .convert_to<double>();
    };
    const double from = number(Quantity::stick_a);
    double sum = 0;
    constexpr int parts = 40; // trapezoidal rule in t, x = from + (1 - from) sin^2(pi t/2)
    for (int i = 1; i < parts; ++i) {
        const double t = std::acos(-1.0) * i / parts;
        const double x = from + (1 - from) * (1 - std::cos(t)) / 2;
        const auto density = surface_value(text, Quantity::dissipation, std::to_string(x));
        REQUIRE(density);
        sum += density->midpoint().convert_to<double>() * (1 - from) * std::sin(t) *
               std::acos(-1.0) / parts / 2;
    }
    // The places have six decimals.
    CHECK(2 * sum == doctest::Approx(number(Quantity::cycle_energy)).epsilon(1e-5));
    CHECK(contains_zero(*surface_value(text, Quantity::dissipation, "0.1")));
    CHECK_FALSE(surface_value(text, Quantity::dissipation, "1.1"));
}

TEST_CASE("displacements of a surface that are refused") {
    const auto refusal = [](const std::string& load, const std::string& ask) {
        try {
            static_cast<void>(
                run_scene(parsed("[profile]\nkind = \"hertz\"\nR = 2\n[load]\n" + load +
                                 "[ask]\nx = [\"0\"]\nquantities = [\"surface\"]\n" + ask)));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string load = "a = 1\ncontact_modulus = 1\n";
    CHECK(refusal(load, "reference = 0\n").find("Poisson's ratio") != std::string::npos);
    CHECK(refusal(load + "nu = 0.3\n", "").find("give a reference") != std::string::npos);
    CHECK(refusal(load + "nu = 0.3\n", "reference = 0\n").empty());
}

// The whole force lies on one side of an edge, so that ux there is -(1 - 2 nu) (1 + nu)/E times
// half the force, from the middle of a symmetric contact. g falls by g(a) from the middle to an
// edge, and each of two equal bodies takes half of that: a^2/(2R) = 2P/pi of a cylinder (a^2 = 4 P
// R/(pi E*)), phi a = P/E* of a wedge.
TEST_CASE("displacements at an edge that follows from the force") {
    const std::string load = "[load]\nP = 1\ncontact_modulus = 1\nnu = 0.3\n";
    const std::pair<std::string, const char*> rows[] = {
        {"[profile]\nkind = \"hertz\"\nR = 10\n" + load, "1/pi"},
        {"[profile]\nkind = \"power-law\"\nm = 1\nC = \"1/10\"\n" + load, "1/pi"},
        {"[profile]\nkind = \"wedge\"\nphi = 0.1\n" + load, "1/2"},
    };
    for (const auto& row : rows) {
        const std::string& text = row.first;
        CAPTURE(text);
        const std::string fall = std::string("-") + row.second;
        CHECK(is_surface_value(surface_value(text, Quantity::ux, "a", Body::A, "0"), "-1/7"));
        CHECK(is_surface_value(surface_value(text, Quantity::ux, "-b", Body::A, "0"), "1/7"));
        CHECK(is_surface_value(surface_value(text, Quantity::uz, "a", Body::A, "0"), fall.c_str()));
    }
    // Under full stick the surface is vertical there.
    for (const char* given : {"P = 1", "a = 2"}) {
        CHECK_THROWS_WITH_AS(
            (void)surface_value("[profile]\nkind = \"hertz\"\nR = 10\n[load]\n" +
                                    std::string(given) +
                                    "\ncontact_modulus = 1\nnu = 0.3\n[shear]\nQ = "
                                    "0.1\n",
                                Quantity::slope, "a", Body::A, "0"),
            doctest::Contains("slope at x = a"), Error);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Axisymmetric contacts by balls, by nested integrals of g' and by the printed formulas.
#include "edgeproof/precision/rounding/digits_right.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "lab/validation/value_routes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace {

struct RoundProfile {
    std::string text;
    std::vector<std::string> loads;
};

std::vector<RoundProfile> round_profiles() {
    const std::vector<std::string> any{"a = \"1\"", "a = \"5/4\"", "P = \"1/3\"", "P = \"20\"",
                                       "delta = \"1/2\""};
    // The edge lies 1e-12 beyond the knot at 1.
    const std::vector<std::string> beyond{"a = \"1+1e-12\"", "a = \"1+2e-12\"", "a = \"1+1e-11\"",
                                          "a = \"1+1e-9\"", "a = \"1+1e-6\""};
    const auto power = [](const char* m) {
        return std::string("kind = \"power-law\"\nC = \"3/7\"\nm = \"") + m + "\"\n";
    };
    const auto pieces = [](const char* knots, const char* slopes) {
        return std::string("kind = \"piecewise\"\nsymmetric = true\nknots = [") + knots +
               "]\nslopes = [" + slopes + "]\n";
    };
    const auto rounded = [](const char* t) {
        return std::string("kind = \"flat-and-rounded\"\nR = \"2\"\nt = \"") + t + "\"\n";
    };
    return {{power("0"), any},
            {power("1/3"), any},
            {power("1"), any},
            {power("2"), any},
            {power("sqrt(2)"), any},
            {power("7"), any},
            {rounded("1/10"), any},
            {rounded("1"), beyond},
            {pieces("\"1/5\"", "\"x\", \"1/5\""), any},
            {pieces("\"1/5\", \"2/5\"", "\"x\", \"1/5\", \"2*x - 3/5\""), any},
            {pieces("\"1\"", "\"0\", \"1/10\""), beyond},
            {pieces("\"1/5\", \"1\"", "\"x/3\", \"1/15\", \"x\""), beyond}};
}

/// The digits to which both routes agree with the enclosure at least.
unsigned least_agreement(const scene::Scene& s, const scene::AskedValue& asked) {
    constexpr unsigned digits = 50;
    const scene::BoundedValue ours = enclosed_value(s, asked, digits);
    CHECK(ours.proved);
    unsigned least = digits;
    for (const SecondRoute& route : second_routes(s, asked, digits)) {
        CAPTURE(route.route);
        least = std::min(least, digits_right(route.value, ours.value));
    }
    return least;
}

/// Compares every `step`th place; returns the number of places.
std::size_t compare_places(std::size_t step) {
    std::size_t places = 0;
    std::size_t contacts = 0;
    for (const RoundProfile& profile : round_profiles()) {
        for (const std::string& load : profile.loads) {
            const scene::Scene s =
                scene::parse_scene("[profile]\ngeometry = \"axisymmetric\"\n" + profile.text +
                                       "[load]\n" + load + "\ncontact_modulus = \"7/3\"\n",
                                   "contact.toml");
            ++contacts;
            for (const char* u :
                 {"1e-30", "1e-13", "3/2*1e-12", "1e-3", "1/10", "3/10", "17/40", "4/9", "9/20"}) {
                if (places++ % step != 0) {
                    continue;
                }
                CAPTURE(profile.text);
                CAPTURE(load);
                CAPTURE(u);
                scene::AskedValue asked{scene::Quantity::p};
                asked.u = Exact::parse(u);
                CHECK(least_agreement(s, asked) >= 49);
            }
            for (const scene::Quantity quantity : {scene::Quantity::P, scene::Quantity::delta}) {
                if (places % step == 0) {
                    CAPTURE(profile.text);
                    CAPTURE(load);
                    CHECK(least_agreement(s, scene::AskedValue{quantity}) >= 49);
                }
            }
        }
    }
    CHECK(contacts == 60);
    return places;
}

} // namespace

TEST_CASE("axisymmetric contacts agree with two other routes at some places") {
    (void)compare_places(67);
}

TEST_CASE("60 axisymmetric contacts agree with two other routes at 540 places" *
          doctest::test_suite("slow")) {
    CHECK(compare_places(1) == 540);
}

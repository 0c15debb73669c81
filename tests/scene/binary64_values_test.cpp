// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "tests/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace edgeproof::scenes;
using edgeproof::contact::Edge;

namespace {

/// E* = R = a = 1.
Scene hertz_with(const std::string& shear = "") {
    return parsed("[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\na = "
                  "\"1\"\ncontact_modulus = \"1\"\n" +
                  shear);
}

std::vector<double> computed_at(const Scene& scene, const Binary64Question& question,
                                const std::vector<double>& places) {
    std::vector<double> values(places.size(), -1);
    compute_binary64(scene, question, places, values);
    return values;
}

} // namespace

// p = sqrt(1 - x^2)/2 (johnson1985): 1/2 at x = 0, sqrt(3)/4 = 0.43301270189221932338... at x =
// 1/2.
TEST_CASE("pressures by x: nearest to the exact ones, 0 outside, infinite at a corner") {
    const Binary64Question by_x{.quantity = Quantity::p, .from_origin = true};
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<double> p =
        computed_at(hertz_with(), by_x, {0, 0.5, -0.5, 1, -1, 2, inf, -inf});
    CHECK(p[0] == 0.5);
    CHECK(p[1] == 0.4330127018922193);
    CHECK(p[2] == p[1]);
    for (std::size_t i = 3; i < p.size(); ++i) {
        CHECK(p[i] == 0);
    }
    const Scene wedge = parsed("[profile]\nkind = \"power-law\"\nm = \"0\"\nC = \"1\"\n[load]\na "
                               "= \"1\"\ncontact_modulus = \"1\"\n");
    CHECK(computed_at(wedge, by_x, {0})[0] == inf);
}

// q = Q/(pi sqrt(1 - x^2)) with Q = pi/4 (moore-hills, eqn:Shear_Adhered): 1/4 at x = 0,
// 1/(2 sqrt(3)) = 0.288675134594812882... at x = 1/2.
TEST_CASE("shear under full stick: by hand; refused at an edge and without shear") {
    const Scene scene = hertz_with("[shear]\nQ = \"pi/4\"\n");
    const Binary64Question by_x{.quantity = Quantity::q, .from_origin = true};
    CHECK(computed_at(scene, by_x, {0, 0.5, -0.5, 3}) ==
          std::vector<double>{0.25, 0.28867513459481287, 0.28867513459481287, 0});
    CHECK_THROWS_AS(computed_at(scene, by_x, {1}), InputError);
    CHECK_THROWS_AS(computed_at(hertz_with(), by_x, {0}), InputError);
    CHECK_THROWS_AS(computed_at(scene, by_x, {std::numeric_limits<double>::quiet_NaN()}),
                    DomainError);
}

// p_1 = sqrt(u/2), p = sqrt(u (2 - u))/2: p_1 = 1/2 and p_1/p = 2/sqrt(3) at u = 1/2, so that the
// error is 0.154700538379251529...; at u = 1e-200 it is u/4.
TEST_CASE("sums of terms and relative errors: by hand; refused outside") {
    Binary64Question question{.quantity = Quantity::local, .n = 1, .edge = Edge::left};
    CHECK(computed_at(hertz_with(), question, {0.5, 2e-100}) == std::vector<double>{0.5, 1e-50});
    CHECK_THROWS_AS(computed_at(hertz_with(), question, {2}), InputError);
    CHECK_THROWS_AS(computed_at(hertz_with(), question, {-1}), InputError);
    CHECK_THROWS_AS(computed_at(hertz_with(), {.quantity = Quantity::local}, {0.5}), InputError);
    question.quantity = Quantity::rel;
    CHECK(computed_at(hertz_with(), question, {0.5, 0x1p-500}) ==
          std::vector<double>{0.15470053837925152, 0x1p-502});
    question.from_origin = true;
    CHECK(computed_at(hertz_with(), question, {-0.5})[0] == 0.15470053837925152);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "tests/scene/scene_text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
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
                                const std::vector<double>& places, Edge edge = Edge::right) {
    std::vector<double> values(places.size(), -1);
    Binary64Values(scene, question)(edge, places, values);
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

// By hand, with p(0; L) = sqrt(L/pi): Q = pi/16 at P = pi/4 slips outside L = pi/8, and back to 0
// outside 3 pi/16. Mindlin: Q = 7/8 f P sticks inside r = a/2, where q = f (p - p*), p*(0) = p_0/2,
// p_0 = 2/pi.
TEST_CASE("shear of a load history and of a sphere: by hand") {
    const std::string head = "[profile]\nkind = \"hertz\"\nR = \"1\"\n";
    const Scene history =
        parsed(head + "[load]\ncontact_modulus = \"1\"\n[shear]\nfriction = \"1/2\"\n"
                      "[[step]]\nP = \"pi/4\"\n[[step]]\nQ = \"pi/16\"\n"
                      "[[step]]\nQ = \"0\"\n");
    const Binary64Question by_x{.quantity = Quantity::q, .from_origin = true};
    CHECK(computed_at(history, by_x, {0})[0] ==
          doctest::Approx((std::sqrt(3.0) - 1) / 4 - std::sqrt(2.0) / 8).epsilon(1e-13));
    const Scene sphere =
        parsed("[profile]\ngeometry = \"axisymmetric\"\nkind = \"hertz\"\nR = \"1\"\n[load]\na = "
               "\"1\"\ncontact_modulus = \"1\"\n[shear]\nQ = \"7/12\"\nfriction = \"1/2\"\n");
    const Binary64Question by_u{.quantity = Quantity::q};
    CHECK(computed_at(sphere, by_u, {1})[0] ==
          doctest::Approx(1 / (2 * std::acos(-1.0))).epsilon(1e-13));
}

TEST_CASE("arrays of axisymmetric profiles are those of single values") {
    const Scene round = parsed(
        "[profile]\ngeometry = \"axisymmetric\"\nkind = \"flat-and-rounded\"\nt = \"1/2\"\nR = "
        "\"1\"\n[load]\nP = \"1\"\ncontact_modulus = \"1\"\n[shear]\nQ = \"0.3\"\nfriction = "
        "\"1/2\"\n[ask]\nu = [\"1/8\", \"1/4\"]\nterms = 2\ndigits = 20\n");
    const SceneResult single = run_scene(round);
    for (const auto& [quantity, n] : {std::pair{Quantity::p, std::size_t{0}},
                                      {Quantity::q, std::size_t{0}},
                                      {Quantity::local, std::size_t{2}}}) {
        const std::vector<double> values =
            computed_at(round, {.quantity = quantity, .n = n}, {1.0 / 8, 1.0 / 4});
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(values[i] ==
                  single.points().at(i).at(quantity, n).value.midpoint().convert_to<double>());
        }
    }
}

// p_1 = sqrt(u/2), p = sqrt(u (2 - u))/2: p_1 = 1/2 and p_1/p = 2/sqrt(3) at u = 1/2, so that the
// error is 0.154700538379251529...; at u = 1e-200 it is u/4.
TEST_CASE("sums of terms and relative errors: by hand; refused outside") {
    Binary64Question question{.quantity = Quantity::local, .n = 1};
    CHECK(computed_at(hertz_with(), question, {0.5, 2e-100}, Edge::left) ==
          std::vector<double>{0.5, 1e-50});
    CHECK_THROWS_AS(computed_at(hertz_with(), question, {2}, Edge::left), InputError);
    CHECK_THROWS_AS(computed_at(hertz_with(), question, {-1}, Edge::left), InputError);
    CHECK_THROWS_AS(computed_at(hertz_with(), {.quantity = Quantity::local}, {0.5}), InputError);
    question.quantity = Quantity::rel;
    CHECK(computed_at(hertz_with(), question, {0.5, 0x1p-500}, Edge::left) ==
          std::vector<double>{0.15470053837925152, 0x1p-502});
    question.from_origin = true;
    CHECK(computed_at(hertz_with(), question, {-0.5}, Edge::left)[0] == 0.15470053837925152);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

using namespace edgeproof::scenes;

namespace {

std::string slip_scene(const std::string& profile_and_load, const std::string& shear,
                       const std::string& ask = "") {
    return profile_and_load + "contact_modulus = \"1\"\n[shear]\n" + shear +
           "\n[ask]\nedges = [\"right\", \"left\"]\nquantities = [\"slip\"]\n" + ask;
}

std::string hertz_under(const std::string& load) {
    return "[profile]\nkind = \"power-law\"\nm = \"1\"\nC = \"1\"\n[load]\n" + load + "\n";
}

const char* const slip_half =
    "[profile]\nkind = \"power-law\"\nm = \"1/2\"\nC = \"1\"\n[load]\na = "
    "\"1\"\n";
const char* const slip_curved =
    "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = [\"1/2\"]\n"
    "slopes = [\"x/10\", \"x/10 + (x - 1/2)^3\"]\n[load]\na = \"3/4\"\n";

std::string text_of(const BoundedValue& v, unsigned digits) { return printed(v, {digits}).text; }

/// The rows of the slip zone at one of the edges.
RowsAt slip_at(const SceneResult& result, std::size_t edge) {
    return result.at_edges(QuantityGroup::slip).at(edge);
}

void slip_refused(const std::string& text, const std::string& line) {
    try {
        (void)run_scene(parsed(text));
        CHECK_MESSAGE(false, "not refused");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find(line) != std::string::npos);
    }
}

} // namespace

TEST_CASE("friction is off unless the scene has it, and is read exactly") {
    const Scene none =
        parsed(hertz_under("P = \"1\"") +
               "contact_modulus = \"1\"\n[shear]\nQ = \"0.3\"\n[ask]\nu = \"0.1\"\n");
    CHECK_FALSE(none.slips());
    CHECK_FALSE(make_plan(none).partial_slip);
    const Scene scene = parsed(slip_scene(hertz_under("P = \"1\""),
                                          "Q = \"0.3\"\nfriction = \"0.6000000000000000000001\""));
    REQUIRE(scene.slips());
    CHECK(scene.shear->friction->rational() == parse_decimal("0.6000000000000000000001"));
    const Plan plan = make_plan(scene);
    CHECK(plan.partial_slip);
    const Counts counts = run_scene(scene).work.counts;
    CHECK(counts.stick_zones == 1);
    CHECK(counts.slip_sizes == 2);
}

TEST_CASE("slip scenes that are refused, with the line") {
    const std::string by_P = hertz_under("P = \"1\"");
    slip_refused(slip_scene(by_P, "Q = \"0.3\""), "slip is requested, but there is no friction");
    slip_refused(slip_scene(by_P, "Q = \"0.3\"\nfriction = \"0\""),
                 "scene.toml:10: friction = 0 is not positive");
    slip_refused(slip_scene(by_P, "bulk_tension = \"0.3\"\nfriction = \"0.6\""),
                 "scene.toml:10: without a shear force Q");
    slip_refused(slip_scene(by_P, "Q = \"0.3\"\npath = \"together\"\nfriction = \"0.6\""),
                 "scene.toml:11: P and Q grow together");
    // Exactly at the limit, with P given, and with the exact form P = pi/4; and beyond the limit.
    slip_refused(slip_scene(by_P, "Q = \"-0.6\"\nfriction = \"0.6\""),
                 "scene.toml:10: the contact slides: Q = -0.6, but f P = 0.6;");
    slip_refused(slip_scene(hertz_under("a = \"1\""), "Q = \"3*pi/20\"\nfriction = \"0.6\""),
                 "scene.toml:10: the contact slides");
    slip_refused(slip_scene(hertz_under("a = \"1\""), "Q = \"0.5\"\nfriction = \"0.6\""),
                 "scene.toml:10: the contact slides: Q = 0.5, but f P = 0.4712389");
    // Hertz, P = 1: a = 2/sqrt(pi); the limit is 2 f a (1 - sqrt(1 - 1/2)) = 0.396593527551...
    slip_refused(slip_scene(by_P, "Q = \"0.3\"\nbulk_tension = \"0.4\"\nfriction = \"0.6\""),
                 "scene.toml:10: bulk_tension = 0.4 moves the stick zone beyond the left edge");
    slip_refused(slip_scene(by_P, "Q = \"0.3\"\nbulk_tension = \"-0.4\"\nfriction = \"0.6\""),
                 "beyond the right edge");
    slip_refused(slip_scene(by_P, "Q = \"0.3\"\nbulk_tension = \"0.4\"\nfriction = \"0.6\""),
                 "between -0.39659353 and 0.39659353");
}

TEST_CASE("a tension within the bound but not in proportion is noted") {
    const auto result = run_scene(parsed(slip_scene(
        hertz_under("P = \"1\""), "Q = \"0.3\"\nbulk_tension = \"0.39\"\nfriction = \"0.6\"")));
    CHECK_FALSE(result.in_proportion);
    CHECK(text_of(result.at(Quantity::most_tension), 8) == "0.39659353");
    const auto mild = run_scene(parsed(slip_scene(
        hertz_under("P = \"1\""), "Q = \"0.3\"\nbulk_tension = \"0.3\"\nfriction = \"0.6\"")));
    CHECK(mild.in_proportion);
}

// Hertz: a = 2/sqrt(pi), d = a (1 - sqrt(1 - tau)).
TEST_CASE("slip zones of a scene next to no load and next to full sliding") {
    const auto tiny = run_scene(
        parsed(slip_scene(hertz_under("P = \"1\""), "Q = \"6e-31\"\nfriction = \"0.6\"")));
    CHECK(slip_at(tiny, 0).at(Quantity::slip).proved);
    // 1/sqrt(pi) 1e-30 (1 + 2.5e-31)
    CHECK(text_of(slip_at(tiny, 0).at(Quantity::slip), 30) ==
          "5.64189583547756286948079451561e-31");
    const auto full = run_scene(parsed(
        slip_scene(hertz_under("P = \"1\""), "Q = \"3/5*(1 - 1e-30)\"\nfriction = \"0.6\"")));
    // 2e-15/sqrt(pi)
    CHECK(text_of(full.at(Quantity::stick_a), 30) == "1.12837916709551257389615890312e-15");
    CHECK(full.at(Quantity::stick_a).proved);
}

// mpmath, 90 digits. Power laws: P = m a^(m + 1) B(m/2, 3/2)/2, stick zone a (1 - tau)^(1/(m + 1)).
// Flat-and-rounded punch: s^2 arccos(t/s) - t sqrt(s^2 - t^2) = 2 (1 - tau) by findroot: the whole
// flat sticks even if little force is left.
TEST_CASE("extreme profiles next to no load and next to full sliding") {
    const std::string power = "kind = \"power-law\"\nC = \"1\"\nm = ";
    const std::string flat = "kind = \"flat-and-rounded\"\nR = \"1\"\nt = ";
    const std::vector<std::array<std::string, 4>> cases{
        {power + "\"1/10\"", "6e-31", "9.340804060330132364904440e-31",
         "1.027488446636314560139488"},
        {power + "\"1/10\"", "3/5*(1 - 1e-30)", "1.027488446636314560139488",
         "5.483396803237385239952919e-28"},
        {power + "\"20\"", "6e-31", "5.068024457514661459491724e-32", "1.064285136078078906493262"},
        {power + "\"20\"", "3/5*(1 - 1e-30)", "1.024612910179387121502061",
         "0.03967222589869178499120092"},
        {flat + "\"4/5\"", "3/5*(1 - 1e-30)", "0.9205969505191793168275062",
         "0.8000000000000000000112035"},
    };
    for (const auto& [profile, Q, size, stick] : cases) {
        const auto result =
            run_scene(parsed(slip_scene("[profile]\n" + profile + "\n[load]\nP = \"1\"\n",
                                        "Q = \"" + Q + "\"\nfriction = \"0.6\"")));
        CHECK(slip_at(result, 0).at(Quantity::slip).proved);
        CHECK(result.at(Quantity::stick_a).proved);
        CHECK(text_of(slip_at(result, 0).at(Quantity::slip), 25) == size);
        CHECK(text_of(result.at(Quantity::stick_a), 25) == stick);
    }
}

// mpmath 1.3 at 55 digits, as in tests/contact/slip_scenes.hpp; q = f (p - p*) with both pressures
// from the regularised integral over theta.
TEST_CASE("q and slip zones of a scene hold values from elsewhere") {
    const std::string shear = "Q = \"0.1\"\nbulk_tension = \"0.05\"\nfriction = \"0.6\"";
    Scene scene = parsed(slip_scene(slip_half, shear, "digits = 40\nu = [\"0.1\", \"0.5\"]\n"));
    scene.ask.quantities.insert(QuantityGroup::shear);
    const auto result = run_scene(scene);
    CHECK(text_of(slip_at(result, 0).at(Quantity::slip), 40) ==
          "0.1774640036086275636295696189473192871183");
    CHECK(text_of(slip_at(result, 1).at(Quantity::slip), 40) ==
          "0.08439567788566152535576902454336858524903");
    CHECK(text_of(result.points()[0].at(Quantity::q), 35) ==
          "0.11297266969727152254342025535819661");
    CHECK(text_of(result.points()[1].at(Quantity::q), 35) ==
          "0.049880797916348512913389779294125959");
    CHECK(result.points()[0].row(Quantity::q).state == SlipState::slip);
    CHECK(result.points()[1].row(Quantity::q).state == SlipState::stick);
    CHECK(result.points()[1].at(Quantity::q).proved);
}

TEST_CASE("a curved slope slips, proved") {
    Scene scene = parsed(slip_scene(slip_curved, "Q = \"0.005\"\nfriction = \"0.6\"",
                                    "digits = 40\nterms = [1, 2]\nu = [\"0.01\", \"0.2\"]\n"));
    scene.ask.quantities.insert(QuantityGroup::shear);
    const auto result = run_scene(scene);
    CHECK(slip_at(result, 0).at(Quantity::slip).proved);
    CHECK(text_of(slip_at(result, 0).at(Quantity::slip), 40) ==
          "0.05193147625005722571264112503692018502348");
    CHECK(text_of(result.points()[0].at(Quantity::q), 35) ==
          "0.0054714134986996225492807142915063385");
    CHECK(text_of(result.points()[1].at(Quantity::q), 35) ==
          "0.0033794945997665433411066931976509986");
}

// P(1) = pi/4 within the inner parabola: there the stick zone ends on the bend, or on the corner.
TEST_CASE("a stick zone that ends on a knot exactly") {
    for (const char* outer : {"2*x - 1", "x + 1"}) {
        CAPTURE(outer);
        const std::string profile = "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = "
                                    "[\"1\"]\nslopes = [\"x\", \"" +
                                    std::string(outer) + "\"]\n[load]\nP = \"2\"\n";
        const auto result =
            run_scene(parsed(slip_scene(profile, "Q = \"3/5*(2 - pi/4)\"\nfriction = \"0.6\"")));
        CHECK(result.at(Quantity::stick_a).proved);
        CHECK(text_of(result.at(Quantity::stick_a), 30) == "1.00000000000000000000000000000");
        CHECK(text_of(result.at(Quantity::stick_b), 30) == "1.00000000000000000000000000000");
    }
}

// F(1/2) = pi/16 within the parabola. The edges are from mpmath, 40 digits, by findroot of force
// and consistency by quadrature.
TEST_CASE("a stick zone of a tilted contact that ends on a knot exactly") {
    const auto result = run_scene(parsed(
        slip_scene("[profile]\nkind = \"piecewise\"\nknots = [\"1/2\"]\nslopes = [\"x\", \"1/2 + "
                   "3*(x - 1/2)\"]\n[load]\nP = \"1\"\n",
                   "Q = \"3/5*(1 - pi/16)\"\nfriction = \"0.6\"")));
    CHECK(text_of(result.at(Quantity::stick_a), 25) == "0.5000000000000000000000000");
    CHECK(text_of(result.at(Quantity::stick_b), 25) == "0.5000000000000000000000000");
    CHECK(text_of(slip_at(result, 0).at(Quantity::slip), 25) == "0.3707355456826686726145390");
    CHECK(text_of(slip_at(result, 1).at(Quantity::slip), 25) == "0.6458749358604694503912972");
}

// Hertz, a = 1, P = pi/4, tau = 3/4: the limit is 2 f E* (a - a/2)/R = 3/5.
TEST_CASE("a bulk tension at its bound exactly") {
    const std::string by_a = hertz_under("a = \"1\"");
    const auto shear = [](const std::string& tension) {
        return "Q = \"9*pi/80\"\nbulk_tension = \"" + tension + "\"\nfriction = \"0.6\"";
    };
    slip_refused(slip_scene(by_a, shear("0.6")),
                 "scene.toml:10: bulk_tension = 0.6 moves the stick zone to the left edge");
    slip_refused(slip_scene(by_a, shear("-0.6")),
                 "scene.toml:10: bulk_tension = -0.6 moves the stick zone to the right edge");
    slip_refused(slip_scene(by_a, shear("0.6 + 1e-40")), "beyond the left edge");
    const auto within = run_scene(parsed(slip_scene(by_a, shear("0.6 - 6e-41"))));
    // c = 1/2 about -(1/2 - 5e-41)
    CHECK(text_of(slip_at(within, 1).at(Quantity::slip), 20) == "5.0000000000000000000e-41");
}

// In a mirror the edges are exchanged, and Q and sigma_0 change: the mirrored scene has -Q and the
// same tension.
TEST_CASE("a mirror exchanges the slip zones") {
    const auto one = run_scene(parsed(slip_scene(
        hertz_under("P = \"1\""), "Q = \"0.3\"\nbulk_tension = \"0.1\"\nfriction = \"0.6\"")));
    const auto other = run_scene(parsed(slip_scene(
        hertz_under("P = \"1\""), "Q = \"-0.3\"\nbulk_tension = \"0.1\"\nfriction = \"0.6\"")));
    CHECK(text_of(slip_at(one, 0).at(Quantity::slip), 40) ==
          text_of(slip_at(other, 1).at(Quantity::slip), 40));
    CHECK(text_of(slip_at(one, 1).at(Quantity::slip), 40) ==
          text_of(slip_at(other, 0).at(Quantity::slip), 40));
    CHECK(text_of(slip_at(one, 0).at(Quantity::slip), 40) !=
          text_of(slip_at(one, 1).at(Quantity::slip), 40));
}

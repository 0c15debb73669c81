// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/run_scene.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/binary64_values.hpp"
#include "edgeproof/scene/scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using scene::Body, scene::GreatestValue, scene::Quantity;

namespace {

std::string greatest_scene_text(const std::string& profile, const std::string& modulus,
                                const std::string& shear, const std::string& digits = "14") {
    return "[profile]\n" + profile + "\n[load]\na = \"1\"\ncontact_modulus = \"" + modulus +
           "\"\nnu = \"0.3\"\n" + (shear.empty() ? "" : "[shear]\n" + shear + "\n") +
           "[ask]\ndigits = " + digits + "\n";
}

const std::string cylinder = "kind = \"hertz\"\nR = \"1\"";
const std::string rounded = "kind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"1\"";
const std::string tilted_punch =
    "kind = \"tilted-flat-and-rounded\"\nalpha = \"0.1\"\nt = \"0.4\"\nR = \"2\"";

GreatestValue greatest_of(const std::string& text, Quantity quantity, Body body = Body::A) {
    return greatest_value(scene::parse_scene(text, "scene.toml"), quantity, body);
}

std::string refusal_of(const std::string& text, Quantity quantity) {
    try {
        (void)greatest_of(text, quantity);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

Ball decimal(const std::string& text) {
    return formula::enclosed_constant(Exact::parse(text), 256);
}

/// True if the value is proved and agrees with a decimal to 2e-13.
bool is_near(const scene::BoundedValue& x, const std::string& text) {
    return x.proved && abs(Ball(x.value - decimal(text))).upper() < Real("2e-13");
}

std::string greatest_power_law(const char* m) {
    return std::string("kind = \"power-law\"\nC = \"1\"\nm = \"") + m + "\"";
}

/// A scene, and the place and the value of a second route.
struct GreatestCase {
    std::string text;
    Quantity quantity;
    Body body;
    const char* x;
    const char* z;
    const char* value;
};

void check_greatest(const std::vector<GreatestCase>& cases) {
    for (const GreatestCase& c : cases) {
        CAPTURE(c.text);
        CAPTURE(c.value);
        const GreatestValue found = greatest_of(c.text, c.quantity, c.body);
        CHECK(is_near(found.x, c.x));
        CHECK(is_near(found.z, c.z));
        CHECK(is_near(found.value, c.value));
    }
}

} // namespace

// johnson1985, sec. 4.2(a): the derivative by z vanishes at z = a sqrt((sqrt(5) - 1)/2), where
// tau_max = p_0 sqrt((5 sqrt(5) - 11)/2).
TEST_CASE("the greatest shear stress under a cylinder") {
    const GreatestValue found =
        greatest_of(greatest_scene_text(cylinder, "2", "", "40"), Quantity::tau_max);
    const Ball root = sqrt(Ball(5, 256));
    const Ball value = sqrt((root * 5 - 11) / 2);
    const Ball depth = sqrt((root - 1) / 2);
    CHECK(overlaps(found.value.value, value));
    CHECK(overlaps(found.z.value, depth));
    CHECK(found.x.exactly == Rational(0));
    CHECK(found.value.proved);
    CHECK(found.value.value.radius() < Real("1e-40"));
    CHECK(found.z.value.radius() < Real("1e-40"));
}

// Places and values by mpmath at 30 digits: the Cauchy integral as (E*/2) W times the integral of
// g'(s)/(zeta - s) over the angle, the edges from the consistency condition, and Newton's method on
// gradients by differences.
TEST_CASE("greatest stresses inside a body agree with a second route") {
    const std::string together = "Q = \"pi/10\"\npath = \"together\"";
    check_greatest({{greatest_scene_text(rounded, "1", ""), Quantity::tau_max, Body::B,
                     "0.81480538863537", "0.3707261881692", "0.07056134898240817"},
                    {greatest_scene_text(rounded, "1", ""), Quantity::mises, Body::A,
                     "0.77681380346464", "0.33945878722186", "0.1315135658732427"},
                    {greatest_scene_text(cylinder, "2", together), Quantity::tau_max, Body::A,
                     "0.62516903651631", "0.60131827605924", "0.3189885150105984"},
                    {greatest_scene_text(cylinder, "2", together), Quantity::mises, Body::B,
                     "-0.55334114619886", "0.56597972877751", "0.5899927545783283"},
                    {greatest_scene_text(greatest_power_law("1/2"), "1", ""), Quantity::tau_max,
                     Body::A, "0", "0.6062183890806", "0.1918046832797098"}});
}

TEST_CASE("greatest stresses under a tilted punch and a power law agree with a second route" *
          doctest::test_suite("slow")) {
    const std::string partial = "Q = \"-0.1\"\nfriction = \"0.2\"";
    check_greatest({{greatest_scene_text(tilted_punch, "3/2", partial), Quantity::tau_max, Body::A,
                     "0.33057071627212029", "0.70456848689373343", "0.09677976633790655"},
                    {greatest_scene_text(greatest_power_law("5/2"), "1", ""), Quantity::tau_max,
                     Body::A, "0.85657930952693", "0.36174760131635", "0.1075890018226155"}});
}

// mpmath at 30 digits: the stresses of Hertz on the surface of the slip zone, with
// Re T = pi f (x - (x - sqrt(x^2 - c^2))), where the derivative of the stress of von Mises
// vanishes.
TEST_CASE("the greatest stress of von Mises on the surface of a slip zone") {
    const GreatestValue found = greatest_of(
        greatest_scene_text(cylinder, "2", "Q = \"0.3\"\nfriction = \"0.6\""), Quantity::mises);
    CHECK(is_near(found.x, "0.8751849022350385"));
    CHECK(found.z.exactly == Rational(0));
    CHECK(is_near(found.value, "0.6426810315483776"));
}

// At the trailing edge p = q = 0 and szz = sxz = 0: tau_max is sxx/2. For Hertz without tension
// Re T = pi f p_0 (x/a - (x/a - sqrt(x^2 - c^2)/a)) outside the stick zone, with c^2/a^2 =
// 1 - Q/(f P), so that sxx = 2 f p_0 sqrt(Q/(f P)) there (`hills-nowell1994`); bulk_A adds.
TEST_CASE("the greatest stresses at the trailing edge") {
    const std::string shear = "Q = \"pi/10\"\nfriction = \"0.8\"\nbulk_A = \"0.5\"";
    const std::string text = greatest_scene_text(cylinder, "2", shear, "20");
    const Ball sxx = decimal("1/2") + decimal("1.6") * sqrt(decimal("1/4"));
    const GreatestValue tension = greatest_of(text, Quantity::sxx);
    CHECK(overlaps(tension.value.value, sxx));
    CHECK(tension.value.value.radius() < Real("1e-20"));
    CHECK(tension.x.exactly == Rational(-1));
    CHECK(tension.z.exactly == Rational(0));
    const GreatestValue tau = greatest_of(text, Quantity::tau_max);
    CHECK(overlaps(tau.value.value, sxx / 2));
    CHECK(tau.value.value.radius() < Real("1e-20"));
    CHECK(tau.x.exactly == Rational(-1));
    // Full sliding: 2 (Q/P) p_0, and on body B at the other edge (johnson1985, sec. 7.1).
    const std::string together =
        greatest_scene_text(cylinder, "2", "Q = \"pi/10\"\npath = \"together\"");
    const GreatestValue of_B = greatest_of(together, Quantity::sxx, Body::B);
    CHECK(contains(of_B.value.value, Rational(2, 5)));
    CHECK(of_B.x.exactly == Rational(1));
}

TEST_CASE("sxx is nowhere greater on the surface than at the trailing edge") {
    const std::string wedge = "kind = \"tilted-wedge\"\nphi = \"0.2\"\nalpha = \"0.05\"";
    const std::vector<std::string> texts{
        greatest_scene_text(tilted_punch, "3/2",
                            "Q = \"-0.1\"\nfriction = \"0.6\"\nbulk_tension = \"0.03\"\n"
                            "bulk_A = \"0.2\""),
        greatest_scene_text(wedge, "3/2", "Q = \"0.02\"\nfriction = \"0.3\""),
        greatest_scene_text("kind = \"power-law\"\nC = \"1\"\nm = \"5/2\"", "1",
                            "Q = \"0.1\"\nfriction = \"0.5\"\nbulk_A = \"-0.1\"")};
    for (const std::string& text : texts) {
        for (const Body body : {Body::A, Body::B}) {
            CAPTURE(text);
            const GreatestValue found = greatest_of(text, Quantity::sxx, body);
            scene::Scene s = scene::parse_scene(text, "scene.toml");
            s.ask.quantities = {scene::QuantityGroup::stress};
            for (int i = -40; i <= 40; ++i) {
                s.ask.in_bodies.push_back(
                    {Exact::parse(std::to_string(2 * i + 1) + "/32"), Exact::parse("0"), body});
            }
            const scene::SceneResult result = run_scene(s);
            for (const auto& at : result.at_places(scene::QuantityRow::Place::body)) {
                const Ball sxx = at.at(Quantity::sxx).value;
                CHECK(certainly_less(sxx, found.value.value));
            }
        }
    }
}

TEST_CASE("greatest values that do not exist, or are not one, are refused") {
    const auto refused = [](const std::string& text, Quantity quantity, const std::string& part) {
        const std::string message = refusal_of(text, quantity);
        CAPTURE(message);
        CHECK(message.find(part) != std::string::npos);
    };
    refused(greatest_scene_text(cylinder, "2", ""), Quantity::sxx, "without shear traction");
    refused(greatest_scene_text(cylinder, "2", "Q = \"0.1\""), Quantity::tau_max,
            "scene.toml:5: under full stick");
    refused(greatest_scene_text(cylinder, "2", "Q = \"0.1\""), Quantity::sxx, "under full stick");
    refused(
        greatest_scene_text("kind = \"tilted-wedge\"\nphi = \"0.2\"\nalpha = \"0.05\"", "1", ""),
        Quantity::tau_max, "corner inside the contact");
}

namespace {

std::string greatest_after(const std::string& steps) {
    return "[profile]\n" + rounded +
           "\n[load]\ncontact_modulus = \"2\"\nnu = \"0.3\"\n[shear]\nfriction = \"1/2\"\n"
           "[[step]]\nP = \"1/2\"\n" +
           steps + "[ask]\ndigits = 14\n";
}

/// The right edges of the zones of the layers of a history, from its contacts without shear.
std::vector<double> edges_of_layers(const scene::Scene& s) {
    std::vector<double> edges;
    for (const scene::LoadHistory::Layer& layer : s.history->layers) {
        scene::Scene part = s;
        part.history.reset();
        part.shear.reset();
        part.load = contact::Load::force(layer.force);
        const scene::BoundedValue a =
            scene::SceneValues(part, {{Quantity::a}}, {20, Rounding::nearest, false})
                .value({Quantity::a});
        edges.push_back(a.value.midpoint().convert_to<double>());
    }
    return edges;
}

/// Checks that tau_max or the stress of von Mises is at most `greatest` at the points of a grid
/// over the contact, and at points close to the edges of the zones, where it has cusps.
void check_that_none_is_greater(const std::string& text, Quantity quantity, const Ball& greatest) {
    const scene::Scene s = scene::parse_scene(text, "scene.toml");
    std::vector<double> x;
    std::vector<double> z;
    constexpr int columns = 121;
    constexpr int lines = 41;
    for (int i = 0; i < columns * lines; ++i) {
        x.push_back(-1.2 + 0.02 * (i % columns));
        z.push_back(0.02 * (i / columns));
    }
    for (const double edge : edges_of_layers(s)) {
        for (int k = 4; k <= 36; k += 4) {
            for (const double side : {-1.0, 1.0}) {
                for (const double across : {-1.0, 0.0, 1.0}) {
                    for (const double deep : {0.0, 1.0}) {
                        x.push_back(side * edge + std::ldexp(across, -k));
                        z.push_back(std::ldexp(deep, -k));
                    }
                }
            }
        }
    }
    std::vector<std::vector<double>> maps(6, std::vector<double>(x.size()));
    compute_binary64(s, Body::A, x, z, {maps[0], maps[1], maps[2], maps[3], maps[4], maps[5]});
    const std::vector<double>& map = maps[quantity == Quantity::tau_max ? 3 : 4];
    double most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        most = std::max(most, map[i] - maps[5][i]);
    }
    CHECK(Real(most) <= greatest.upper());
}

} // namespace

TEST_CASE("after one step of Q the greatest stresses are those of partial slip" *
          doctest::test_suite("slow")) {
    const std::string plain = "[profile]\n" + rounded +
                              "\n[load]\ncontact_modulus = \"2\"\nnu = \"0.3\"\nP = \"1/2\"\n"
                              "[shear]\nfriction = \"1/2\"\nQ = \"1/8\"\n[ask]\ndigits = 14\n";
    for (const Quantity quantity : {Quantity::mises, Quantity::tau_max, Quantity::sxx}) {
        const GreatestValue one = greatest_of(greatest_after("[[step]]\nQ = \"1/8\"\n"), quantity);
        const GreatestValue other = greatest_of(plain, quantity);
        CHECK(overlaps(one.value.value, other.value.value));
        CHECK(overlaps(one.x.value, other.x.value));
        CHECK(overlaps(one.z.value, other.z.value));
    }
}

// mpmath 1.3 at 30 digits, with E* = 2: the traction as a sum of pressures by hand (reversed,
// q = -p/2 + p(x; 1/5) - p(x; 1/10)/2; after the rise of P, q = -p/2 + 9/10 p(x; 7/12) - 2/5
// p(x; 1/2); after the fall of P, q = -p/2 + p(x; 2/5)/2), the edges from the force of g', the
// Cauchy integrals as W times the integral of g'(s)/(zeta - s) over the angle, and the pressure on
// the surface as the principal value of the integral of g'. The places of the first four are the
// edge of the zone of the second force; those of the last two by Newton's method on differences.
TEST_CASE("the greatest stresses after load histories agree with a second route" *
          doctest::test_suite("slow")) {
    const std::string reversed = greatest_after("[[step]]\nQ = \"1/5\"\n[[step]]\nQ = \"-1/10\"\n");
    const std::string risen =
        greatest_after("[[step]]\nP = \"3/4\"\nQ = \"1/10\"\n[[step]]\nQ = \"-1/20\"\n");
    const std::string fallen = greatest_after(
        "[[step]]\nP = \"3/4\"\nQ = \"1/10\"\n[[step]]\nP = \"1/2\"\nQ = \"-1/20\"\n");
    const std::vector<GreatestCase> cases{
        {reversed, Quantity::tau_max, Body::A, "0.66763767142101052936", "0",
         "0.19622876685805865874"},
        {reversed, Quantity::mises, Body::A, "0.66763767142101052936", "0",
         "0.38242755256843679853"},
        {risen, Quantity::tau_max, Body::A, "0.90325769993249683594", "0", "0.1577528795724402928"},
        {risen, Quantity::mises, Body::A, "0.90325769993249683594", "0", "0.30743916049011468257"},
        {fallen, Quantity::tau_max, Body::A, "-0.779071387971448", "0.225741680720234",
         "0.112459620282732297"},
        {fallen, Quantity::mises, Body::A, "-0.748194107716731", "0.216229275597667",
         "0.208458210007195208"}};
    check_greatest(cases);
    for (const GreatestCase& c : cases) {
        CAPTURE(c.text);
        check_that_none_is_greater(c.text, c.quantity, decimal(c.value));
    }
}

// For g' = x, E* = 2, the contact of the half width c has p = sqrt(c^2 - x^2) and the force
// pi c^2/2, and its Cauchy integral on the surface is pi x inside, pi (x - sgn(x) sqrt(x^2 - c^2))
// outside (johnson1985, sec. 4.2(a)). Q grows until c = c_s sticks, and falls until c = c_r sticks:
// q = f (2 p_r - p_s - p). Then sxx = -p - 2 q*/pi, where q* is the sum of the Cauchy integrals.
TEST_CASE("the greatest sxx after load histories is that of Hertz's contacts in closed form") {
    const auto after = [](const std::string& friction, const std::string& first,
                          const std::string& second, Body body) {
        return greatest_of(
            "[profile]\nkind = \"hertz\"\nR = \"1\"\n[load]\ncontact_modulus = \"2\"\n"
            "nu = \"0.3\"\n[shear]\nfriction = \"" +
                friction + "\"\n[[step]]\nP = \"pi/2\"\n[[step]]\nQ = \"" + first +
                "\"\n[[step]]\nQ = \"" + second + "\"\n[ask]\ndigits = 25\n",
            Quantity::sxx, body);
    };
    const auto root = [](long top, long bottom) { return sqrt(Ball(top, 128) / bottom); };
    const auto is = [](const GreatestValue& found, const Ball& x, const Ball& value) {
        CHECK(found.value.proved);
        CHECK(overlaps(found.value.value, value));
        CHECK(overlaps(found.x.value, x));
        CHECK(found.value.value.radius() < Real("1e-24"));
    };
    // c_s = 3/5, c_r = 4/5: 2 sqrt(1 - c_r^2) - sqrt(1 - c_s^2) at the right edge
    is(after("1/2", "4*pi/25", "-pi/50", Body::A), Ball(1, 128), root(4, 25));
    is(after("1/2", "4*pi/25", "-pi/50", Body::B), Ball(-1, 128), root(4, 25));
    // c_s = 3/10, c_r = 9/10: sqrt(c_r^2 - c_s^2) - sqrt(1 - c_r^2) at the left edge of that zone
    is(after("1/2", "91*pi/400", "53*pi/400", Body::A), -root(81, 100),
       root(72, 100) - root(19, 100));
    // The same at Q = 0, for c_s = 1/5 and c_r^2 = 13/25, with f = 1
    is(after("1", "12*pi/25", "0", Body::A), Ball(1, 128), root(12, 25) * 4 - root(24, 25) * 2);
}

TEST_CASE("without shear in any layer the greatest sxx is refused") {
    // The layers that were sheared lose contact.
    CHECK(refusal_of(greatest_after("[[step]]\nP = \"1\"\nQ = \"1/8\"\n[[step]]\nP = \"1/4\"\n"
                                    "Q = \"0\"\n"),
                     Quantity::sxx)
              .find("without shear traction") != std::string::npos);
}

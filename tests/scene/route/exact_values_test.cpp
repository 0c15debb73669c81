// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/scene/scene_text.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace edgeproof::scenes;

namespace {

/// Returns a scene with g' = C x^m; for m = 1, p = C sqrt(u (2a - u))/2.
std::string power_law(const std::string& m, const std::string& C, const std::string& load,
                      const std::string& more) {
    return "[profile]\nkind = \"power-law\"\nm = \"" + m + "\"\nC = \"" + C + "\"\n[load]\n" +
           load + "\n" + more;
}

const std::string unit_modulus = "contact_modulus = \"1\"\n";

/// The printed texts of a value, one for each kind of rounding.
struct Texts {
    std::string nearest;
    std::string down;
    std::string up;
};

template <class Pick>
Texts texts(const std::string& scene_text, unsigned digits, const Pick& pick) {
    std::string found[3];
    int i = 0;
    for (const Rounding mode : {Rounding::nearest, Rounding::down, Rounding::up}) {
        Scene scene = parsed(scene_text);
        scene.ask.digits = {digits, mode, false};
        const BoundedValue value = pick(run_scene(scene));
        const PrintedValue p = printed(value, scene.ask.digits);
        CHECK(value.proved);
        CHECK(p.complete);
        CHECK_FALSE(p.undecided);
        CHECK(how(value, p) == value.route);
        found[i++] = p.text;
    }
    return {found[0], found[1], found[2]};
}

BoundedValue p_of(const SceneResult& r) { return r.points()[0].at(Quantity::p); }
BoundedValue error_of(const SceneResult& r) { return r.points()[0].at(Quantity::rel, 1); }
BoundedValue local_of(const SceneResult& r) { return r.points()[0].at(Quantity::local, 1); }
BoundedValue c_of(const SceneResult& r, std::size_t k) {
    return r.at_edges(QuantityGroup::coefficients)[0].at(Quantity::c, k);
}

} // namespace

TEST_CASE("ties: pressures that end half-way between two decimals, to the even one") {
    // Pythagorean triangles: w = sqrt(u (2a - u)) is whole for u = a - x, x^2 + w^2 = a^2; C = 2
    // t/w gives p = t. The rounded values of t are given by hand.
    struct Triangle {
        int x, w, a;
    };
    struct Tie {
        const char* value;
        Texts expected;
    };
    for (const Triangle& t : {Triangle{3, 4, 5}, {12, 5, 13}, {-15, 8, 17}, {0, 7, 7}}) {
        for (const Tie& tie :
             {Tie{"0.125", {"0.12", "0.12", "0.13"}}, Tie{"0.135", {"0.14", "0.13", "0.14"}},
              Tie{"9.95", {"10", "9.9", "10"}}, Tie{"2.5e-7", {"2.5e-07", "2.5e-07", "2.5e-07"}},
              Tie{"1", {"1.0", "1.0", "1.0"}}}) {
            const std::string C = "2*" + std::string(tie.value) + "/" + std::to_string(t.w);
            CAPTURE(C);
            const Texts found =
                texts(power_law("1", C, "a = \"" + std::to_string(t.a) + "\"",
                                unit_modulus + "[ask]\nedges = [\"right\"]\nu = [\"" +
                                    std::to_string(t.a - t.x) + "\"]\n"),
                      2, p_of);
            CHECK(found.nearest == tie.expected.nearest);
            CHECK(found.down == tie.expected.down);
            CHECK(found.up == tie.expected.up);
        }
    }
}

TEST_CASE("ties: half-way between two binary64, to the even one") {
    struct Row {
        const char* value;
        double expected;
    };
    // 2^53 = 9007199254740992: 1 + 1/2^53 is halfway from 1 to the next double, 1 + 3/2^53 from the
    // next to the one after it; then the same in the subnormal range, where the unit is 2^-1074.
    for (const Row& row : {Row{"1 + 1/9007199254740992", 1.0},
                           Row{"1 + 3/9007199254740992", 1.0 + std::ldexp(1.0, -51)},
                           Row{"1 + 2/9007199254740992", 1.0 + std::ldexp(1.0, -52)},
                           Row{"2^(-1075)", 0.0}, Row{"3*2^(-1075)", std::ldexp(1.0, -1073)}}) {
        CAPTURE(row.value);
        Scene scene = parsed(power_law("1", "2*(" + std::string(row.value) + ")/4", "a = \"5\"",
                                       unit_modulus + "[ask]\nedges = [\"right\"]\nu = [\"2\"]\n"));
        scene.ask.digits = {20, Rounding::nearest, true};
        const PrintedValue p = printed(p_of(run_scene(scene)), scene.ask.digits);
        REQUIRE(p.binary64);
        CHECK(*p.binary64 == row.expected);
        CHECK_FALSE(std::signbit(*p.binary64));
        CHECK_FALSE(p.undecided);
    }
}

TEST_CASE("ties: coefficients, sums, loads, edges and shear with an exact form") {
    const auto asked = [](const std::string& what) {
        return "[ask]\nedges = [\"right\"]\n" + what + "\n";
    };
    const std::string terms = asked("quantities = [\"coefficients\"]\nterms = 2");
    // p = (C/2) sqrt(u) sqrt(2a - u): c_0 = (C/2) sqrt(2a), c_1 = -c_0/(4a).
    const std::string hertz = power_law("1", "1/8", "a = \"2\"", unit_modulus + terms);
    CHECK(texts(hertz, 2, [](const auto& r) { return c_of(r, 0); }).nearest == "0.12");
    CHECK(texts(hertz, 4, [](const auto& r) { return c_of(r, 1); }).nearest == "-0.01562");
    CHECK(texts(hertz, 4, [](const auto& r) { return c_of(r, 1); }).down == "-0.01563");
    // A wedge: p = (C/pi) acosh(a/|x|), so that c_0 = (C/pi) sqrt(2/a).
    CHECK(texts(power_law("0", "pi/8", "a = \"2\"", unit_modulus + terms), 2, [](const auto& r) {
              return c_of(r, 0);
          }).nearest == "0.12");
    // Flat and rounded: P'(a) = (E* a/R) acos(t/a), c_0 = P'(a) sqrt(2/a)/pi = 1/8.
    CHECK(texts("[profile]\nkind = \"flat-and-rounded\"\nt = \"1\"\nR = \"16/3\"\n[load]\na = "
                "\"2\"\n" +
                    unit_modulus + terms,
                2, [](const auto& r) { return c_of(r, 0); })
              .nearest == "0.12");
    // m = 3: I_3(0) is the integral of s^2, 1/3; p = P'(a)/(3 pi) = C a^3/4 at the middle.
    CHECK(texts(power_law("3", "1/2", "a = \"1\"", unit_modulus + asked("u = [\"1\"]")), 2, p_of)
              .nearest == "0.12");
    // The parabola in pieces of one straight line, and with a corner outside the contact.
    CHECK(texts("[profile]\nkind = \"piecewise\"\nknots = [\"0\", \"1\"]\nslopes = [\"x/4\", "
                "\"x/4\", \"x\"]\n[load]\na = \"1\"\n" +
                    unit_modulus + asked("u = [\"1\"]"),
                2, p_of)
              .nearest == "0.12");
    // One term, at u = 2a (1 - 64/81): |1 - sqrt(2a/(2a - u))| = 1/8; sum c_0 sqrt(u).
    const std::string one =
        power_law("1", "1", "a = \"81/2\"",
                  unit_modulus + asked("quantities = [\"pressure\"]\nterms = [1]\nu = "
                                       "[\"17\"]"));
    CHECK(texts(one, 2, error_of).nearest == "0.12");
    // c_0 sqrt(u) = (1/2) sqrt(8 (1/2)^3) at a = 2, u = 1/4: 1/2.
    CHECK(texts(power_law("1", "1", "a = \"2\"",
                          unit_modulus +
                              asked("quantities = [\"pressure\"]\nterms = [1]\nu = [\"1/4\"]")),
                3, local_of)
              .down == "0.500");
    // P = E* C (pi/4) a^2, given or computed.
    CHECK(texts(power_law("1", "1/2", "a = \"1\"",
                          "contact_modulus = \"1/pi\"\n" + asked("quantities = [\"contact\"]")),
                2, [](const auto& r) { return r.at(Quantity::P); })
              .nearest == "0.12");
    CHECK(texts(power_law("1", "1", "P = \"pi/256\"",
                          unit_modulus + asked("quantities = [\"contact\"]")),
                2, [](const auto& r) { return r.at(Quantity::a); })
              .nearest == "0.12");
    // A tilted wedge: (phi - alpha) h = (phi + alpha)(pi - h), h = 2 pi/3 for alpha = phi/3, and
    // cos h = (b - a)/(a + b): b = a/3.
    const std::string tilted = "[profile]\nkind = \"tilted-wedge\"\nphi = \"0.3\"\nalpha = "
                               "\"0.1\"\n[load]\na = \"3/8\"\n" +
                               unit_modulus + asked("quantities = [\"contact\"]");
    CHECK(texts(tilted, 2, [](const auto& r) { return r.at(Quantity::b); }).nearest == "0.12");
    CHECK(texts(tilted, 3, [](const auto& r) { return r.at(Quantity::b); }).down == "0.125");
    // Full stick: q = (Q/pi)/sqrt(u (2a - u)).
    CHECK(texts(power_law("1", "1", "a = \"1\"",
                          unit_modulus +
                              "[shear]\nQ = \"pi/8\"\nbulk_tension = "
                              "\"0\"\n" +
                              asked("quantities = [\"shear\"]\nu = [\"1\"]")),
                2, [](const auto& r) { return r.points()[0].at(Quantity::q); })
              .nearest == "0.12");
}

TEST_CASE("ties: extents that end on a short decimal") {
    // Hertz, one term: 1/sqrt(1 - v) - 1 = 1/4 at v = u/(2a) = 9/25; two terms: (1 - v/2)/sqrt(1 -
    // v) - 1 = 1/4 at v = 3/4.
    const std::string scene = power_law(
        "1", "1", "a = \"1/2\"",
        unit_modulus + "[ask]\nedges = [\"right\"]\nquantities = [\"extent\"]\ntolerance = "
                       "\"25%\"\nterms = [1, 2]\n");
    for (const std::size_t k : {0U, 1U}) {
        const std::string expected = k == 0 ? "0.36000" : "0.75000";
        for (const Quantity quantity :
             {Quantity::extent, Quantity::measure, Quantity::measure_fraction}) {
            const Texts t = texts(scene, 5, [&](const auto& r) {
                return r.at_edges(QuantityGroup::extent)[0].at(quantity, k + 1);
            });
            CHECK(t.nearest == expected);
            CHECK(t.down == expected);
            CHECK(t.up == expected);
        }
    }
}

TEST_CASE("ties: where no exact form is known a neighbour is printed, with a note and its bound") {
    // log(4)/log(2) is 2, by an identity that is unknown to exact numbers.
    Scene scene = parsed(power_law("1", "1/32", "a = \"5\"",
                                   "contact_modulus = \"log(4)/log(2)\"\n"
                                   "[ask]\nedges = [\"right\"]\nu = [\"2\"]\n"));
    for (const Rounding mode : {Rounding::nearest, Rounding::down, Rounding::up}) {
        scene.ask.digits = {mode == Rounding::nearest ? 2U : 3U, mode, true};
        const BoundedValue value = p_of(run_scene(scene));
        const PrintedValue p = printed(value, scene.ask.digits);
        CHECK(value.proved);
        CHECK(p.undecided);
        CHECK_FALSE(p.complete);
        const std::string nearest = p.text; // of a tie, either neighbour
        CHECK((mode == Rounding::nearest ? nearest == "0.12" || nearest == "0.13"
               : mode == Rounding::down  ? p.text == "0.124"
                                         : p.text == "0.126"));
        CHECK(parse_decimal(p.bound) >= abs(Rational(parse_decimal(p.text) - Rational(1, 8))));
        CHECK(how(value, p) == "closed-form (rounding undecided)");
        CHECK(p.binary64 == 0.125);
    }
    // Halfway between two binary64 by the same identity: none is given.
    scene = parsed(power_law("1", "(1 + 1/9007199254740992)/4", "a = \"5\"",
                             "contact_modulus = \"log(4)/log(2)\"\n"
                             "[ask]\nedges = [\"right\"]\nu = [\"2\"]\n"));
    scene.ask.digits = {30, Rounding::nearest, true};
    const PrintedValue p = printed(p_of(run_scene(scene)), scene.ask.digits);
    CHECK_FALSE(p.binary64);
    CHECK(p.undecided);
}

TEST_CASE("ties: exact values take no more bits than others") {
    // a + b, x and p are short decimals, rounded down: one level of bits suffices.
    Scene scene =
        parsed(power_law("1", "0.1", "a = \"0.65\"",
                         unit_modulus + "[ask]\nedges = [\"right\"]\nu = [\"0.4\", \"0.65\"]\n"));
    scene.ask.digits.rounding = Rounding::down;
    CHECK(run_scene(scene).work.raised == 0);
}

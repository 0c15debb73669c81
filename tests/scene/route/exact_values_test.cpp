// SPDX-License-Identifier: BSD-3-Clause
// Values half-way between two numbers; values.txt has those between two decimals.
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace edgeproof::scenes;

namespace {
/// p = C sqrt(u (2a - u))/2 of g' = C x: 2 C at a = 5, u = 2.
BoundedValue triangle(const std::string& C, const Digits& digits, const std::string& E = "1") {
    Scene scene = made("power-law m=1 C=" + C + " a=5 E=" + E + " u=2");
    scene.ask.digits = digits;
    return run_scene(scene).points()[0].at(Quantity::p);
}
} // namespace

TEST_CASE("ties: half-way between two binary64, to the even one") {
    struct Row {
        const char* value;
        double expected;
    };
    // 2^53 = 9007199254740992: 1 + 1/2^53 is halfway from 1 to the next double, 1 + 3/2^53 from the
    // next to the one after it; then the same in the subnormal range, where the unit is 2^-1074.
    for (const Row& row :
         {Row{"1+1/9007199254740992", 1.0}, Row{"1+3/9007199254740992", 1.0 + std::ldexp(1.0, -51)},
          Row{"1+2/9007199254740992", 1.0 + std::ldexp(1.0, -52)}, Row{"2^(-1075)", 0.0},
          Row{"3*2^(-1075)", std::ldexp(1.0, -1073)}}) {
        CAPTURE(row.value);
        const Digits digits{20, Rounding::nearest, true};
        const PrintedValue p =
            printed(triangle("2*(" + std::string(row.value) + ")/4", digits), digits);
        REQUIRE(p.binary64);
        CHECK(*p.binary64 == row.expected);
        CHECK_FALSE(std::signbit(*p.binary64));
        CHECK_FALSE(p.undecided);
    }
}

TEST_CASE("ties: where no exact form is known a neighbour is printed, with a note and its bound") {
    // log(4)/log(2) is 2, by an identity that is unknown to exact numbers.
    for (const Rounding mode : {Rounding::nearest, Rounding::down, Rounding::up}) {
        const Digits digits{mode == Rounding::nearest ? 2U : 3U, mode, true};
        const BoundedValue value = triangle("1/32", digits, "log(4)/log(2)");
        const PrintedValue p = printed(value, digits);
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
    const Digits digits{30, Rounding::nearest, true};
    const PrintedValue p =
        printed(triangle("(1+1/9007199254740992)/4", digits, "log(4)/log(2)"), digits);
    CHECK_FALSE(p.binary64);
    CHECK(p.undecided);
}

TEST_CASE("ties: exact values take no more bits than others") {
    // a + b, x and p are short decimals, rounded down: one level of bits suffices.
    Scene scene = made("power-law m=1 C=0.1 a=0.65 u=0.4;0.65");
    scene.ask.digits.rounding = Rounding::down;
    const SceneResult result = run_scene(scene);
    for (const Row& row : result.rows) {
        CHECK(row.value->value.bits() <= result.plan.bits);
    }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

TEST_CASE("numbers mean exactly what is written, quoted or not") {
    const Scene scene =
        made("flat-and-rounded t=0.4 R=1 a==1.25 E=2.1e11 u==[0.1,\"1e-300\",\"1/3\",\"pi/16\"]");
    CHECK(scene.load.value.rational() == Rational(5, 4));
    CHECK(scene.ask.u[0].u.rational() == Rational(1, 10)); // not the double nearest to it
    CHECK(scene.ask.u[1].u.rational() == parse_decimal("1e-300"));
    CHECK(scene.ask.u[2].u.rational() == Rational(1, 3));
    CHECK_FALSE(scene.ask.u[3].u.is_rational());
    CHECK(scene.ask.u[3].line == 9);
    CHECK(scene.ask.wants(QuantityGroup::pressure));
    CHECK_FALSE(scene.ask.wants(QuantityGroup::shear));
}

TEST_CASE("ranges of u: both ends exactly, the same on every machine") {
    const std::string flat = "flat-and-rounded t=0.4 R=1 a=1 u==";
    const Scene scene = made(flat + "{from=\"1e-3\",to=\"0.5\",per_decade=2}");
    std::vector<std::string> texts;
    for (const AskedPoint& p : scene.ask.u) {
        texts.push_back(p.u.is_rational() ? exact_text(p.u.rational()) : p.u.text());
    }
    // 10^(1/2) = 3.16227766017 to 12 digits.
    CHECK(texts == std::vector<std::string>{"0.001", "0.00316227766017", "0.01", "0.0316227766017",
                                            "0.1", "0.316227766017", "0.5"});
    const Scene even = made(flat + "{from=\"0.1\",to=\"0.7\",points=4}");
    REQUIRE(even.ask.u.size() == 4);
    CHECK(even.ask.u[1].u.rational() == Rational(3, 10));
    CHECK(even.ask.u[3].u.rational() == Rational(7, 10));
}

TEST_CASE("every kind of entry is written as TOML") {
    const std::vector<edgeproof::io::TomlTable> entries{
        {"profile",
         0,
         {{"kind", "piecewise"},
          {"symmetric", true},
          {"knots", std::vector<std::string>{"1/2"}},
          {"slopes", std::vector<std::string>{"x", "x + (x - 1/2)^2"}}}},
        {"load", 0, {{"P", "1/10"}, {"contact_modulus", "1"}}},
        {"shear", 0, {{"Q", "1/100"}, {"path", "together"}}}};
    CHECK(scene_text(entries) == "[profile]\nkind = \"piecewise\"\nsymmetric = true\n"
                                 "knots = [\"1/2\"]\nslopes = [\"x\", \"x + (x - 1/2)^2\"]\n\n"
                                 "[load]\nP = \"1/10\"\ncontact_modulus = \"1\"\n\n"
                                 "[shear]\nQ = \"1/100\"\npath = \"together\"\n");
    const Scene scene = make_scene(entries);
    CHECK(scene.symmetric());
    CHECK(scene.shear.has_value());
    const std::string title = "a \"b\" \\ c";
    CHECK(make_scene(entries, title).title == title);
}

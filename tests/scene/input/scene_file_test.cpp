// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/scene_text.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

const std::string profile_text = "[profile]\nkind = \"flat-and-rounded\"\nt = \"0.4\"\nR = \"1\"\n";
const std::string load_text = "[load]\na = \"1\"\ncontact_modulus = \"1\"\n";

struct Bad {
    std::string text;
    std::size_t line;
    std::string what;
};

SceneEntries wedge_entries() {
    return {"A wedge",
            {{"kind", "tilted-wedge"}, {"phi", "0.1"}, {"alpha", "0.02"}},
            {{"a", "2"}, {"contact_modulus", "1"}},
            {}};
}

} // namespace

TEST_CASE("numbers mean exactly what is written, quoted or not") {
    const Scene scene =
        parsed(profile_text + "[load]\na = 1.25\ncontact_modulus = \"2.1e11\"\n[ask]\n"
                              "u = [0.1, \"1e-300\", \"1/3\", \"pi/16\"]\n");
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
    const Scene scene = parsed(profile_text + load_text +
                               "[ask]\nu = { from = \"1e-3\", to = \"0.5\", per_decade = 2 }\n");
    std::vector<std::string> texts;
    for (const AskedPoint& p : scene.ask.u) {
        texts.push_back(p.u.is_rational() ? exact_text(p.u.rational()) : p.u.text());
    }
    // 10^(1/2) = 3.16227766017 to 12 digits.
    CHECK(texts == std::vector<std::string>{"0.001", "0.00316227766017", "0.01", "0.0316227766017",
                                            "0.1", "0.316227766017", "0.5"});
    const Scene even = parsed(profile_text + load_text +
                              "[ask]\nu = { from = \"0.1\", to = \"0.7\", points = 4 }\n");
    REQUIRE(even.ask.u.size() == 4);
    CHECK(even.ask.u[1].u.rational() == Rational(3, 10));
    CHECK(even.ask.u[3].u.rational() == Rational(7, 10));
}

TEST_CASE("the modulus from both bodies: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2") {
    const Scene scene = parsed(profile_text + "[load]\na = \"1\"\nE1 = \"200\"\nnu1 = \"0.5\"\n"
                                              "E2 = \"100\"\nnu2 = \"0\"\n[ask]\nterms = 1\n");
    // 0.75/200 + 1/100 = 0.01375
    const PrecisionScope scope(40);
    CHECK(abs(Real(scene.contact_modulus.to<Real>() - Real(1) / Real("0.01375"))) < Real("1e-37"));
}

TEST_CASE("tolerances: 1%, 0.01 and 1/100 are one") {
    for (const char* text : {"1%", "0.01", "1/100", "1e-2"}) {
        CHECK(Exact(parse_tolerance(text).expr() - Exact::parse("1/100").expr()).sign() == 0);
    }
    for (const char* bad : {"0", "0%", "-1%", "", "%", "one"}) {
        CHECK_THROWS_AS((void)parse_tolerance(bad), InputError);
    }
}

TEST_CASE("malformed scenes are refused with their line") {
    const Bad all[] = {
        {profile_text + "[load]\na = \"1\"\nP = \"1\"\ncontact_modulus = \"1\"\n", 7,
         "both a and P"},
        {profile_text + "[load]\ncontact_modulus = \"1\"\n", 5, "neither a nor P"},
        {profile_text + "[load]\na = \"1\"\n", 5, "contact_modulus"},
        {profile_text + "[load]\na = \"-1\"\ncontact_modulus = \"1\"\n", 6, "not positive"},
        {profile_text + "[load]\na = \"0.4\"\ncontact_modulus = \"1\"\n", 6, "beyond the flat"},
        {profile_text + load_text + "[shear]\n", 8, "no load"},
        {profile_text + load_text + "[shear]\nQ = \"0\"\n", 8, "no load"},
        {profile_text + load_text + "[shear]\nQ = \"1\"\npath = \"sideways\"\n", 10, "path"},
        {profile_text + load_text +
             "[shear]\nQ = \"1\"\nbulk_tension = \"1\"\npath = \"together\"\n",
         10, "bulk tension"},
        {profile_text + load_text + "[ask]\nedges = [\"top\"]\n", 9, "'top'"},
        {profile_text + load_text + "[ask]\nedges = [\"left\", \"left\"]\n", 9, "twice"},
        {profile_text + load_text + "[ask]\nedges = []\n", 9, "no edge"},
        {profile_text + load_text + "[ask]\nterms = -1\n", 9, "terms = -1"},
        {profile_text + load_text + "[ask]\nterms = 0\n", 9, "terms = 0"},
        {profile_text + load_text + "[ask]\nterms = 1.5\n", 9, "whole number"},
        {profile_text + load_text + "[ask]\nu = [\"0.1\",\n \"-0.1\"]\n", 10, "u = -0.1"},
        {profile_text + load_text + "[ask]\nu = \"nan\"\n", 9, "nan"},
        {profile_text + load_text + "[ask]\nu = 0.12345678901234567\n", 9, "more than 15"},
        {profile_text + load_text + "[ask]\nu = { from = \"1\", to = \"0.1\", per_decade = 3 }\n",
         9, "ascend"},
        {profile_text + load_text + "[ask]\nu = { from = \"0\", to = \"0.1\", per_decade = 3 }\n",
         9, "u = 0"},
        {profile_text + load_text + "[ask]\nprocess_zone = \"-1\"\n", 9, "process_zone"},
        {profile_text + load_text + "[ask]\ntolerance = \"0\"\n", 9, "tolerance"},
        {profile_text + load_text + "[ask]\ntolerance = 0\n", 9, "tolerance"},
        {profile_text + load_text + "[ask]\nquantities = [\"heat\"]\n", 9, "'heat'"},
        {profile_text + load_text + "[ask]\nquantities = [\"shear\"]\n", 9, "no [shear]"},
        {profile_text + load_text + "[ask]\nroute = \"scenic\"\n", 9, "'scenic'"},
        {profile_text + load_text + "[ask]\nfoo = 1\n", 9, "unknown key 'foo'"},
        {profile_text + load_text + "[ak]\nterms = 1\n", 8, "unknown key 'ak'"},
        {"[profile]\nkind = \"ball\"\n" + load_text, 2, "'ball'"},
        {"[profile]\nkind = \"power-law\"\nm = \"-1\"\nC = \"1\"\n" + load_text, 3, "m = -1"},
        {"[profile]\nkind = \"power-law\"\nm = \"1\"\n" + load_text, 1, "there is no C"},
        {"[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\nalpha = \"0.2\"\n" + load_text, 4,
         "alpha"},
        {"[profile]\nkind = \"tilted-wedge\"\nphi = \"0.1\"\n" + load_text, 1, "tilt"},
        {"[profile]\nkind = \"piecewise\"\nknots = [\"1\"]\nslopes = [\"x\"]\n" + load_text, 1,
         "pieces"},
        {profile_text + "[load]\nP = \"1\"\nM = \"1\"\ncontact_modulus = \"1\"\n", 2, "no tilt"},
        {profile_text, 1, "[load]"},
        {"[profile\n", 1, "TOML"},
    };
    for (const Bad& bad : all) {
        CAPTURE(bad.text);
        try {
            (void)parsed(bad.text);
            FAIL("accepted");
        } catch (const InputError& error) {
            CAPTURE(error.what());
            CHECK(error.file() == "scene.toml");
            CHECK(error.line() == bad.line);
            CHECK(std::string(error.what()).find(bad.what) != std::string::npos);
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
            CHECK_FALSE(error.instead().empty());
        }
    }
}

TEST_CASE("bodies of different materials may press, but not shear") {
    const std::string two = "[load]\na = \"1\"\nE1 = \"200\"\nnu1 = \"0.3\"\nE2 = \"100\"\n"
                            "nu2 = \"0.3\"\n";
    CHECK_NOTHROW((void)parsed(profile_text + two));
    CHECK_THROWS_AS((void)parsed(profile_text + two + "[shear]\nQ = \"1\"\n"), InputError);
}

TEST_CASE("bodies of different materials do shear where Dundurs' beta is 0") {
    const auto sheared = [&](const char* E1, const char* nu1, const char* E2, const char* nu2,
                             const char* shear) {
        const auto line = [](const char* key, const char* value) {
            return std::string(key) + " = \"" + value + "\"\n";
        };
        return profile_text + "[load]\na = \"1\"\n" + line("E1", E1) + line("nu1", nu1) +
               line("E2", E2) + line("nu2", nu2) + "[shear]\n" + shear;
    };
    const char* const Q = "Q = \"1\"\n";
    // (1 - 2 nu)(1 + nu)/E by hand: 0 and 0; (2/5)(13/10)/52 = 1/100 = (1/2)(5/4)/(125/2).
    CHECK_NOTHROW((void)parsed(sheared("200", "1/2", "100", "1/2", Q)));
    CHECK_NOTHROW((void)parsed(sheared("pi", "0.5", "sqrt(2)", "1/2", Q)));
    CHECK_NOTHROW((void)parsed(sheared("52", "0.3", "125/2", "1/4", Q)));
    CHECK_THROWS_AS((void)parsed(sheared("52", "0.3", "62.5001", "1/4", Q)), InputError);
    CHECK_THROWS_AS((void)parsed(sheared("52", "0.3", "52", "0.3000001", Q)), InputError);
    // In this case the mismatch of strains is not the difference of the tensions.
    const char* const tension = "bulk_tension = \"1\"\n";
    CHECK_THROWS_AS((void)parsed(sheared("200", "1/2", "100", "1/2", tension)), InputError);
    CHECK_NOTHROW((void)parsed(sheared("200", "1/2", "200", "1/2", tension)));
}

TEST_CASE(
    "what defines a contact is 0 or between 1e-10000 and 1e10000, places are not limited so") {
    const auto line_of = [](const std::string& text) {
        try {
            (void)parsed(text);
        } catch (const InputError& error) {
            CAPTURE(error.what());
            CHECK(std::string_view(error.what()).find("between 1e-10000 and 1e10000") !=
                  std::string_view::npos);
            CHECK(std::string_view(error.what()).size() < 300);
            return error.line();
        }
        return std::size_t{0};
    };
    const auto scene = [](const std::string& R, const std::string& P) {
        return "[profile]\nkind = \"hertz\"\nR = \"" + R + "\"\n[load]\nP = \"" + P +
               "\"\ncontact_modulus = \"1\"\n[ask]\nu = [\"1e-90000\"]\n";
    };
    CHECK(line_of(scene("1", "1")) == 0);
    CHECK(line_of(scene("1e10000", "1e-10000")) == 0);
    CHECK(line_of(scene("1.01e10000", "1")) == 3);
    CHECK(line_of(scene("-2e10000", "1")) == 3);
    CHECK(line_of(scene("1", "9.99e-10001")) == 5);
    CHECK(line_of(scene("1", "pi*1e-99999")) == 5);
    CHECK(line_of(scene("exp(23100)", "1")) == 3); // 1.6e10032
    CHECK(line_of(scene("exp(23000)", "1")) == 0); // 6.0e9988
    CHECK(line_of(scene("0." + std::string(10001, '0') + "1", "1")) == 3);
    const std::string piecewise = "[profile]\nkind = \"piecewise\"\nknots = [\"0\"]\n"
                                  "slopes = [\"x\", \"1e-10001*x\"]\n";
    CHECK(line_of(piecewise + load_text) == 4);
    CHECK(line_of(profile_text + load_text + "[shear]\nQ = \"1e-10001\"\n") == 9);
}

TEST_CASE("a scene from entries is the one that a file with the same text gives") {
    Scene made = make_scene(wedge_entries());
    Scene read = parsed(tilted_wedge("", "u = [\"1/3\"]"));
    CHECK(made.title == "A wedge");
    CHECK(made.file.empty());
    made.ask = read.ask;
    const SceneResult x = run_scene(made);
    const SceneResult y = run_scene(read);
    CHECK(printed(x.points()[0].at(Quantity::p), {}).text ==
          printed(y.points()[0].at(Quantity::p), {}).text);
    CHECK(printed(x.at(Quantity::b), {}).text == printed(y.at(Quantity::b), {}).text);
}

TEST_CASE("every kind of entry is written as TOML") {
    SceneEntries entries{"",
                         {{"kind", "piecewise"},
                          {"symmetric", true},
                          {"knots", std::vector<std::string>{"1/2"}},
                          {"slopes", std::vector<std::string>{"x", "x + (x - 1/2)^2"}}},
                         {{"P", "1/10"}, {"contact_modulus", "1"}},
                         {{"Q", "1/100"}, {"path", "together"}}};
    CHECK(scene_text(entries) == "[profile]\nkind = \"piecewise\"\nsymmetric = true\n"
                                 "knots = [\"1/2\"]\nslopes = [\"x\", \"x + (x - 1/2)^2\"]\n\n"
                                 "[load]\nP = \"1/10\"\ncontact_modulus = \"1\"\n\n"
                                 "[shear]\nQ = \"1/100\"\npath = \"together\"\n");
    const Scene scene = make_scene(entries);
    CHECK(scene.symmetric());
    CHECK(scene.shear.has_value());
    entries.title = "a \"b\" \\ c";
    CHECK(make_scene(entries).title == "a \"b\" \\ c");
}

TEST_CASE("a refusal names no file and no line") {
    SceneEntries bad = wedge_entries();
    bad.load[0].value = "-2";
    try {
        (void)make_scene(bad);
        FAIL("a = -2 is taken");
    } catch (const InputError& error) {
        CHECK(error.file().empty());
        CHECK(error.line() == 0);
        CHECK(error.problem() == "a = -2 is not positive");
    }
    bad = wedge_entries();
    bad.load[0].value = "2\"\nP = \"3";
    CHECK_THROWS_WITH_AS((void)make_scene(bad),
                         "a holds a control character; write a number or a word", InputError);
    bad = wedge_entries();
    bad.profile[1].key = "psi";
    CHECK_THROWS_AS((void)make_scene(bad), InputError);
}

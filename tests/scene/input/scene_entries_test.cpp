// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"
#include "edgeproof/scene/run_scene.hpp"
#include "tests/scene/scene_text.hpp"

#include <doctest/doctest.h>

using namespace edgeproof::scenes;

namespace {

SceneEntries wedge_entries() {
    return {"A wedge",
            {{"kind", "tilted-wedge"}, {"phi", "0.1"}, {"alpha", "0.02"}},
            {{"a", "2"}, {"contact_modulus", "1"}},
            {}};
}

} // namespace

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

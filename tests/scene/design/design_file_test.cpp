// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/design/design_file.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

std::string pad_design(const std::string& profile, const std::string& design) {
    return "[profile]\n" + profile + "[load]\na = \"1\"\ncontact_modulus = \"1\"\n[design]\n" +
           "maximise = \"first_exit\"\ntolerance = \"5%\"\n" + design;
}

const char* const flat_of_range =
    "kind = \"flat-and-rounded\"\nt = { from = \"0\", to = \"1/2\" }\n"
    "R = \"10\"\n";

std::string problem_of(const std::string& text) {
    try {
        (void)edgeproof::scene::parse_design(text, "pad.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("a design scene: its ranges, and the scene for a value of them") {
    const auto design = edgeproof::scene::parse_design(
        pad_design(flat_of_range, "printed = { t = \"1/4\" }\n"), "pad.toml");
    CHECK(design.parameter == "t");
    CHECK(design.range.to == Rational(1, 2));
    CHECK(design.printed == Rational(1, 4));
    CHECK(design.tolerance.rational() == Rational(1, 20));
    const auto scene = design.at(Rational(1, 3));
    CHECK(scene.profile->parameters().at("t").rational() == Rational(1, 3));
    std::string why;
    CHECK(design.errors(why).size() == 1);
    // A user's name in knots and slopes; only whole names are replaced, and not in comments.
    CHECK(edgeproof::scene::with_name_replaced("r + 2*(rr - r1) - r^2", "r", "1/3") ==
          "(1/3) + 2*(rr - r1) - (1/3)^2");
    const auto own = edgeproof::scene::parse_design(
        pad_design("kind = \"piecewise\"\nsymmetric = true\nknots = [\"r\"] # r\nslopes = [\"x\", "
                   "\"r + 2*(x - r)\"]\n",
                   "[parameters]\nr = { from = \"1/10\", to = \"9/10\" }\n"),
        "own.toml");
    CHECK(own.at(Rational(1, 2)).profile->knots().back().rational() == Rational(1, 2));
    CHECK(own.errors(why).size() == 1);
    // For a curved slope there is no enclosure over a range; the result states this.
    const auto curved = edgeproof::scene::parse_design(
        pad_design("kind = \"piecewise\"\nsymmetric = true\nknots = [\"r\"]\nslopes = [\"x^3\", "
                   "\"r^3 + 3*(x - r)\"]\n",
                   "[parameters]\nr = { from = \"1/10\", to = \"9/10\" }\n"),
        "curved.toml");
    CHECK(curved.errors(why).empty());
    CHECK(why.find("curved") != std::string::npos);
}

TEST_CASE("a design scene: errors have their line") {
    CHECK(problem_of(pad_design("kind = \"flat-and-rounded\"\nt = \"0\"\nR = \"10\"\n", ""))
              .find("0 numbers of the scene are ranges") != std::string::npos);
    CHECK(problem_of(pad_design(flat_of_range, "[parameters]\nr = { from = \"0\", to = \"1\" }\n"))
              .find("2 numbers of the scene are ranges; write one as") != std::string::npos);
    CHECK(
        problem_of(pad_design("kind = \"flat-and-rounded\"\nt = { from = \"1\", to = \"1/2\" }\nR "
                              "= \"10\"\n",
                              ""))
            .find("pad.toml:3: the range of t is empty") == 0);
    // The far end makes no contact: a does not reach beyond the flat.
    CHECK(
        problem_of(pad_design("kind = \"flat-and-rounded\"\nt = { from = \"0\", to = \"2\" }\nR = "
                              "\"10\"\n",
                              ""))
            .find("does not reach beyond the flat") != std::string::npos);
    CHECK(problem_of(pad_design(flat_of_range, "edge = \"top\"\n"))
              .find("write right, left or both") != std::string::npos);
    CHECK(problem_of(pad_design(flat_of_range, "of = \"shear\"\n")).find("there is no [shear]") !=
          std::string::npos);
    CHECK(problem_of(pad_design(flat_of_range, "printed = { R = \"1\" }\n"))
              .find("there is no parameter R") != std::string::npos);
}

TEST_CASE("a design scene with keys in place of its own") {
    using edgeproof::io::TomlEntry;
    const auto asked = [](const std::string& text, const std::vector<TomlEntry>& design) {
        return edgeproof::scene::parse_design(text, "pad.toml", {{"design", 0, design}});
    };
    const std::string text = pad_design(flat_of_range, "terms = 2\nedge = \"left\"\n");
    const auto as_written = asked(text, {});
    CHECK(as_written.terms == 2);
    CHECK(as_written.edges == std::vector{edgeproof::contact::Edge::left});
    const std::vector<TomlEntry> all{
        {"maximise", "measure"}, {"tolerance", "1/100"}, {"edge", "both"}, {"terms", "3"}};
    const auto otherwise = asked(text, all);
    CHECK(otherwise.objective == edgeproof::scene::DesignObjective::measure);
    CHECK(otherwise.tolerance.rational() == Rational(1, 100));
    CHECK(otherwise.edges.size() == 2);
    CHECK(otherwise.terms == 3);
    // A wrong value of a key that is replaced is no error, but an unknown key is.
    CHECK(asked(pad_design(flat_of_range, "edge = \"top\"\n"), {{"edge", "right"}}).edges.size() ==
          1);
    CHECK_THROWS_WITH_AS((void)asked(pad_design(flat_of_range, "edges = \"left\"\n"), all),
                         doctest::Contains("pad.toml:11"), InputError);
    // The file has no table [design].
    const std::string bare = text.substr(0, text.find("[design]"));
    CHECK(asked(bare, {{"tolerance", "1/100"}}).terms == 1);
    CHECK_THROWS_WITH_AS((void)edgeproof::scene::parse_design(bare, "pad.toml"),
                         doctest::Contains("there is no [design]"), InputError);
}

// For a cylinder p = c_0 sqrt(u) sqrt(1 - u/2a), so that the error of one term is e at u/2a = 1 -
// 1/(1 + e)^2. A steeper slope farther out (k > 0) only reduces the reach.
TEST_CASE("design over a curved slope: the best of the values tried, called an estimate" *
          doctest::test_suite("slow")) {
    for (const char* load : {"a = \"1\"", "P = \"1/5\""}) {
        const auto design = edgeproof::scene::parse_design(
            "[profile]\nkind = \"piecewise\"\nsymmetric = true\nknots = []\n"
            "slopes = [\"x + k*x^3\"]\n[parameters]\nk = { from = \"0\", to = \"1\" }\n[load]\n" +
                std::string(load) +
                "\ncontact_modulus = \"1\"\n[design]\nmaximise = \"first_exit\"\nterms = 1\n"
                "tolerance = \"1%\"\n",
            "cubic.toml");
        const edgeproof::scene::DesignResult found = run_design(design, {});
        CHECK(found.missing.find("curved") != std::string::npos);
        CHECK(found.best.value.midpoint().convert_to<double>() == 0);
        const double expected = 1 - 1 / (1.01 * 1.01);
        CHECK(std::fabs(found.best.reach.midpoint().convert_to<double>() - expected) < 1e-11);
    }
}

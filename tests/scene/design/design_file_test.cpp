// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/design/design_file.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "tests/scene/scene_words.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace edgeproof::scenes;

namespace {

const std::string flat_of_range =
    "flat-and-rounded t=={from=\"0\",to=\"1/2\"} R=10 a=1 design.tolerance=5%";

DesignScene designed(const std::string& words) {
    return scene::parse_design(toml_of(words), "scene.toml");
}

} // namespace

TEST_CASE("a design scene: its ranges, and the scene for a value of them") {
    const DesignScene design = designed(flat_of_range + " design.printed=={t=\"1/4\"}");
    CHECK(design.parameter == "t");
    CHECK(design.range.to == Rational(1, 2));
    CHECK(design.printed == Rational(1, 4));
    CHECK(design.tolerance.rational() == Rational(1, 20));
    CHECK(design.at(Rational(1, 3)).profile->parameters().at("t").rational() == Rational(1, 3));
    std::string why;
    CHECK(design.errors(why).size() == 1);
    // A user's name in knots and slopes; only whole names are replaced.
    CHECK(scene::with_name_replaced("r + 2*(rr - r1) - r^2", "r", "1/3") ==
          "(1/3) + 2*(rr - r1) - (1/3)^2");
    const std::string own = "piecewise symmetric knots=r a=1 design.tolerance=5% "
                            "parameters.r=={from=\"1/10\",to=\"9/10\"} slopes=";
    const DesignScene straight = designed(own + "x;r+2*(x-r)");
    CHECK(straight.at(Rational(1, 2)).profile->knots().back().rational() == Rational(1, 2));
    CHECK(straight.errors(why).size() == 1);
    // For a curved slope there is no enclosure over a range; the result states this.
    CHECK(designed(own + "x^3;r^3+3*(x-r)").errors(why).empty());
    CHECK(why.find("curved") != std::string::npos);
}

// The error of a cylinder, or of a wedge, depends on no radius or angle: for one term of Hertz the
// tolerance is reached at u/2a = 1 - (20/21)^2.
TEST_CASE("a design scene of every kind of power law") {
    for (const std::string range : {"wedge phi", "hertz R", "hertz R2=3 R1", "cone phi"}) {
        CAPTURE(range);
        const DesignScene design =
            designed(range + "=={from=\"1\",to=\"2\"} a=1 design.tolerance=5%");
        std::string why;
        CHECK(design.errors(why).size() == 1);
        if (range.starts_with("hertz")) {
            CHECK(contains(run_design(design, {}).best.reach, Rational(41, 441)));
        }
    }
}

// The search of `edgeproof extent` shares no formula with a design.
TEST_CASE("no other value of a parameter reaches farther, by the extents of its scenes") {
    for (const std::string load : {" a=1/4", " P=1/4"}) {
        for (const std::string edge : {"right", "left"}) {
            for (const std::string words :
                 {"tilted-flat-and-rounded alpha=1/10 R=2 t=={from=\"1/4\",to=\"1/2\"}",
                  "power-law C=1 m=={from=\"3/2\",to=\"5/2\"}"}) {
                CAPTURE(words + load + edge);
                const DesignScene design = designed(
                    words + load + " design.tolerance=5% design.terms==2 design.edge=" + edge);
                const BestReach best = run_design(design, {}).best;
                CHECK(best.proved);
                const auto reach = [&](const Rational& value) {
                    const AskedValue asked =
                        asked_value("extent_fraction_2", {{"edge", edge}, {"tolerance", "5%"}}, {});
                    SceneValues values(design.at(value), {asked}, {20});
                    return values.value(asked).value;
                };
                CHECK(overlaps(reach(*best.shown_at), best.shown_reach));
                for (long k = 0; k <= 6; ++k) {
                    const Rational width = design.range.to - design.range.from;
                    CHECK(certainly_less(reach(design.range.from + width * Rational(k, 6)),
                                         best.shown_reach + Ball(Rational(1, 1'000'000), 128)));
                }
            }
        }
    }
}

// For a cylinder p = c_0 sqrt(u) sqrt(1 - u/2a), so that the error of one term is e at u/2a = 1 -
// 1/(1 + e)^2. A steeper slope farther out (k > 0) only reduces the reach.
TEST_CASE("design over a curved slope: the best of the values tried, called an estimate" *
          doctest::test_suite("slow")) {
    for (const std::string load : {" a=1", " P=1/5"}) {
        const DesignScene design =
            designed("piecewise symmetric slopes=x+k*x^3 parameters.k=={from=\"0\",to=\"1\"} "
                     "design.tolerance=1%" +
                     load);
        const DesignResult found = run_design(design, {});
        CHECK(found.missing.find("curved") != std::string::npos);
        CHECK(found.best.value.midpoint().convert_to<double>() == 0);
        const double expected = 1 - 1 / (1.01 * 1.01);
        CHECK(std::fabs(found.best.reach.midpoint().convert_to<double>() - expected) < 1e-11);
    }
}

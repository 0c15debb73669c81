// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "tests/contact/scenes.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace edgeproof::scenes;

namespace {

using Course = SlopeMonotonicity::Kind;

/// Returns the monotonicity of a slope right of the origin, continued as an odd function, with
/// further pieces beyond knots.
SlopeMonotonicity course_of(const std::string& slopes, const std::string& knots, const char* a) {
    const Ball edge = Ball(exact(a).rational(), 200);
    return monotonicity_of_slope(curve(knots, slopes, true), edge, edge);
}

} // namespace

TEST_CASE("slopes that rise are proved to") {
    // g'' is of one sign, or 0 at an end (a power, a quotient, a knot that is not a binary number,
    // an irrational one), or 0 inside at a rational number, or infinite at the origin.
    for (const std::string slope : {"x/7",
                                    "sinh(x)",
                                    "x^3",
                                    "x^(3/2)",
                                    "x^7 + x^(9/4)",
                                    "x - sin(x)",
                                    "(x - 3/10)^3 + 27/1000",
                                    "x^3/(1 + x^2)",
                                    "sqrt(x)",
                                    "exp(x) - 1",
                                    "log(1 + x)",
                                    "tanh(x)",
                                    "atan(x)",
                                    "asin(x/2)",
                                    "asinh(x)",
                                    "sqrt(2*x + x^2)",
                                    "x + x*sqrt(x*(1 + x))",
                                    "atanh(x/3)",
                                    "pi/2 - acos(x/2)",
                                    "2^x - 1",
                                    "x*exp(x)",
                                    "x/sqrt(4 - x^2)",
                                    "2 - 2/(1 + x)",
                                    "cosh(x) - 1",
                                    "-(1 - exp(x))",
                                    "x/(1 + x)"}) {
        CAPTURE(slope);
        CHECK(course_of(slope, "", "7/8").kind == Course::rises);
    }
    for (const char* knot : {"1/3", "0.1", "pi/8", "sqrt(2)/3"}) {
        const std::string k = "(" + std::string(knot) + ")";
        CAPTURE(k);
        for (const std::string& behind :
             {k + "/9 + 3*(x - " + k + ")^2", k + "/9 + (x - " + k + ")^(5/2)",
              k + "/9 + (2*x - 2*" + k + ")^4/(1 + x)"}) {
            CAPTURE(behind);
            CHECK(course_of("x/9; " + behind, knot, "7/8").kind == Course::rises);
            // The edge is on the knot, or before it.
            CHECK(course_of("x^2; " + k + "^2 + x - " + k, knot, "1/20").kind == Course::rises);
        }
    }
    CHECK(course_of("x^2; 1/9 + (x - 1/3)^2", "1/3", "1/3").kind == Course::rises);
    // The piece ends before the function turns, or has a pole.
    CHECK(course_of("tan(x/2); tan(1/2) + x - 1", "1", "7/8").kind == Course::rises);
    CHECK(course_of("1 - cos(x); x", "2", "3").kind == Course::rises);
}

TEST_CASE("a slope that falls between the points where a profile is sampled is detected") {
    // 10/9 cos(1000 x) < -1 on a sixth of the cells.
    const SlopeMonotonicity wave = course_of("x + sin(1000*x)/900", "", "7/8");
    REQUIRE(wave.kind == Course::falls);
    const PrecisionScope scope(40);
    const Real x = wave.where->midpoint();
    CHECK(1 + cos(1000 * x) * 10 / 9 < 0);
    // The slope beyond the edge is irrelevant.
    CHECK(course_of("x; 1/2 + (x - 1/2) + sin(1000*(x - 1/2))/900", "1/2", "1/2").kind ==
          Course::rises);
    CHECK(course_of("x; 1/2 + (x - 1/2) + sin(1000*(x - 1/2))/900", "1/2", "3/4").kind ==
          Course::falls);
}

TEST_CASE("a slope that jumps down between the samples is not taken for one that rises") {
    // The rate is positive wherever it exists: the poles of the tangent are hidden in a bounded
    // function.
    for (const std::string slope :
         {"x + atan(tan(1000*x))/1000000", "x + atan(1/(1/3 - x))/1000000 - atan(3)/1000000",
          "x + tanh(1/(1/3 - x))/1000000 - tanh(3)/1000000"}) {
        CAPTURE(slope);
        CHECK(course_of(slope, "", "7/8").kind == Course::open);
        CHECK(course_of(slope, "", "1/1000").kind == Course::rises);
    }
    // The same for a slope that has no value beyond some point, or up to it.
    CHECK(course_of("x + (1/3 - x)^(5/2) - (1/3)^(5/2)", "", "7/8").kind == Course::open);
    CHECK(course_of("x + (x - 1/3)^(5/2)", "", "7/8").kind == Course::open);
}

TEST_CASE("a slope that cannot be decided is reported as undecided") {
    // (x - 3/10)^3 + 27/1000, multiplied out: balls do not show that g'' is 0 at 3/10.
    CHECK(course_of("x^3 - 9*x^2/10 + 27*x/100", "", "7/8").kind == Course::open);
    CHECK(course_of("x^3 - 9*x^2/10 + 27*x/100", "", "1/4").kind == Course::rises);
    CHECK(course_of("x^3 - 3*x^2/4 + 3*x/16", "", "7/8").kind == Course::rises);
    // If x/1000000000 is subtracted, the slope decreases.
    const SlopeMonotonicity less = course_of("x^3 - 9*x^2/10 + 27*x/100 - x/1000000000", "", "7/8");
    REQUIRE(less.kind == Course::falls);
    CHECK(abs(abs(less.where->midpoint()) - 0.3) < 0.0001);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/figures.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/report/well_formed.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

namespace {

/// y = x^2 at 0, 1, 2, with a gap at 1.5, and a single point.
Plot parabola() {
    Plot plot;
    plot.id = "parabola";
    plot.title = "<b>&\"";
    plot.description = "A parabola";
    plot.x = {"x"};
    plot.y = {"y"};
    plot.x.range = {0, 2};
    plot.y.range = {0, 4};
    plot.add_curve("y", "y", {Pen::Colour::black, 1, {}, 2});
    plot.add_curve("mark", "mark", {Pen::Colour::blue, 0, 7, 2});
    for (const char* x : {"0", "1"}) {
        plot.add_row(Real(x))[1] = Real(x) * Real(x);
    }
    plot.add_row(Real("1.5"));
    plot.add_row(Real("2"))[1] = 4;
    plot.add_row(Real("1"))[2] = 2;
    return plot;
}

TEST_SUITE("report: pictures") {
    TEST_CASE("a curve goes through its points in pixels and is broken at a gap") {
        const std::string svg = draw_svg({parabola()});
        CHECK(test::well_formed(svg) == "");
        // The drawing is 468 by 320 pixels: x = 0, 1, 2 are at 0, 234, 468; y = 0, 1, 4 at 320,
        // 240, 0.
        CHECK(svg.find("<path d=\"M0.0 320.0L234.0 240.0M468.0 0.0\"") != std::string::npos);
        CHECK(svg.find("<circle cx=\"234.0\" cy=\"160.0\"") != std::string::npos);
    }
    TEST_CASE("hostile text is escaped wherever a plot has text, also on a page") {
        for (const std::string text :
             {"</svg><script>alert(1)</script>", "]]>", "a\"b'c&d", "\x01\x7f"}) {
            CAPTURE(text);
            Plot plot = parabola();
            plot.title = plot.description = plot.x.label = plot.y.label = text;
            plot.curves.front().title = text;
            plot.level = {1, text};
            const std::string svg = draw_svg({plot});
            CHECK(test::well_formed(svg) == "");
            CHECK(test::well_formed(inline_svg(svg, plot)) == "");
            CHECK(svg.find("<script") == std::string::npos);
            plot.curves.clear();
            plot.field = PlaneField{{0, 1}, {0, 1}, {0, 1, 2, 3}, text, false, {0, 1}};
            CHECK(test::well_formed(draw_svg({plot})) == "");
        }
    }
    TEST_CASE("contours: no finite value is left out without a mark") {
        Plot plot = parabola();
        plot.field = PlaneField{{}, {}, {}, "s", false, {0, 1}};
        PlaneField& field = *plot.field;
        for (int k = 0; k < 40; ++k) {
            field.x.push_back(k);
            field.y.push_back(k);
        }
        for (int k = 0; k < 1600; ++k) {
            field.values.push_back(k % 41);
        }
        plot.title = "t";
        field.values[805] = 60; // (5, 20): above the others, and on the scale
        std::string svg = draw_svg({plot});
        CHECK(test::well_formed(svg) == "");
        CHECK(svg.find(">60</text>") != std::string::npos);
        CHECK(svg.find("&gt;") == std::string::npos);
        CHECK(svg.find("greatest drawn: 60 at (5, 20)") != std::string::npos);
        field.values[805] = 6000;
        field.values[0] = std::numeric_limits<double>::infinity();
        CHECK(draw_svg({plot}).find("&gt;") == std::string::npos);
        field.is_unbounded = true; // as near a place where the value is infinite
        svg = draw_svg({plot});
        CHECK(svg.find(">&gt; 40</text>") != std::string::npos);
        CHECK(svg.find("greatest drawn: 6000 at (5, 20)") != std::string::npos);
        field.is_signed = true;
        field.values[805] = -6000;
        svg = draw_svg({plot});
        CHECK(svg.find(">&lt; -40</text>") != std::string::npos);
        CHECK(svg.find("greatest size drawn: -6000 at (5, 20)") != std::string::npos);
        field.values.assign(1600, std::numeric_limits<double>::quiet_NaN());
        CHECK_THROWS_AS((void)draw_svg({plot}), Error);
    }
    TEST_CASE("contours: levels are labelled at their lines, zones are marked, at any width") {
        Plot plot = parabola();
        plot.field = PlaneField{{}, {}, {}, "s", false, {10, 30}, std::pair{12.0, 20.0}};
        for (int k = 0; k < 41; ++k) {
            plot.field->x.push_back(k);
            plot.field->y.push_back(k);
        }
        for (int k = 0; k < 41 * 41; ++k) {
            plot.field->values.push_back(k / 41); // NOLINT: the depth
        }
        const std::string svg = draw_svg({plot});
        // The line of 20 is at the middle of the drawing, which is 390 pixels high.
        CHECK(svg.find("<path d=\"M171.5 34H366.5") != std::string::npos); // 10 to 30 of 40
        CHECK(svg.find("orange: its stick zone") != std::string::npos);
        const std::size_t label = svg.find("paint-order");
        REQUIRE(label != std::string::npos);
        CHECK(svg.find("y=\"199.0\" text-anchor=\"middle\" font-size=\"10\">20<") !=
              std::string::npos);
        CHECK(test::well_formed(draw_svg({plot, parabola()}, 85)) == "");
        CHECK_THROWS_AS((void)draw_svg({plot}, 60), InputError);
    }
    TEST_CASE("panels stand below each other where a line is too short for them") {
        const std::string svg = draw_svg({parabola(), parabola(), parabola()}, 170);
        CHECK(svg.find("<g transform=\"translate(344 0)\">") != std::string::npos);
        CHECK(svg.rfind("<g transform=\"translate(0 ") > svg.find("translate(344 0)"));
        CHECK(svg.find("width=\"170.00mm\"") != std::string::npos);
    }
    TEST_CASE("a curve and the points that mark it have one name") {
        Plot plot = parabola();
        plot.curves[1].marks = 0;
        CHECK(draw_svg({plot}).find(">mark</text>") == std::string::npos);
    }
    TEST_CASE("percent: fractions of the data are drawn on an axis of percent") {
        Plot plot = parabola();
        plot.y.percent = true;
        plot.y.range = {0, 400};
        CHECK(draw_svg({plot}).find("<path d=\"M0.0 320.0L234.0 240.0M468.0 0.0\"") !=
              std::string::npos);
    }
    TEST_CASE("logarithmic axes have powers of ten; values of 0 are left out") {
        Plot plot = parabola();
        plot.x = {"x", true, std::pair<Real, Real>("0.1", 10)};
        const std::string svg = draw_svg({plot});
        CHECK(test::well_formed(svg) == "");
        // log10(1) is the middle of the axis; x = 0 is not drawn.
        CHECK(svg.find("<path d=\"M234.0 240.0M") != std::string::npos);
        CHECK(svg.find("10<tspan dy=\"-5\" font-size=\"10\">-1</tspan>") != std::string::npos);
        // Within a decade there are ticks, too.
        plot.x.range = {Real("0.3"), Real("0.6")};
        const std::string narrow = draw_svg({plot});
        CHECK(narrow.find(">0.5</text>") != std::string::npos);
        CHECK(narrow.find(">0.2</text>") == std::string::npos);
    }
    TEST_CASE("a plot without data and without ranges is an error") {
        Plot plot = parabola();
        plot.rows.clear();
        plot.x.range.reset();
        CHECK_THROWS_AS((void)draw_svg({plot}), Error);
    }
}

} // namespace

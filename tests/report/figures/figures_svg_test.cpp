// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_svg.hpp"

#include "edgeproof/precision/error.hpp"
#include "tests/report/well_formed.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

namespace {

/// y = x^2 at 0, 1, 2, with a gap at 1.5, and a single point.
Plot parabola() {
    Plot plot;
    plot.id = "parabola";
    plot.title = "<b>&\"";
    plot.description = "A parabola";
    plot.x = {"x"};
    plot.y = {"y"};
    plot.x.range = {"0", "2"};
    plot.y.range = {"0", "4"};
    plot.columns = {"x"};
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

TEST_SUITE("report: pictures without gnuplot") {
    TEST_CASE("a curve goes through its points in pixels and is broken at a gap") {
        const std::string svg = svg_without_gnuplot({parabola()});
        CHECK(test::well_formed(svg) == "");
        // The drawing is 468 by 320 pixels: x = 0, 1, 2 are at 0, 234, 468; y = 0, 1, 4 at 320,
        // 240, 0.
        CHECK(svg.find("<path d=\"M0.0 320.0L234.0 240.0M468.0 0.0\"") != std::string::npos);
        CHECK(svg.find("<circle cx=\"234.0\" cy=\"160.0\"") != std::string::npos);
    }
    TEST_CASE("text is escaped") {
        const std::string svg = svg_without_gnuplot({parabola()});
        CHECK(svg.find("<b>") == std::string::npos);
        CHECK(svg.find("&lt;b&gt;&amp;") != std::string::npos);
    }
    TEST_CASE("logarithmic axes have powers of ten; values of 0 are left out") {
        Plot plot = parabola();
        plot.x = {"x", true, std::pair{std::string("0.1"), std::string("10")}};
        const std::string svg = svg_without_gnuplot({plot});
        CHECK(test::well_formed(svg) == "");
        // log10(1) is the middle of the axis; x = 0 is not drawn.
        CHECK(svg.find("<path d=\"M234.0 240.0M") != std::string::npos);
        CHECK(svg.find("10<tspan dy=\"-5\" font-size=\"9\">-1</tspan>") != std::string::npos);
    }
    TEST_CASE("a plot without data and without ranges is an error") {
        Plot plot = parabola();
        plot.rows.clear();
        plot.x.range.reset();
        CHECK_THROWS_AS((void)svg_without_gnuplot({plot}), Error);
    }
}

} // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"
#include "edgeproof/report/figures/figures_paper.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

template <class T>
concept AddedToAScript = requires(GnuplotScript& script, T value) {
    script.add("{}", value);
};

static_assert(AddedToAScript<GnuplotText>);
static_assert(AddedToAScript<std::size_t>);
static_assert(!AddedToAScript<std::string>, "a text must be a GnuplotText");
static_assert(!AddedToAScript<const char*>, "a text must be a GnuplotText");
static_assert(!AddedToAScript<std::string_view>, "a text must be a GnuplotText");

/// Returns a command that would make the file `marker`, in each form that gnuplot or a shell
/// executes.
std::vector<std::string> hostile_texts(const std::string& marker) {
    const std::string touch = "touch " + marker;
    return {"`" + touch + "`",
            "'`" + touch + "`'",
            "''`" + touch + "`",
            "\"`" + touch + "`\"",
            "\\'`" + touch + "`",
            "' . system('" + touch + "') . '",
            "\" . system(\"" + touch + "\") . \"",
            "'\nsystem('" + touch + "')\n'",
            "\"\nsystem(\"" + touch + "\")\n#",
            "'\n!" + touch + "\n'",
            "'; !" + touch + "; '",
            "$(" + touch + ")",
            "@x",
            "|" + touch,
            "<" + touch,
            "a backslash at the end\\",
            "END_OF_DATA\nsystem('" + touch + "')\n$data << END_OF_DATA\n",
            std::string("nul \0 byte", 10),
            "bytes \xff\xfe that are no UTF-8",
            "</svg><script>alert(1)</script>",
            std::string(100'000, '`'),
            std::string(10'000, '\'')};
}

Plot plot_with(const std::string& text) {
    Plot plot;
    plot.id = text;
    plot.title = text;
    plot.description = text;
    plot.columns = {"x", text};
    plot.x = {text, true, std::pair<std::string, std::string>{"1", "3"}};
    plot.y = {text, false};
    plot.curves = {{text, text, {}}};
    plot.level = {"2", text};
    plot.bands = {{"1", "2", text}};
    for (int k = 1; k < 4; ++k) {
        plot.rows.push_back({Real(k), Real(k)});
    }
    return plot;
}

} // namespace

TEST_CASE("gnuplot executes no text of a plot, and the figure is made") {
    const auto gnuplot = find_gnuplot();
    if (!gnuplot) {
        MESSAGE("skipped: no gnuplot");
        return;
    }
    const PrecisionScope scope(40);
    const std::filesystem::path marker =
        std::filesystem::temp_directory_path() / ("edgeproof-marker-" + std::to_string(getpid()));
    for (const std::string& text : hostile_texts(marker.string())) {
        CAPTURE(text.substr(0, 100));
        const Plot plot = plot_with(text);
        const std::string svg = draw_svg(plot, *gnuplot);
        CHECK(svg.find("</svg>") != std::string::npos);
        CHECK(svg.find("<script>alert") == std::string::npos);
        CHECK(inline_svg(svg, plot).find("<script>alert") == std::string::npos);
        CHECK_FALSE(draw_picture({plot, plot}, PictureKind::png, 0, *gnuplot).empty());
        CHECK_FALSE(draw_picture({plot}, PictureKind::text, 90, *gnuplot).empty());
        CHECK_FALSE(std::filesystem::exists(marker));
    }
}

TEST_CASE("a figure shows a text as it was written, without the markup of enhanced text") {
    const auto gnuplot = find_gnuplot();
    if (!gnuplot) {
        MESSAGE("skipped: no gnuplot");
        return;
    }
    const PrecisionScope scope(40);
    const std::string svg = draw_svg(plot_with("σ_0^{2} it's \\n `x` @y"), *gnuplot);
    const std::string shown = "σ_0^{2} it’s \\n ‘x‘ @y";
    std::size_t found = 0;
    for (std::size_t at = 0; (at = svg.find(shown, at)) != std::string::npos; ++at) {
        ++found;
    }
    CHECK(found >= 6); // title, both axes, the curve, the level, the band
}

TEST_CASE("every figure of the paper is drawn") {
    const auto gnuplot = find_gnuplot();
    if (!gnuplot) {
        MESSAGE("skipped: no gnuplot");
        return;
    }
    const PrecisionScope scope(40);
    std::size_t drawn = 0;
    for (const FigureRecipe& figure : paper_figures("moore-hills")) {
        const Plot plot = figure.plots.front()();
        CAPTURE(plot.id.text());
        CHECK_NOTHROW((void)draw_svg(plot, *gnuplot));
        ++drawn;
    }
    CHECK(drawn == 8);
}

TEST_CASE("a number for gnuplot is one decimal number, and nothing else is accepted") {
    for (const char* number : {"0", "-1.5", "+2.", ".5", "1e-320", "3E+7"}) {
        CHECK(GnuplotNumber(number).text() == number);
    }
    for (const char* text :
         {"", "x", "1;2", "`x`", "1 2", "0x10", "1e", "nan", "inf", "1\n", "."}) {
        CAPTURE(text);
        CHECK_THROWS_AS(GnuplotNumber{text}, Error);
    }
    CHECK_THROWS_AS(GnuplotNumber{std::string(100'000, '1')}, Error);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace edgeproof::report {
namespace {

constexpr std::size_t named_in_a_line = 2;
constexpr std::size_t line_height = 19;
constexpr std::size_t text_lines = 26;

constexpr std::array okabe_ito{"#000000", "#E69F00", "#56B4E9", "#009E73",
                               "#F0E442", "#0072B2", "#D55E00", "#CC79A7"};

/// A double-quoted string of gnuplot; its markup (^, _, @, &) is switched off by `noenhanced`
/// where the string is set.
/// gnuplot takes letters, digits and _ only.
std::string element_name(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
    return name;
}

std::string gnuplot_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
        }
        out += c == '\n' ? ' ' : c;
    }
    return out + '"';
}

std::size_t column_index(const Plot& plot, std::string_view name) {
    const auto found = std::ranges::find(plot.columns, name);
    if (found == plot.columns.end()) {
        throw Error(fmt::format("figure {} has no column {}", plot.id, name));
    }
    return static_cast<std::size_t>(found - plot.columns.begin());
}

std::string row_text(const std::vector<std::optional<Real>>& row, std::string_view separator,
                     std::string_view missing) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
        line += i == 0 ? "" : separator;
        line += row[i] ? to_decimal(*row[i], figure_digits) : std::string(missing);
    }
    return line + '\n';
}

/// Grey that lets a dark page through, so that it is a shade on either.
void set_bands(std::string& script, const std::vector<Band>& bands) {
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const Band& band = bands[i];
        script += fmt::format("set object {} rectangle from first {}, graph 0 to first {}, graph 1 "
                              "behind fillcolor rgb \"#808080\" fillstyle transparent solid {:g} "
                              "noborder\n",
                              i + 1, band.from, band.to, band.darkness);
        script += fmt::format(
            "set label {} {} at first {}, graph {:g} left offset 0.4, 0 noenhanced "
            "font \",11\"\n",
            i + 1, gnuplot_text(band.title), band.from, 0.96 - 0.06 * static_cast<double>(i));
    }
}

void set_axis(std::string& script, char name, const Axis& axis) {
    script += fmt::format("set {}label {} noenhanced\n", name, gnuplot_text(axis.label));
    if (axis.logarithmic) {
        script += fmt::format("set logscale {0}\nset format {0} \"10^{{%T}}\"\n", name);
    }
    if (axis.range) {
        script += fmt::format("set {}range [{}:{}]\n", name, axis.range->first, axis.range->second);
    }
}

std::size_t key_lines(const Plot& plot) {
    return plot.key_below ? (plot.curves.size() + named_in_a_line - 1) / named_in_a_line : 0;
}

/// All but where it is drawn.
std::string plot_commands(const Plot& plot, PictureKind kind) {
    std::string script;
    script += fmt::format("set title {} noenhanced\n", gnuplot_text(plot.title));
    script += "set key bottom right reverse Left samplen 3 noenhanced\n";
    constexpr std::size_t most_inside = 4; // more would lie on the curves
    if (plot.key_below) {
        script += fmt::format("set key outside below center horizontal maxcols {} height 0.6 "
                              "samplen 2 width {} font \",12\"\n",
                              named_in_a_line, kind == PictureKind::text ? 1 : -4);
    } else if (plot.curves.size() > most_inside) {
        script += "set key outside right center\n";
    } else if (plot.y.logarithmic && !plot.x.logarithmic) {
        script += "set key bottom right\n";
    } else if (!plot.y.logarithmic) {
        script += "set key outside below center horizontal\n";
    }
    script += "set grid back lc rgb \"#999999\" lw 0.5 dt 3\n";
    set_axis(script, 'x', plot.x);
    set_axis(script, 'y', plot.y);
    set_bands(script, plot.bands);
    script += "$data << END_OF_DATA\n";
    for (const auto& row : plot.rows) {
        script += row_text(row, " ", "NaN");
    }
    script += "END_OF_DATA\nplot ";
    bool first = true;
    for (const Curve& curve : plot.curves) {
        const auto colour = okabe_ito[static_cast<std::size_t>(curve.pen.colour)];
        const bool joined = curve.pen.dash != 0;
        script += fmt::format("{}$data using 1:{} with {} lw {}{} lc rgb \"{}\"",
                              first ? "" : ", \\\n     ", column_index(plot, curve.column) + 1,
                              !joined           ? "points"
                              : curve.pen.point ? "linespoints"
                                                : "lines",
                              curve.pen.width, joined ? fmt::format(" dt {}", curve.pen.dash) : "",
                              colour);
        if (curve.pen.point) {
            script += fmt::format(" pt {} ps 0.6", *curve.pen.point);
        }
        script += " title " + gnuplot_text(curve.title);
        first = false;
    }
    if (plot.level) {
        script += fmt::format(", \\\n     {} with lines lw 1 dt 3 lc rgb \"#000000\" title {}",
                              plot.level->first, gnuplot_text(plot.level->second));
    }
    return script + '\n';
}

} // namespace

std::string to_csv(const Plot& plot) {
    std::string csv = "# " + plot.title + '\n';
    csv += "# " + plot.description + '\n';
    csv += "# program: " + program_line() + '\n';
    for (std::size_t i = 0; i < plot.columns.size(); ++i) {
        csv += (i == 0 ? "" : ",") + plot.columns[i];
    }
    csv += '\n';
    for (const auto& row : plot.rows) {
        csv += row_text(row, ",", "");
    }
    return csv;
}

std::string gnuplot_script(const Plot& plot, std::string_view output) {
    std::string script = "set encoding utf8\n";
    script += fmt::format("set terminal svg size 560,{} dynamic font \"sans-serif,14\" background "
                          "\"white\" name {}\n",
                          400 + line_height * key_lines(plot), gnuplot_text(element_name(plot.id)));
    return script + fmt::format("set output {}\n", gnuplot_text(output)) +
           plot_commands(plot, PictureKind::svg);
}

std::string gnuplot_script(const std::vector<Plot>& plots, PictureKind kind, std::size_t width,
                           std::string_view output) {
    constexpr std::size_t panel_width = 560;
    constexpr std::size_t panel_height = 440;
    constexpr double pixels_an_inch = 100;
    const std::size_t pixels = panel_width * plots.size();
    const std::string terminal =
        kind == PictureKind::svg
            ? fmt::format("svg size {},{} dynamic font \"sans-serif,14\" background \"white\"",
                          pixels, panel_height)
        : kind == PictureKind::png
            ? fmt::format("pngcairo size {},{} font \"sans,14\" fontscale 1.5 linewidth 2 "
                          "background \"white\"",
                          2 * pixels, 2 * panel_height)
        : kind == PictureKind::pdf ? fmt::format("pdfcairo size {:g}in,{:g}in font \"sans,12\"",
                                                 static_cast<double>(pixels) / pixels_an_inch,
                                                 panel_height / pixels_an_inch)
                                   : fmt::format("dumb mono size {},{}", width, text_lines);
    std::string script = "set encoding utf8\nset terminal " + terminal + "\n" +
                         fmt::format("set output {}\n", gnuplot_text(output));
    if (plots.size() == 1) {
        return script + plot_commands(plots.front(), kind);
    }
    script += fmt::format("set multiplot layout 1,{}\n", plots.size());
    for (const Plot& plot : plots) {
        script += "reset\n" + plot_commands(plot, kind);
    }
    return script + "unset multiplot\n";
}

} // namespace edgeproof::report

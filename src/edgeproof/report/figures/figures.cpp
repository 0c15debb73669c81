// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

namespace edgeproof::report {
namespace {

constexpr std::size_t named_in_a_line = 2;
constexpr std::size_t line_height = 19;
constexpr std::size_t text_lines = 26;

constexpr std::array okabe_ito{GnuplotWords("#000000"), GnuplotWords("#E69F00"),
                               GnuplotWords("#56B4E9"), GnuplotWords("#009E73"),
                               GnuplotWords("#F0E442"), GnuplotWords("#0072B2"),
                               GnuplotWords("#D55E00"), GnuplotWords("#CC79A7")};
static_assert(okabe_ito.size() == static_cast<std::size_t>(Pen::Colour::purple) + 1);

/// Returns the name of an SVG's elements, which is also used in its JavaScript.
GnuplotText element_name(const io::FileStem& id) {
    std::string name = id.text();
    std::ranges::replace_if(
        name, [](char c) { return c == '-' || c == '.'; }, '_');
    return GnuplotText(name);
}

std::size_t column_index(const Plot& plot, std::string_view name) {
    const auto found = std::ranges::find(plot.columns, name);
    if (found == plot.columns.end()) {
        throw Error(fmt::format("figure {} has no column {}", plot.id.text(), name));
    }
    return static_cast<std::size_t>(found - plot.columns.begin());
}

std::optional<std::string> cell_text(const std::optional<Real>& value) {
    return value && isfinite(*value) ? std::optional(to_decimal(*value, figure_digits))
                                     : std::nullopt;
}

void add_data(GnuplotScript& script, const Plot& plot) {
    script.add("$data << END_OF_DATA\n");
    for (const auto& row : plot.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            script.add("{}", i == 0 ? GnuplotWords("") : GnuplotWords(" "));
            if (const auto text = cell_text(row[i])) {
                script.add("{}", GnuplotNumber(*text));
            } else {
                script.add("NaN");
            }
        }
        script.add("\n");
    }
    script.add("END_OF_DATA\n");
}

/// A transparent grey, suitable for light and dark pages.
void set_bands(GnuplotScript& script, const std::vector<Band>& bands) {
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const Band& band = bands[i];
        const GnuplotNumber from(band.from);
        script.add("set object {} rectangle from first {}, graph 0 to first {}, graph 1 "
                   "behind fillcolor rgb \"#808080\" fillstyle transparent solid {:g} noborder\n",
                   i + 1, from, GnuplotNumber(band.to), band.darkness);
        script.add("set label {} {} at first {}, graph {:g} left offset 0.4, 0 noenhanced "
                   "font \",11\"\n",
                   i + 1, GnuplotText(band.title), from, 0.96 - 0.06 * static_cast<double>(i));
    }
}

void add_range_end(GnuplotScript& script, const std::string& end) {
    if (end == "*") {
        script.add("*"); // at the end of the data
    } else {
        script.add("{}", GnuplotNumber(end));
    }
}

void set_axis(GnuplotScript& script, GnuplotWords name, const Axis& axis) {
    script.add("set {}label {} noenhanced\n", name, GnuplotText(axis.label));
    if (axis.logarithmic) {
        script.add("set logscale {}\nset format {} \"10^{{%T}}\"\n", name, name);
    }
    if (axis.range) {
        script.add("set {}range [", name);
        add_range_end(script, axis.range->first);
        script.add(":");
        add_range_end(script, axis.range->second);
        script.add("]\n");
    }
}

constexpr std::size_t most_inside = 4; // more names would overlap the curves

bool key_is_below(const Plot& plot) {
    return plot.key_below || (plot.curves.size() <= most_inside && !plot.y.logarithmic);
}

/// gnuplot takes letters for wider than they are: its columns of long names are set closer.
constexpr std::size_t short_name = 12;

std::size_t longest_name(const Plot& plot) {
    std::size_t longest = plot.level ? plot.level->second.size() : 0;
    for (const Curve& curve : plot.curves) {
        longest = std::max(longest, curve.title.size());
    }
    return longest;
}

/// The number of lines of names below the plot, among them that of the level.
std::size_t key_lines(const Plot& plot) {
    const std::size_t names = plot.curves.size() + (plot.level ? 1 : 0);
    return key_is_below(plot) ? (names + named_in_a_line - 1) / named_in_a_line : 0;
}

void set_key(GnuplotScript& script, const Plot& plot, PictureKind kind) {
    script.add("set key bottom right reverse Left samplen 3 noenhanced\n");
    if (key_is_below(plot)) {
        script.add("set key outside below center horizontal maxcols {} height 0.6 samplen 2 "
                   "width {} font \",12\"\n",
                   named_in_a_line,
                   kind == PictureKind::text         ? 1
                   : longest_name(plot) < short_name ? 0
                                                     : -4);
    } else if (plot.curves.size() > most_inside) {
        script.add("set key outside right center\n");
    } else if (!plot.x.logarithmic) {
        script.add("set key bottom right\n");
    }
}

void add_curve(GnuplotScript& script, const Plot& plot, const Curve& curve) {
    const bool joined = curve.pen.dash != 0;
    const std::size_t column = column_index(plot, curve.column) + 1;
    if (plot.y.percent) {
        script.add("$data using 1:(100*column({}))", column);
    } else {
        script.add("$data using 1:{}", column);
    }
    script.add(" with {} lw {}",
               !joined           ? GnuplotWords("points")
               : curve.pen.point ? GnuplotWords("linespoints")
                                 : GnuplotWords("lines"),
               curve.pen.width);
    if (joined) {
        script.add(" dt {}", curve.pen.dash);
    }
    script.add(" lc rgb \"{}\"", okabe_ito.at(static_cast<std::size_t>(curve.pen.colour)));
    if (curve.pen.point) {
        script.add(" pt {} ps 0.6", *curve.pen.point);
    }
    script.add(" title {}", GnuplotText(curve.title));
}

/// Colours of the whole grid, and ten contours with their values.
void add_field(GnuplotScript& script, const Plot& plot) {
    const PlaneField& field = *plot.field;
    set_axis(script, GnuplotWords("x"), plot.x);
    set_axis(script, GnuplotWords("y"), plot.y);
    script.add("set cblabel {} noenhanced\nset cbrange [{:g}:{:g}]\n", GnuplotText(field.title),
               field.range.first, field.range.second);
    script.add("set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\n", field.x.front(), field.x.back(),
               field.y.back(), field.y.front());
    script.add("set palette defined (0 \"#0072b2\", 0.5 \"#f7f7f7\", 1 \"#d55e00\")\n"
               "$grid << END_OF_DATA\n");
    for (std::size_t j = 0; j < field.y.size(); ++j) {
        for (std::size_t i = 0; i < field.x.size(); ++i) {
            const double value = field.values[i + j * field.x.size()];
            script.add("{:.8g} {:.8g} ", field.x[i], field.y[j]);
            if (std::isfinite(value)) {
                script.add("{:.8g}\n", value);
            } else {
                script.add("NaN\n");
            }
        }
        script.add("\n");
    }
    constexpr int contours = 10;
    const double step = (field.range.second - field.range.first) / contours;
    script.add("END_OF_DATA\nset contour base\nunset surface\n"
               "set cntrparam levels incremental {:g},{:g},{:g}\nset table $contours\n"
               "splot $grid using 1:2:3 with lines\nunset table\n",
               field.range.first, step, field.range.second);
    script.add("set key off\nplot $grid using 1:2:3 with image, \\\n"
               "     $contours using 1:2 with lines lw 0.7 lc rgb \"#000000\"\n");
}

/// Adds all commands except the terminal.
void add_plot(GnuplotScript& script, const Plot& plot, PictureKind kind) {
    script.add("set title {} noenhanced\n", GnuplotText(plot.title));
    if (plot.field) {
        add_field(script, plot);
        return;
    }
    set_key(script, plot, kind);
    script.add("set grid back lc rgb \"#999999\" lw 0.5 dt 3\n");
    set_axis(script, GnuplotWords("x"), plot.x);
    set_axis(script, GnuplotWords("y"), plot.y);
    set_bands(script, plot.bands);
    add_data(script, plot);
    script.add("plot ");
    bool first = true;
    for (const Curve& curve : plot.curves) {
        script.add("{}", first ? GnuplotWords("") : GnuplotWords(", \\\n     "));
        add_curve(script, plot, curve);
        first = false;
    }
    if (plot.level) {
        script.add(", \\\n     {} with lines lw 1 dt 3 lc rgb \"#000000\" title {}",
                   GnuplotNumber(plot.level->first), GnuplotText(plot.level->second));
    }
    script.add("\n");
}

void set_terminal(GnuplotScript& script, PictureKind kind, std::size_t plots, std::size_t width) {
    constexpr std::size_t panel_width = 560;
    constexpr std::size_t panel_height = 440;
    constexpr double pixels_an_inch = 100;
    const std::size_t pixels = panel_width * plots;
    switch (kind) {
    case PictureKind::svg:
        script.add("set terminal svg size {},{} dynamic font \"sans-serif,14\" background "
                   "\"white\"\n",
                   pixels, panel_height);
        break;
    case PictureKind::png:
        script.add("set terminal pngcairo size {},{} font \"sans,14\" fontscale 1.5 linewidth 2 "
                   "background \"white\"\n",
                   2 * pixels, 2 * panel_height);
        break;
    case PictureKind::pdf:
        script.add("set terminal pdfcairo size {:g}in,{:g}in font \"sans,12\"\n",
                   static_cast<double>(pixels) / pixels_an_inch, panel_height / pixels_an_inch);
        break;
    case PictureKind::text:
        script.add("set terminal dumb mono size {},{}\n", width, text_lines);
        break;
    }
}

} // namespace

std::vector<std::optional<Real>>& Plot::add_row(const Real& first) {
    rows.emplace_back(columns.size()).front() = first;
    return rows.back();
}

void Plot::sort_rows() {
    std::ranges::stable_sort(rows, [](const auto& r, const auto& s) { return *r[0] < *s[0]; });
}

void Plot::add_curve(const std::string& column, std::string curve_title, const Pen& pen) {
    columns.push_back(column);
    curves.push_back({column, std::move(curve_title), pen});
    for (auto& row : rows) {
        row.emplace_back();
    }
}

std::string to_csv(const Plot& plot) {
    std::string csv = "# " + printable(plot.title) + '\n';
    csv += "# " + printable(plot.description) + '\n';
    csv += "# program: " + program_line() + '\n';
    for (std::size_t i = 0; i < plot.columns.size(); ++i) {
        csv += i == 0 ? "" : ",";
        add_csv_cell(csv, plot.columns[i]);
    }
    csv += '\n';
    for (const auto& row : plot.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            csv += (i == 0 ? "" : ",") + cell_text(row[i]).value_or("");
        }
        csv += '\n';
    }
    return csv;
}

GnuplotScript gnuplot_script(const Plot& plot) {
    GnuplotScript script;
    script.add("set encoding utf8\nset terminal svg size 560,{} dynamic font \"sans-serif,14\" "
               "background \"white\" name {}\n",
               400 + line_height * key_lines(plot), element_name(plot.id));
    add_plot(script, plot, PictureKind::svg);
    return script;
}

GnuplotScript gnuplot_script(const std::vector<Plot>& plots, PictureKind kind, std::size_t width) {
    GnuplotScript script;
    script.add("set encoding utf8\n");
    set_terminal(script, kind, plots.size(), width);
    if (plots.size() == 1) {
        add_plot(script, plots.front(), kind);
        return script;
    }
    script.add("set multiplot layout 1,{}\n", plots.size());
    for (const Plot& plot : plots) {
        script.add("reset\n");
        add_plot(script, plot, kind);
    }
    script.add("unset multiplot\n");
    return script;
}

namespace {

constexpr std::size_t longest_gnuplot_text = 300;
constexpr std::size_t longest_gnuplot_number = 400;

} // namespace

GnuplotText::GnuplotText(std::string_view text) {
    text_ = '\'';
    for (const char c : printable(shortened(text, longest_gnuplot_text))) {
        // gnuplot 5.4 does not accept a doubled quote at the beginning of a string.
        text_ += c == '\'' ? "’" : c == '`' ? "‘" : std::string(1, c);
    }
    text_ += '\'';
}

GnuplotNumber::GnuplotNumber(std::string_view number) : text_(number) {
    static const std::regex form(R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)");
    if (number.size() > longest_gnuplot_number || !std::regex_match(text_, form)) {
        throw Error("'" + printable(shortened(number, 40)) + "' is no number for gnuplot");
    }
}

} // namespace edgeproof::report

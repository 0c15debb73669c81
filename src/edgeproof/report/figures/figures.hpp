// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// The style of a curve: a colour of the palette of Okabe and Ito, safe for colour-blind readers,
/// and dashes or points, so that curves are distinguished without colour, too.
struct Pen {
    enum class Colour { black, orange, sky_blue, green, yellow, blue, vermilion, purple };
    Colour colour = Colour::black;
    unsigned dash = 1; ///< 1 is solid; 0: points without a line
    std::optional<unsigned> point = {};
    double width = 2;
};

struct Curve {
    std::string column;
    std::string title;
    Pen pen;
    std::optional<std::size_t> marks =
        {}; ///< the curve whose places these are; they share its name
};

struct Axis {
    std::string label; ///< with its unit
    bool logarithmic = false;
    std::optional<std::pair<Real, Real>> range = {}; ///< otherwise chosen by the data
    bool percent = false; ///< of y: fractions in the data are drawn as percent, as is the range
};

/// Values at the points of a grid, drawn as colours and contours: values[i + j x.size()] at x[i],
/// y[j]. Values that are not finite are left out. The colours of signed values are centred at 0.
/// All finite values are on the scale, unless the field has places where it grows without bound.
struct PlaneField {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> values;
    std::string title;                                   ///< of the scale, with its unit
    bool is_signed = false;                              ///< otherwise no value is negative
    std::pair<double, double> contact;                   ///< its ends, drawn at the smallest y
    std::optional<std::pair<double, double>> stick = {}; ///< the ends of its stick zone
    bool is_unbounded = false;
};

/// One panel: a table of x, with a column for each curve.
struct Plot {
    io::FileStem id;         ///< "fig2a": the name of its files
    std::string title;       ///< "a) wedge, m = 0"
    std::string description; ///< the picture in words, for readers who cannot see it
    Axis x;
    Axis y;
    std::string first_column = "x";
    /// x and the curves; a missing value is not defined (at a corner, for example).
    std::vector<std::vector<std::optional<Real>>> rows;
    std::vector<Curve> curves = {};
    /// A horizontal line: its position and its name.
    std::optional<std::pair<Real, std::string>> level = {};
    /// Drawn in place of the curves, with y downwards.
    std::optional<PlaneField> field = {};

    /// Adds a row with a value in its first column only, and returns the row.
    std::vector<std::optional<Real>>& add_row(const Real& first);
    /// Adds a column without values, and a curve for it.
    void add_curve(const std::string& column, std::string curve_title, const Pen& pen,
                   std::optional<std::size_t> marks = {});
};

inline constexpr unsigned figure_digits = 20;

/// Returns the table as CSV: notes after #, a line of names, values at `figure_digits`.
[[nodiscard]] std::string to_csv(const Plot& plot);

/// Draws the plots as SVG, in one line or, where a line is too short, in several. Positions are
/// computed with `Real` and rounded to a tenth of a pixel, so that the picture is the same on every
/// machine. Text and axes have the colour of the page's text. `width_mm`: the width in print (mm),
/// at which no text is smaller than 7 pt; 0: one pixel of the screen for each of the drawing.
/// Throws Error for a plot without data, and InputError for a width without room for that text.
[[nodiscard]] std::string draw_svg(const std::vector<Plot>& plots, double width_mm = 0);

/// Prepares the SVG of one plot for a page: with unique ids and without a background.
[[nodiscard]] std::string inline_svg(const std::string& svg, const Plot& plot);

/// Writes PLOT.csv, and PLOT.svg if `svg` is not empty, to a folder, named by the id of the plot.
void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder);

/// Throws InputError for an ending that picture_file does not support: others than .svg, .png and
/// .pdf.
void check_picture_name(const std::string& file);
/// Returns the picture in the format of the file's ending. `rsvg-convert` makes a .png (with two
/// pixels for each of the SVG) and a .pdf. Throws InputError if there is no such program, Error if
/// it fails.
[[nodiscard]] std::string picture_file(const std::vector<Plot>& plots, const std::string& file,
                                       double width_mm = 0);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/file_stem.hpp"
#include "edgeproof/precision/real.hpp"
#include "edgeproof/report/figures/gnuplot_script.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// How a curve is drawn: an index into the colour-blind-safe palette of Okabe and Ito, told apart
/// by dashes or points as well, so that nothing rests on colour alone.
struct Pen {
    enum class Colour { black, orange, sky_blue, green, yellow, blue, vermilion, purple };
    Colour colour = Colour::black;
    unsigned dash = 1; ///< 1 is solid; 0: points that no line joins
    std::optional<unsigned> point = {};
    double width = 2;
};

/// A column of the table against its first column.
struct Curve {
    std::string column;
    std::string title;
    Pen pen;
};

struct Axis {
    std::string label; ///< with its unit
    bool logarithmic = false;
    std::optional<std::pair<std::string, std::string>> range =
        {}; ///< as text, exactly; *: of the data
};

/// A part of the x axis, shaded over the whole height and named at its top. Numbers as text.
struct Band {
    std::string from;
    std::string to;
    std::string title;
    double darkness = 0.15; ///< of 1
};

/// One panel: a table, and which of its columns are drawn. Nothing in it depends on how.
struct Plot {
    io::FileStem id;         ///< "fig2a": the name of its files
    std::string title;       ///< "a) wedge, m = 0"
    std::string description; ///< says in words what is seen, for those who do not see it
    Axis x;
    Axis y;
    std::vector<std::string> columns;
    /// A missing value is where the quantity is not defined (a corner, say).
    std::vector<std::vector<std::optional<Real>>> rows;
    std::vector<Curve> curves;
    /// A horizontal line: where it is, and what it says.
    std::optional<std::pair<std::string, std::string>> level = {};
    std::vector<Band> bands = {};
    bool key_below = false; ///< the curves are named under the plot, however many they are
};

/// A figure of the page: panels with one caption.
struct Figure {
    std::string id;
    std::string title;
    std::string caption;
    std::vector<Plot> plots;
};

/// The digits to which tables of figures are written.
inline constexpr unsigned figure_digits = 20;

/// The table as CSV: notes behind #, a line of names, values at `figure_digits`.
[[nodiscard]] std::string to_csv(const Plot& plot);

/// A complete gnuplot script (data included) that writes the plot as SVG to standard output.
/// Deterministic: no date, no path.
[[nodiscard]] GnuplotScript gnuplot_script(const Plot& plot);

/// What a picture is made as. `text`: of letters, `width` columns wide.
enum class PictureKind { svg, png, pdf, text };

/// The same of several plots side by side.
[[nodiscard]] GnuplotScript gnuplot_script(const std::vector<Plot>& plots, PictureKind kind,
                                           std::size_t width);

} // namespace edgeproof::report

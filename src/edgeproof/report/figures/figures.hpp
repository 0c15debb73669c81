// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/real.hpp"

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// A text as a single-quoted string of gnuplot. gnuplot executes nothing in such a string: neither
/// commands in backquotes, nor macros, nor escapes. Quotes and backquotes become typographic ones,
/// line breaks become spaces, control characters become `\x1b` and so on, and the middle of a long
/// text is left out. (Commands that use the string turn off the markup of enhanced text by
/// `noenhanced`.)
class GnuplotText {
public:
    explicit GnuplotText(std::string_view text);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_; ///< in quotes
};

/// A decimal number as text. Throws Error for any other text.
class GnuplotNumber {
public:
    explicit GnuplotNumber(std::string_view number);
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

/// One or more words of gnuplot's language, fixed at compile time.
class GnuplotWords {
public:
    explicit consteval GnuplotWords(const char* words) : words_(words) {}
    [[nodiscard]] const char* text() const noexcept { return words_; }

private:
    const char* words_;
};

template <class T>
concept GnuplotToken =
    std::same_as<T, GnuplotText> || std::same_as<T, GnuplotNumber> || std::same_as<T, GnuplotWords>;

/// The types that may be inserted into a command. std::string is not one of them, so that input
/// text can reach gnuplot only as a GnuplotText.
template <class T>
concept GnuplotValue = std::integral<T> || std::floating_point<T> || GnuplotToken<T>;

/// A script for gnuplot: commands fixed at compile time, with inserted values.
class GnuplotScript {
public:
    template <class... Values>
    requires(GnuplotValue<std::remove_cvref_t<Values>>&&...) void add(
        fmt::format_string<Values...> commands, Values&&... values) {
        text_ += fmt::vformat(commands, fmt::make_format_args(values...));
    }
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

private:
    std::string text_;
};

} // namespace edgeproof::report

/// @cond a formatter of fmt, which doxygen does not place
template <edgeproof::report::GnuplotToken Token>
struct fmt::formatter<Token> : fmt::formatter<std::string_view> {
    template <class Context> auto format(const Token& token, Context& context) const {
        return fmt::formatter<std::string_view>::format(token.text(), context);
    }
};
/// @endcond

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
};

struct Axis {
    std::string label; ///< with its unit
    bool logarithmic = false;
    std::optional<std::pair<std::string, std::string>> range =
        {};               ///< exact numbers; *: chosen by the data
    bool percent = false; ///< of y: fractions in the data are drawn as percent, as is the range
};

/// A part of the x axis, shaded over the whole height and named at its top. Numbers are texts.
struct Band {
    std::string from;
    std::string to;
    std::string title;
    double darkness = 0.15; ///< between 0 and 1
};

/// Values at the points of a grid, drawn as colours and contours: values[i + j x.size()] at x[i],
/// y[j]. Values that are not finite are left out.
struct PlaneField {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> values;
    std::string title;               ///< of the scale, with its unit
    std::pair<double, double> range; ///< of the colours
};

/// One panel: a table, and the columns to be drawn, independent of the drawing program.
struct Plot {
    io::FileStem id;         ///< "fig2a": the name of its files
    std::string title;       ///< "a) wedge, m = 0"
    std::string description; ///< the picture in words, for readers who cannot see it
    Axis x;
    Axis y;
    std::vector<std::string> columns;
    /// A missing value means that the quantity is not defined (at a corner, for example).
    std::vector<std::vector<std::optional<Real>>> rows;
    std::vector<Curve> curves;
    /// A horizontal line: its position and its name.
    std::optional<std::pair<std::string, std::string>> level = {};
    std::vector<Band> bands = {};
    bool key_below = false; ///< the curves are always named below the plot
    /// Drawn in place of the curves, with y downwards.
    std::optional<PlaneField> field = {};

    /// Adds a row with a value in its first column only, and returns the row.
    std::vector<std::optional<Real>>& add_row(const Real& first);
    /// Sorts the rows by their first column, and keeps the order of equal ones.
    void sort_rows();
    /// Adds a column without values, and a curve for it.
    void add_curve(const std::string& column, std::string curve_title, const Pen& pen);
};

/// A figure of the page: panels with one caption.
struct Figure {
    std::string id;
    std::string title;
    std::string caption;
    std::vector<Plot> plots;
};

inline constexpr unsigned figure_digits = 20;

/// Returns the table as CSV: notes after #, a line of names, values at `figure_digits`.
[[nodiscard]] std::string to_csv(const Plot& plot);

/// Returns a complete gnuplot script (including the data) that writes the plot as SVG to standard
/// output. It contains no date and no path, so that it is always the same.
[[nodiscard]] GnuplotScript gnuplot_script(const Plot& plot);

/// The format of a picture. `text`: letters, `width` columns wide.
enum class PictureKind { svg, png, pdf, text };

/// Returns a script for several plots side by side.
[[nodiscard]] GnuplotScript gnuplot_script(const std::vector<Plot>& plots, PictureKind kind,
                                           std::size_t width);

} // namespace edgeproof::report

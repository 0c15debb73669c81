// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/figures.hpp"

#include "edgeproof/precision/precision.hpp"
#include "edgeproof/report/figures/svg_parts.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace edgeproof::report {
namespace {

using svg::drawing_height;
using svg::left_margin;
using svg::Scale;
using svg::smallest_text;
using svg::text_at;
using svg::top_margin;

// Lengths in pixels.
constexpr int usual_panel = 560;     ///< the width of a panel
constexpr int narrowest_panel = 320; ///< that holds its axes and the names of curves
constexpr int right_margin = 18;
constexpr int bottom_margin = 52;
constexpr int legend_line = 20;
constexpr std::size_t short_name = 27; ///< letters of a name that fits in half a line
constexpr double mark = 4;             ///< half the size of a point
constexpr std::string_view background = R"(<rect width="100%" height="100%" fill="#ffffff"/>)";

constexpr std::array<std::string_view, 8> colours{"currentColor", "#e69f00", "#56b4e9", "#009e73",
                                                  "#f0e442",      "#0072b2", "#d55e00", "#cc79a7"};
static_assert(colours.size() == static_cast<std::size_t>(Pen::Colour::purple) + 1);
constexpr std::array<std::string_view, 7> dashes{"",    "", "9 5", "2 3", "9 4 2 4", "9 3 2 3 2 3",
                                                 "14 4"};

std::string_view colour_of(const Pen& pen) {
    return colours.at(static_cast<std::size_t>(pen.colour));
}

/// Returns the attributes of a line.
std::string stroke(const Pen& pen) {
    const std::string_view dash = dashes[pen.dash % dashes.size()];
    return fmt::format(R"(fill="none" stroke="{}" stroke-width="{:g}"{})", colour_of(pen),
                       pen.width,
                       dash.empty() ? "" : fmt::format(R"( stroke-dasharray="{}")", dash));
}

/// Returns a point, by its number: 5 square, 7 circle, 9 triangle, 11 triangle on its tip,
/// 13 diamond; others are circles.
std::string point(double x, double y, const Pen& pen) {
    const auto polygon = [&](std::initializer_list<std::pair<double, double>> corners) {
        std::string text = "<polygon points=\"";
        for (const auto& [dx, dy] : corners) {
            text += fmt::format("{:.1f},{:.1f} ", x + mark * dx, y + mark * dy);
        }
        text.back() = '"';
        return text + fmt::format(" fill=\"{}\"/>\n", colour_of(pen));
    };
    switch (pen.point.value_or(7)) {
    case 5:
        return polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    case 9:
        return polygon({{-1.2, 1}, {0, -1.2}, {1.2, 1}});
    case 11:
        return polygon({{-1.2, -1}, {0, 1.2}, {1.2, -1}});
    case 13:
        return polygon({{-1.3, 0}, {0, -1.3}, {1.3, 0}, {0, 1.3}});
    default:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\"/>\n", x, y,
                           mark, colour_of(pen));
    }
}

class Panel {
public:
    Panel(const Plot& plot, int panel)
        : plot_(plot), panel_(panel), x_(plot.x, column(0), false), y_(plot.y, heights(), true) {}

    [[nodiscard]] svg::Panel drawn() const { return {text(), height()}; }

private:
    [[nodiscard]] std::string text() const {
        std::string text;
        text += svg::axes(x_, y_, plot_, width(), drawing_height, false);
        text += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n", left_margin,
                            top_margin, width(), drawing_height);
        if (plot_.level) {
            const double y = down(plot_.level->first);
            text += fmt::format("<path d=\"M0 {0:.1f}H{1}\" {2}/>\n", y, width(),
                                stroke({Pen::Colour::black, 3, {}, 1}));
        }
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
            text += curve(plot_.curves[i], i + 1);
        }
        return text + "</svg>\n" + legend();
    }
    /// The height with the names of the curves.
    [[nodiscard]] int height() const {
        const auto names = static_cast<int>(std::ranges::count_if(
                               plot_.curves, [](const Curve& c) { return !c.marks; })) +
                           (plot_.level ? 1 : 0);
        return top_margin + drawing_height + bottom_margin +
               legend_line * ((names + legend_columns() - 1) / legend_columns()) + 8;
    }
    [[nodiscard]] int width() const { return panel_ - left_margin - right_margin; }
    [[nodiscard]] int legend_columns() const {
        const bool all_short = std::ranges::all_of(
            plot_.curves, [](const Curve& c) { return c.title.size() <= short_name; });
        return panel_ == usual_panel && all_short &&
                       (!plot_.level || plot_.level->second.size() <= short_name)
                   ? 2
                   : 1;
    }
    [[nodiscard]] Real on_axis(const Real& y) const { return plot_.y.percent ? Real(100 * y) : y; }
    [[nodiscard]] std::vector<Real> column(std::size_t i) const {
        std::vector<Real> values;
        for (const auto& row : plot_.rows) {
            if (row[i] && isfinite(*row[i])) {
                values.push_back(*row[i]);
            }
        }
        return values;
    }
    [[nodiscard]] std::vector<Real> heights() const {
        std::vector<Real> values;
        for (std::size_t i = 1; i <= plot_.curves.size(); ++i) {
            for (const Real& y : column(i)) {
                if (!plot_.y.logarithmic || y > 0) {
                    values.push_back(on_axis(y));
                }
            }
        }
        return values;
    }
    // Within the drawing; what is far outside stays just outside.
    [[nodiscard]] static double pixels(const Real& part, int length) {
        const Real length_of_part = std::clamp(part, Real(-2), Real(3)) * length;
        return length_of_part.convert_to<double>() + 0.0; // no negative zero
    }
    [[nodiscard]] double across(const Real& x) const { return pixels(x_.part(x), width()); }
    [[nodiscard]] double down(const Real& y) const {
        return pixels(Real(1 - y_.part(y)), drawing_height);
    }
    [[nodiscard]] std::string curve(const Curve& curve, std::size_t column) const {
        std::string path;
        std::string points;
        char command = 'M';
        for (const auto& row : plot_.rows) {
            const std::optional<Real>& y = row[column];
            if (!y || !isfinite(*y) || !y_.has(*y) || !x_.has(*row[0])) {
                command = 'M';
                continue;
            }
            const double px = across(*row[0]);
            const double py = down(on_axis(*y));
            path += fmt::format("{}{:.1f} {:.1f}", command, px, py);
            command = 'L';
            if (curve.pen.point) {
                points += point(px, py, curve.pen);
            }
        }
        return (curve.pen.dash == 0 || path.empty()
                    ? ""
                    : fmt::format("<path d=\"{}\" {}/>\n", path, stroke(curve.pen))) +
               points;
    }
    [[nodiscard]] std::string legend() const {
        std::string text;
        const int columns = legend_columns();
        const bool narrow = panel_ < usual_panel;
        const int left = narrow ? 12 : left_margin;
        int place = 0;
        const auto sample = [&](const Pen& pen) {
            const double x = left + (place % columns) * (static_cast<double>(width()) / columns);
            const double y =
                top_margin + drawing_height + bottom_margin + legend_line * (place / columns);
            if (pen.dash != 0) {
                text += fmt::format("<path d=\"M{:.1f} {:.1f}h30\" {}/>\n", x, y, stroke(pen));
            }
            if (pen.point) {
                text += point(x + 15, y, pen);
            }
            return std::pair(x, y);
        };
        const auto add = [&](const Pen& pen, const std::string& title) {
            const auto [x, y] = sample(pen);
            text +=
                text_at(x + 36, y + 4, "start", narrow ? smallest_text : 12, escape_html(title));
        };
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
            if (plot_.curves[i].marks) {
                continue;
            }
            add(plot_.curves[i].pen, plot_.curves[i].title);
            for (const Curve& other : plot_.curves) {
                if (other.marks == i) {
                    (void)sample(other.pen);
                }
            }
            ++place;
        }
        if (plot_.level) {
            add({Pen::Colour::black, 3, {}, 1}, plot_.level->second);
        }
        return text;
    }

    const Plot& plot_;
    int panel_; ///< its width
    Scale x_;
    Scale y_;
};

/// The number of panels in a line, and their width: the smallest text has 7 pt in print, and a
/// panel at most the usual width. 0 mm: all in one line.
std::pair<std::size_t, int> layout(std::size_t plots, double width_mm) {
    if (width_mm == 0) {
        return {plots, usual_panel};
    }
    const double pixels_of_mm = 72 / 25.4 * smallest_text / 7; // 72 pt an inch
    const auto pixels = static_cast<int>(width_mm * pixels_of_mm);
    require(
        pixels >= narrowest_panel,
        fmt::format("a picture {:g} mm wide has no room for a panel with text of 7 pt", width_mm),
        fmt::format("give {:.0f} mm or more", std::ceil(narrowest_panel / pixels_of_mm)));
    const std::size_t in_line = std::min(plots, static_cast<std::size_t>(pixels / narrowest_panel));
    return {in_line, std::min(usual_panel, pixels / static_cast<int>(in_line))};
}

/// The greatest size of text at which a title has room in its panel; not below the smallest one.
int title_size(const std::string& title, int panel) {
    constexpr double letter = 0.57; // the mean width of a letter of size 1
    const double size = panel / (letter * static_cast<double>(title.size() + 1));
    return static_cast<int>(std::clamp(size, double{smallest_text}, 15.0));
}

} // namespace

std::string draw_svg(const std::vector<Plot>& plots, double width_mm) {
    const auto [in_line, panel_width] = layout(plots.size(), width_mm);
    const PrecisionScope scope(figure_digits + 10);
    std::string panels;
    std::string title;
    std::string description;
    const int width = static_cast<int>(in_line) * panel_width;
    int height = 0;
    int from_left = 0;
    int from_top = 0; // of the line of panels
    for (const Plot& plot : plots) {
        if (from_left == width) {
            from_left = 0;
            from_top = height;
        }
        const svg::Panel panel =
            plot.field ? svg::contours(plot, panel_width) : Panel(plot, panel_width).drawn();
        panels += fmt::format("<g transform=\"translate({} {})\">\n", from_left, from_top) +
                  text_at(panel_width / 2.0, 20, "middle", title_size(plot.title, panel_width),
                          escape_html(plot.title)) +
                  panel.text + "</g>\n";
        height = std::max(height, from_top + panel.height);
        from_left += panel_width;
        title += (title.empty() ? "" : "; ") + plot.title;
        description += (description.empty() ? "" : " ") + plot.description;
    }
    const auto printed = [&](int pixels) {
        return width_mm == 0 ? std::to_string(pixels)
                             : fmt::format("{:.2f}mm", pixels * width_mm / width);
    };
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{6}\" height=\"{7}\" "
                       "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" fill=\"currentColor\">\n"
                       "<title>{2}</title>\n<desc>{3}</desc>\n<metadata>{4}</metadata>\n{5}\n",
                       width, height, escape_html(title), escape_html(description),
                       escape_html(program_line()), background, printed(width), printed(height)) +
           panels + "</svg>\n";
}

std::string inline_svg(const std::string& svg, const Plot& plot) {
    const std::string title = plot.id.with("-title");
    const std::string description = plot.id.with("-desc");
    std::string out = svg;
    const auto replace = [&](std::string_view from, const std::string& with) {
        out.replace(out.find(from), from.size(), with);
    };
    replace("<svg", "<svg role=\"img\" aria-labelledby=\"" + title + ' ' + description + "\"");
    replace("<title>", "<title id=\"" + title + "\">");
    replace("<desc>", "<desc id=\"" + description + "\">");
    replace(background, "");
    const std::size_t metadata = out.find("<metadata>"); // the page names the program
    out.erase(metadata,
              out.find("</metadata>") + std::string_view("</metadata>").size() - metadata);
    return out;
}

} // namespace edgeproof::report

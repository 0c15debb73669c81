// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_svg.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/precision.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace edgeproof::report {
namespace {

// Lengths in pixels.
constexpr int panel_width = 560;
constexpr int left_margin = 74;
constexpr int right_margin = 18;
constexpr int top_margin = 34;
constexpr int bottom_margin = 52;
constexpr int drawing_height = 320;
constexpr int legend_line = 20;
constexpr int legend_columns = 2;
constexpr int most_ticks = 6;
constexpr int most_decades = 7; ///< more are labelled by every second, third, ... power
constexpr double mark = 4;      ///< half the size of a point

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

/// Returns a point of gnuplot's numbers: 5 square, 7 circle, 9 triangle, 11 triangle on its tip,
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

std::string text_at(double x, double y, std::string_view anchor, int size,
                    const std::string& escaped) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}"
                       "</text>\n",
                       x, y, anchor, size, escaped);
}

/// A scale of an axis: its range, and the position of a value as a part of the length.
class Scale {
public:
    /// `values` are the data, from which the ends are taken that the axis leaves open.
    Scale(const Axis& axis, const std::vector<Real>& values) : logarithmic_(axis.logarithmic) {
        std::optional<Real> ends[2];
        if (axis.range) {
            const auto end = [](const std::string& text) {
                return text == "*" ? std::optional<Real>{} : std::optional<Real>(Real(text));
            };
            ends[0] = end(axis.range->first);
            ends[1] = end(axis.range->second);
        }
        if (values.empty() && !(ends[0] && ends[1])) {
            throw Error("a figure without data has no range");
        }
        low_ = on_scale(ends[0] ? *ends[0] : *std::min_element(values.begin(), values.end()));
        high_ = on_scale(ends[1] ? *ends[1] : *std::max_element(values.begin(), values.end()));
        if (!(low_ < high_)) {
            high_ = low_ + 1;
        }
    }
    /// Returns 0 at the low end and 1 at the high one.
    [[nodiscard]] Real part(const Real& value) const {
        return Real((on_scale(value) - low_) / (high_ - low_));
    }
    [[nodiscard]] bool has(const Real& value) const { return !logarithmic_ || value > 0; }

    struct Tick {
        Real part;
        std::string label; ///< as SVG
    };
    [[nodiscard]] std::vector<Tick> ticks() const { return logarithmic_ ? decades() : steps(); }

private:
    [[nodiscard]] Real on_scale(const Real& value) const {
        return logarithmic_ ? Real(log10(value)) : value;
    }
    [[nodiscard]] std::vector<Tick> decades() const {
        const Real first = ceil(low_ - Real(1e-9));
        const Real last = floor(high_ + Real(1e-9));
        const int step = static_cast<int>(last - first) / most_decades + 1;
        std::vector<Tick> all;
        for (Real k = first; k <= last; k += step) {
            all.push_back({Real((k - low_) / (high_ - low_)),
                           fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>",
                                       static_cast<int>(k))});
        }
        return all;
    }
    /// Steps of 1, 2 or 5 times a power of ten.
    [[nodiscard]] std::vector<Tick> steps() const {
        const Real raw = (high_ - low_) / most_ticks;
        const Real power = pow(Real(10), floor(log10(raw)));
        const Real lead = raw / power;
        const Real step = power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
        std::vector<Tick> all;
        for (Real k = ceil(low_ / step); k * step <= high_; k += 1) {
            const Real value = k == 0 ? Real(0) : Real(k * step); // not -0
            all.push_back({part(value), fmt::format("{:g}", value.convert_to<double>())});
        }
        return all;
    }

    bool logarithmic_;
    Real low_;
    Real high_;
};

class Panel {
public:
    explicit Panel(const Plot& plot) : plot_(plot), x_(plot.x, column(0)), y_(plot.y, heights()) {}

    [[nodiscard]] std::string text(int from_left) const {
        std::string svg = fmt::format("<g transform=\"translate({} 0)\">\n", from_left);
        svg += text_at(left_margin + width() / 2.0, 20, "middle", 15, escape_html(plot_.title));
        svg += axes();
        svg += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n", left_margin,
                           top_margin, width(), drawing_height);
        for (const Band& band : plot_.bands) {
            const double from = across(Real(band.from));
            svg += fmt::format("<rect x=\"{:.1f}\" y=\"0\" width=\"{:.1f}\" height=\"{}\" "
                               "fill=\"#808080\" fill-opacity=\"{:g}\"/>\n",
                               from, across(Real(band.to)) - from, drawing_height, band.darkness);
            svg += text_at(from + 4, 14, "start", 11, escape_html(band.title));
        }
        if (plot_.level) {
            const double y = down(Real(plot_.level->first));
            svg += fmt::format("<path d=\"M0 {0:.1f}H{1}\" {2}/>\n", y, width(),
                               stroke({Pen::Colour::black, 3, {}, 1}));
        }
        for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
            svg += curve(plot_.curves[i]);
        }
        return svg + "</svg>\n" + legend() + "</g>\n";
    }
    /// The height with the names of the curves.
    [[nodiscard]] int height() const {
        const int names = static_cast<int>(plot_.curves.size()) + (plot_.level ? 1 : 0);
        return top_margin + drawing_height + bottom_margin +
               legend_line * ((names + legend_columns - 1) / legend_columns) + 8;
    }

private:
    [[nodiscard]] static int width() { return panel_width - left_margin - right_margin; }
    [[nodiscard]] std::size_t index_of(const std::string& name) const {
        const auto found = std::find(plot_.columns.begin(), plot_.columns.end(), name);
        if (found == plot_.columns.end()) {
            throw Error(fmt::format("figure {} has no column {}", plot_.id.text(), name));
        }
        return static_cast<std::size_t>(found - plot_.columns.begin());
    }
    [[nodiscard]] Real drawn(const Real& y) const { return plot_.y.percent ? Real(100 * y) : y; }
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
        for (const Curve& curve : plot_.curves) {
            for (const Real& y : column(index_of(curve.column))) {
                if (!plot_.y.logarithmic || y > 0) {
                    values.push_back(drawn(y));
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
    [[nodiscard]] std::string axes() const {
        std::string grid;
        std::string labels;
        for (const Scale::Tick& tick : x_.ticks()) {
            const double x = left_margin + pixels(tick.part, width());
            grid += fmt::format("M{:.1f} {}v{}", x, top_margin, drawing_height);
            labels += text_at(x, top_margin + drawing_height + 17, "middle", 12, tick.label);
        }
        for (const Scale::Tick& tick : y_.ticks()) {
            const double y = top_margin + pixels(Real(1 - tick.part), drawing_height);
            grid += fmt::format("M{} {:.1f}h{}", left_margin, y, width());
            labels += text_at(left_margin - 7, y + 4, "end", 12, tick.label);
        }
        const double middle = top_margin + drawing_height / 2.0;
        return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#999999\" stroke-width=\"0.5\" "
                           "stroke-dasharray=\"2 3\"/>\n"
                           "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
                           "stroke=\"currentColor\"/>\n",
                           grid, left_margin, top_margin, width(), drawing_height) +
               labels +
               text_at(left_margin + width() / 2.0, top_margin + drawing_height + 38, "middle", 13,
                       escape_html(plot_.x.label)) +
               fmt::format("<g transform=\"rotate(-90 16 {0:.1f})\">{1}</g>\n", middle,
                           text_at(16, middle, "middle", 13, escape_html(plot_.y.label)));
    }
    [[nodiscard]] std::string curve(const Curve& curve) const {
        const std::size_t column = index_of(curve.column);
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
            const double py = down(drawn(*y));
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
        std::string svg;
        int place = 0;
        const auto add = [&](const Pen& pen, const std::string& title) {
            const double x =
                left_margin + (place % legend_columns) * (width() / double{legend_columns});
            const double y = top_margin + drawing_height + bottom_margin +
                             legend_line * (place / legend_columns);
            ++place;
            if (pen.dash != 0) {
                svg += fmt::format("<path d=\"M{:.1f} {:.1f}h30\" {}/>\n", x, y, stroke(pen));
            }
            if (pen.point) {
                svg += point(x + 15, y, pen);
            }
            svg += text_at(x + 36, y + 4, "start", 12, escape_html(title));
        };
        for (const Curve& curve : plot_.curves) {
            add(curve.pen, curve.title);
        }
        if (plot_.level) {
            add({Pen::Colour::black, 3, {}, 1}, plot_.level->second);
        }
        return svg;
    }

    const Plot& plot_;
    Scale x_;
    Scale y_;
};

} // namespace

std::string svg_without_gnuplot(const std::vector<Plot>& plots) {
    const PrecisionScope scope(figure_digits + 10);
    std::string panels;
    int height = 0;
    int from_left = 0;
    for (const Plot& plot : plots) {
        const Panel panel(plot);
        panels += panel.text(from_left);
        height = std::max(height, panel.height());
        from_left += panel_width;
    }
    std::string title;
    std::string description;
    for (const Plot& plot : plots) {
        title += (title.empty() ? "" : "; ") + plot.title;
        description += (description.empty() ? "" : " ") + plot.description;
    }
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                       "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" fill=\"currentColor\">\n"
                       "<title>{2}</title>\n<desc>{3}</desc>\n<metadata>{4}</metadata>\n"
                       "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                       from_left, height, escape_html(title), escape_html(description),
                       escape_html(program_line())) +
           panels + "</svg>\n";
}

} // namespace edgeproof::report

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/svg_parts.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

/// Contours: the cells of the grid in colours, lines of equal value, and a bar of the colours.
namespace edgeproof::report::svg {
namespace {

constexpr int bar_width = 14;
constexpr int not_drawing = 170; ///< the width of a panel without the drawing
constexpr int colours = 60;
constexpr int most_lines = 12;
constexpr std::string_view stick_colour = "#e69f00";
/// The scale of an unbounded field ends at this quantile of the sizes if the greatest is more than
/// `most_times` as large, and would take the whole scale.
constexpr double quantile = 0.995;
constexpr double most_times = 2;
constexpr std::array label_half{26.0, 8.0}; ///< half the size of a line's label

using Colour = std::array<double, 3>;
/// From white to dark blue for values of one sign; from blue over white to red for signed ones.
constexpr std::array<Colour, 4> sequential{
    {{255, 255, 229}, {120, 198, 121}, {29, 125, 160}, {8, 29, 88}}};
constexpr std::array<Colour, 5> diverging{
    {{5, 48, 97}, {103, 169, 207}, {247, 247, 247}, {239, 138, 98}, {103, 0, 31}}};

template <std::size_t n> std::string mixed(const std::array<Colour, n>& stops, double part) {
    const double at = std::clamp(part, 0.0, 1.0) * (n - 1);
    const auto k = std::min(static_cast<std::size_t>(at), n - 2);
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        rgb[i] = static_cast<int>(std::lround(stops[k][i] + (at - static_cast<double>(k)) *
                                                                (stops[k + 1][i] - stops[k][i])));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

class Field {
public:
    Field(const Plot& plot, int panel)
        : plot_(plot), field_(*plot.field), width_(panel - not_drawing) {
        std::vector<double> sizes;
        for (std::size_t i = 0; i < field_.values.size(); ++i) {
            const double value = field_.values[i];
            if (std::isfinite(value)) {
                sizes.push_back(std::fabs(value));
                low_ = std::min(low_, value);
                high_ = std::max(high_, value);
                greatest_ = std::fabs(value) > std::fabs(field_.values[greatest_]) ||
                                    !std::isfinite(field_.values[greatest_])
                                ? i
                                : greatest_;
            }
        }
        if (sizes.empty()) {
            throw Error("a figure without a finite value");
        }
        const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(
                                            quantile * static_cast<double>(sizes.size() - 1));
        std::ranges::nth_element(sizes, at);
        const double most = std::max(high_, -low_);
        limit_ = field_.is_unbounded && *at > 0 && most > most_times * *at ? *at : most;
        low_ = std::max(low_, -limit_);
        high_ = std::min(high_, limit_);
    }

    [[nodiscard]] Panel drawn() const {
        const double aspect =
            (field_.y.back() - field_.y.front()) / (field_.x.back() - field_.x.front());
        const int height = static_cast<int>(std::lround(width_ * std::clamp(aspect, 0.2, 1.0)));
        Axis x_axis = plot_.x;
        Axis y_axis = plot_.y;
        x_axis.range = {field_.x.front(), field_.x.back()};
        y_axis.range = {field_.y.front(), field_.y.back()};
        const Scale x(x_axis, {}, false);
        const Scale y(y_axis, {}, false);
        std::string text = fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n",
                                       left_margin, top_margin, width_, height) +
                           cells(height) + lines(height) + "</svg>\n" +
                           axes(x, y, plot_, width_, height, true);
        const auto across = [&](double at) {
            return left_margin +
                   width_ * (at - field_.x.front()) / (field_.x.back() - field_.x.front());
        };
        const auto zone = [&](const std::pair<double, double>& ends, std::string_view colour) {
            text += fmt::format("<path d=\"M{0} {1}H{2}M{0} {3}v8M{2} {3}v8\" fill=\"none\" "
                                "stroke=\"{4}\" stroke-width=\"3\"/>\n",
                                number(across(ends.first)), top_margin, number(across(ends.second)),
                                top_margin - 4, colour);
        };
        zone(field_.contact, "currentColor");
        if (field_.stick) {
            zone(*field_.stick, stick_colour);
        }
        const std::size_t columns = field_.x.size();
        const auto note = [&](int line, const std::string& words) {
            text +=
                text_at(20, top_margin + height + 56 + 15 * line, "start", smallest_text, words);
        };
        note(0, field_.stick ? "thick: the contact; orange: its stick zone" : "thick: the contact");
        note(1, fmt::format("greatest{} drawn: {:.4g} at ({:.4g}, {:.4g})",
                            field_.is_signed ? " size" : "", field_.values[greatest_],
                            field_.x[greatest_ % columns], field_.y[greatest_ / columns]));
        return {text + bar(height), top_margin + height + 82};
    }

private:
    [[nodiscard]] std::string colour_of(double value) const {
        return field_.is_signed ? mixed(diverging, 0.5 + value / (2 * limit_))
                                : mixed(sequential, value / limit_);
    }
    [[nodiscard]] double value(std::size_t i, std::size_t j) const {
        return field_.values[i + j * field_.x.size()];
    }
    /// Values at the mid-points of the colours, so that runs of one colour are long.
    [[nodiscard]] double rounded(double value) const {
        const double unit = limit_ / colours;
        return (std::floor(std::clamp(value, -limit_, limit_) / unit) + 0.5) * unit;
    }

    /// Runs of cells with one colour. A cell has its point in the middle.
    [[nodiscard]] std::string cells(int height) const {
        const double dx = width_ / static_cast<double>(field_.x.size() - 1);
        const double dy = height / static_cast<double>(field_.y.size() - 1);
        std::map<std::string, std::string> paths; // by colour
        for (std::size_t j = 0; j < field_.y.size(); ++j) {
            for (std::size_t i = 0; i < field_.x.size();) {
                const double first = value(i, j);
                std::size_t end = i + 1;
                while (end < field_.x.size() && std::isfinite(first) &&
                       std::isfinite(value(end, j)) && rounded(value(end, j)) == rounded(first)) {
                    ++end;
                }
                if (std::isfinite(first)) {
                    paths[colour_of(rounded(first))] +=
                        fmt::format("M{} {}h{}v{}H{}z", number((static_cast<double>(i) - 0.5) * dx),
                                    number((static_cast<double>(j) - 0.5) * dy),
                                    number(static_cast<double>(end - i) * dx + 0.1),
                                    number(dy + 0.1), number((static_cast<double>(i) - 0.5) * dx));
                }
                i = end;
            }
        }
        std::string text = "<g shape-rendering=\"crispEdges\">\n";
        for (const auto& [colour, path] : paths) {
            text += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, colour);
        }
        return text + "</g>\n";
    }

    [[nodiscard]] Scale scale() const {
        return Scale({"", false, std::pair<Real, Real>(low_, high_)}, {}, false);
    }

    /// The lines of round values, each with its value. Each cell between four
    /// points is cut into two triangles, in which a line is straight.
    [[nodiscard]] std::string lines(int height) const {
        const double dx = width_ / static_cast<double>(field_.x.size() - 1);
        const double dy = height / static_cast<double>(field_.y.size() - 1);
        std::string path;
        std::string labels;
        struct Corner {
            double x, y, value;
        };
        std::vector<std::array<double, 2>> on_line; // places of the line of one level
        std::vector<std::array<double, 2>> labelled;
        const auto cut = [&](const std::array<Corner, 3>& corners, double level) {
            std::string ends;
            for (std::size_t k = 0; k < 3; ++k) {
                const Corner& one = corners[k];
                const Corner& other = corners[(k + 1) % 3];
                if ((one.value < level) != (other.value < level)) {
                    const double part = (level - one.value) / (other.value - one.value);
                    on_line.push_back({dx * (one.x + part * (other.x - one.x)),
                                       dy * (one.y + part * (other.y - one.y))});
                    ends += fmt::format("{}{} {}", ends.empty() ? 'M' : 'L',
                                        number(on_line.back()[0]), number(on_line.back()[1]));
                }
            }
            path += ends;
        };
        for (const Scale::Tick& tick : scale().ticks(most_lines)) {
            const auto level = tick.value.convert_to<double>();
            on_line.clear();
            for (std::size_t j = 0; j + 1 < field_.y.size(); ++j) {
                for (std::size_t i = 0; i + 1 < field_.x.size(); ++i) {
                    const auto corner = [&](std::size_t di, std::size_t dj) {
                        return Corner{static_cast<double>(i + di), static_cast<double>(j + dj),
                                      value(i + di, j + dj)};
                    };
                    const Corner here = corner(0, 0);
                    const Corner far = corner(1, 1);
                    for (const Corner& third : {corner(1, 0), corner(0, 1)}) {
                        if (std::isfinite(here.value) && std::isfinite(far.value) &&
                            std::isfinite(third.value)) {
                            cut({here, third, far}, level);
                        }
                    }
                }
            }
            if (const auto at = label_place(on_line, labelled, height)) {
                labelled.push_back(*at);
                labels += fmt::format(
                    "<g fill=\"#000000\" stroke=\"#ffffff\" stroke-width=\"2.5\" "
                    "stroke-linejoin=\"round\" paint-order=\"stroke\">{}</g>\n",
                    text_at((*at)[0], (*at)[1] + 4, "middle", smallest_text, tick.label));
            }
        }
        return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#000000\" "
                           "stroke-width=\"0.5\"/>\n",
                           path) +
               labels;
    }
    /// The deepest place of a line where a label has room; nothing if there is none.
    [[nodiscard]] std::optional<std::array<double, 2>>
    label_place(const std::vector<std::array<double, 2>>& on_line,
                const std::vector<std::array<double, 2>>& labelled, int height) const {
        const auto has_room = [&](const std::array<double, 2>& at) {
            const std::array<double, 2> size{static_cast<double>(width_),
                                             static_cast<double>(height)};
            return std::ranges::all_of(std::array{0, 1},
                                       [&](std::size_t k) {
                                           return at[k] > label_half[k] &&
                                                  at[k] < size[k] - label_half[k];
                                       }) &&
                   std::ranges::none_of(labelled, [&](const std::array<double, 2>& other) {
                       return std::fabs(at[0] - other[0]) < 2 * label_half[0] &&
                              std::fabs(at[1] - other[1]) < 2 * label_half[1];
                   });
        };
        std::optional<std::array<double, 2>> best;
        for (const std::array<double, 2>& at : on_line) {
            if ((!best || at[1] > (*best)[1]) && has_room(at)) {
                best = at;
            }
        }
        return best;
    }

    [[nodiscard]] std::string bar(int height) const {
        std::string text;
        constexpr int steps = 2 * colours;
        for (int k = 0; k < steps; ++k) {
            const double part = (k + 0.5) / steps;
            text += fmt::format(
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", bar_left(),
                number(top_margin + height * (1 - (k + 1.0) / steps)), bar_width,
                number(height / double{steps} + 0.3), colour_of(low_ + part * (high_ - low_)));
        }
        const auto label = [&](double part, const std::string& words) {
            text += text_at(bar_left() + bar_width + 5, top_margin + height * (1 - part) + 4,
                            "start", smallest_text, words);
        };
        constexpr double apart = 0.06; // a label there would overlap that of an end
        for (const Scale::Tick& tick : scale().ticks()) {
            const auto part = tick.part.convert_to<double>();
            if ((part < 1 - apart || !over()) && (part > apart || !under())) {
                label(part, tick.label);
            }
        }
        if (over()) {
            label(1, "&gt; " + short_text(high_));
        }
        if (under()) {
            label(0, "&lt; " + short_text(low_));
        }
        return text + text_at(width_ + not_drawing - 4, top_margin + height + 27, "end", 12,
                              escape_html(field_.title));
    }
    /// Three digits, without an exponent where that is short.
    [[nodiscard]] static std::string short_text(double value) {
        const double unit = std::pow(10, std::floor(std::log10(std::fabs(value))) - 2);
        return fmt::format("{:g}", std::round(value / unit) * unit);
    }
    [[nodiscard]] int bar_left() const { return left_margin + width_ + 16; }
    [[nodiscard]] bool over() const {
        return std::ranges::any_of(field_.values,
                                   [&](double v) { return std::isfinite(v) && v > high_; });
    }
    [[nodiscard]] bool under() const {
        return std::ranges::any_of(field_.values,
                                   [&](double v) { return std::isfinite(v) && v < low_; });
    }

    const Plot& plot_;
    const PlaneField& field_;
    int width_; ///< of the drawing
    double low_ = HUGE_VAL;
    double high_ = -HUGE_VAL;
    double limit_ = 0; ///< the greatest size on the scale
    std::size_t greatest_ = 0;
};

} // namespace

Panel contours(const Plot& plot, int width) { return Field(plot, width).drawn(); }

} // namespace edgeproof::report::svg

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/figures/svg_parts.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::report::svg {
namespace {

constexpr int most_decades = 7; ///< more are labelled by every second, third, ... power

} // namespace

std::string text_at(double x, double y, std::string_view anchor, int size,
                    const std::string& escaped) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n",
                       number(x), number(y), anchor, size, escaped);
}

std::string number(double pixels) {
    return fmt::format("{:.1f}", std::fabs(pixels) < 0.05 ? 0.0 : pixels);
}

Scale::Scale(const Axis& axis, const std::vector<Real>& values, bool to_ticks)
    : logarithmic_(axis.logarithmic) {
    if (values.empty() && !axis.range) {
        throw Error("a figure without data has no range");
    }
    const auto [low, high] = axis.range ? *axis.range
                                        : std::pair(*std::ranges::min_element(values),
                                                    *std::ranges::max_element(values));
    low_ = on_scale(low);
    high_ = on_scale(high);
    if (!(low_ < high_)) {
        high_ = low_ + 1;
    }
    if (to_ticks && !axis.range) {
        const Real unit = logarithmic_ ? Real(1) : step(usual_ticks);
        low_ = floor(low_ / unit) * unit;
        high_ = ceil(high_ / unit) * unit;
    }
}

Real Scale::part(const Real& value) const {
    return Real((on_scale(value) - low_) / (high_ - low_));
}

Real Scale::on_scale(const Real& value) const { return logarithmic_ ? Real(log10(value)) : value; }

/// Returns 1, 2 or 5 times a power of ten.
Real Scale::step(int most) const {
    const Real raw = (high_ - low_) / most;
    const Real power = pow(Real(10), floor(log10(raw)));
    const Real lead = raw / power;
    return Real(power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10));
}

std::vector<Scale::Tick> Scale::ticks(int most) const {
    std::vector<Tick> all;
    if (logarithmic_) {
        const Real first = ceil(low_ - Real(1e-9));
        const Real last = floor(high_ + Real(1e-9));
        if (last - first < 1) { // fewer than two powers of ten
            for (Real k = floor(low_); k <= high_; k += 1) {
                for (const int digit : {1, 2, 5}) {
                    const Real value = digit * pow(Real(10), k);
                    if (const Real at = part(value); at > Real(-1e-9) && at < 1 + Real(1e-9)) {
                        all.push_back({at, value, fmt::format("{:g}", value.convert_to<double>())});
                    }
                }
            }
            return all;
        }
        const int every = static_cast<int>(last - first) / most_decades + 1;
        for (Real k = first; k <= last; k += every) {
            all.push_back({Real((k - low_) / (high_ - low_)), Real(pow(Real(10), k)),
                           fmt::format("10<tspan dy=\"-5\" font-size=\"10\">{}</tspan>",
                                       static_cast<int>(k))});
        }
        return all;
    }
    const Real unit = step(most);
    for (Real k = ceil(low_ / unit - Real(1e-9)); k * unit <= high_ + unit * Real(1e-9); k += 1) {
        const Real value = k == 0 ? Real(0) : Real(k * unit); // not -0
        all.push_back({part(value), value, fmt::format("{:g}", value.convert_to<double>())});
    }
    return all;
}

std::string axes(const Scale& x, const Scale& y, const Plot& plot, int width, int height,
                 bool downwards) {
    std::string grid;
    std::string labels;
    for (const Scale::Tick& tick : x.ticks()) {
        const double at = left_margin + tick.part.convert_to<double>() * width;
        grid += fmt::format("M{} {}v{}", number(at), top_margin, height);
        labels += text_at(at, top_margin + height + 17, "middle", 12, tick.label);
    }
    for (const Scale::Tick& tick : y.ticks()) {
        const double part = tick.part.convert_to<double>();
        const double at = top_margin + (downwards ? part : 1 - part) * height;
        grid += fmt::format("M{} {}h{}", left_margin, number(at), width);
        labels += text_at(left_margin - 7, at + 4, "end", 12, tick.label);
    }
    const double middle = top_margin + height / 2.0;
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#999999\" stroke-width=\"0.5\" "
                       "stroke-dasharray=\"2 3\"/>\n"
                       "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
                       "stroke=\"currentColor\"/>\n",
                       grid, left_margin, top_margin, width, height) +
           labels +
           text_at(left_margin + width / 2.0, top_margin + height + 38, "middle", 13,
                   escape_html(plot.x.label)) +
           fmt::format("<g transform=\"rotate(-90 16 {})\">{}</g>\n", number(middle),
                       text_at(16, middle, "middle", 13, escape_html(plot.y.label)));
}

} // namespace edgeproof::report::svg

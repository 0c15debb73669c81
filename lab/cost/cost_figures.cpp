// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace edgeproof::report {
namespace {

using Colour = Pen::Colour;
constexpr double microseconds = 1e6;

struct Line {
    std::string title;
    Pen pen;
    std::vector<std::pair<double, double>> points;
};

/// Returns the line with this title, which is added if there is none.
Line& line_named(std::vector<Line>& lines, const std::string& title, const Pen& pen) {
    const auto found = std::ranges::find(lines, title, &Line::title);
    return found != lines.end() ? *found : lines.emplace_back(Line{title, pen, {}});
}

/// A colour for each route.
Pen pen_of(const cost::CostCell& c) {
    static const std::map<std::string, std::pair<Colour, unsigned>> known{
        {"Barber-Mossakovskii", {Colour::blue, 4}},
        {"singular integral", {Colour::orange, 6}},
        {"enclosure", {Colour::black, 5}},
        {"rounded", {Colour::sky_blue, 12}},
    };
    const auto found = known.find(c.route);
    const auto [colour, point] =
        found == known.end() ? std::pair{Colour::yellow, 1U} : found->second;
    return {colour, 1, point, 2};
}

/// Makes one table for lines that share only the axes: each has its own column and its own rows.
Plot plot_of(std::string id, std::string title, std::string description, Axis x, Axis y,
             const std::vector<Line>& lines) {
    Plot plot;
    plot.id = std::move(id);
    plot.title = std::move(title);
    plot.description = std::move(description);
    plot.x = std::move(x);
    plot.y = std::move(y);
    plot.columns = {"x"};
    const PrecisionScope scope(20);
    for (const Line& line : lines) {
        std::string column = line.title;
        std::replace(column.begin(), column.end(), ',', ' ');
        plot.add_curve(column, line.title, line.pen);
        for (const auto& [x_value, y_value] : line.points) {
            plot.add_row(Real(x_value)).back() = Real(y_value);
        }
    }
    return plot;
}

/// The cells of a case: one line per route, one point per cell. A coordinate that is 0 is missing.
using Coordinate = std::function<double(const cost::CostCell&)>;
std::vector<Line> by_cell(const CostReport& report, const std::string& scene, const Coordinate& x,
                          const Coordinate& y) {
    std::vector<Line> lines;
    for (const cost::CostCell& c : report.cells) {
        const bool shown = c.scene == scene && c.failed() < c.points.size();
        if (shown && x(c) > 0 && y(c) > 0) {
            line_named(lines, c.route, pen_of(c)).points.emplace_back(x(c), y(c));
        }
    }
    return lines;
}

double digits_asked(const cost::CostCell& c) { return c.digits; }
double digits_right(const cost::CostCell& c) { return c.right().least; }
double time_taken(const cost::CostCell& c) { return c.seconds().median * microseconds; }
double evaluations(const cost::CostCell& c) {
    return c.evaluations().value_or(cost::Quartiles{}).median;
}

/// Adds the exponent of the growth with the digits to the titles.
void add_exponents(std::vector<Line>& lines) {
    for (Line& line : lines) {
        if (const auto fit = roots::power_law_fit(line.points); fit && fit->points > 2) {
            line.title += fmt::format(" ~ d^{:.2f}", fit->exponent);
        }
    }
}

/// The points of a case at one number of digits, against the distance from the critical place.
std::vector<Line> by_point(const CostReport& report, const cost::CostCase& which, unsigned digits,
                           const std::function<double(const cost::PointCost&)>& y) {
    std::vector<Line> lines;
    for (const cost::CostCell& c : report.cells) {
        if (c.scene != which.name || c.digits != digits) {
            continue;
        }
        Line line{c.route, pen_of(c), {}};
        for (const cost::PointCost& p : c.points) {
            if (p.failure.empty() && y(p) > 0) {
                line.points.emplace_back(which.distance(p.point), y(p));
            }
        }
        std::ranges::sort(line.points);
        if (!line.points.empty()) {
            lines.push_back(std::move(line));
        }
    }
    return lines;
}
double point_time(const cost::PointCost& p) { return p.seconds * microseconds; }
double point_evaluations(const cost::PointCost& p) {
    return static_cast<double>(p.evaluations.value_or(0));
}

const Axis digits_axis{"digits asked for", true};
const Axis right_axis{"digits right, worst point", true};
const Axis time_axis{"time a value, microseconds", true};
const Axis evaluations_axis{"evaluations of the integrand", true};

Figure work_precision(const CostReport& report, const std::string& scene) {
    return {
        "work-precision",
        "What digits cost: " + scene,
        "True digits (by an enclosure, at the worst of the points) against what they take. "
        "Further left and further up is better.",
        {plot_of("work-precision-evaluations", "digits against evaluations",
                 "For each route that has an integrand, the digits right at the worst point "
                 "against the median number of evaluations, both on logarithmic axes.",
                 evaluations_axis, right_axis, by_cell(report, scene, evaluations, digits_right)),
         plot_of("work-precision-time", "digits against time",
                 "For each route, the digits right at the worst point against the median time "
                 "of the processor a value, both on logarithmic axes.",
                 time_axis, right_axis, by_cell(report, scene, time_taken, digits_right))}};
}

Figure growth(const CostReport& report, const std::string& scene) {
    auto times = by_cell(report, scene, digits_asked, time_taken);
    auto counts = by_cell(report, scene, digits_asked, evaluations);
    add_exponents(times);
    add_exponents(counts);
    return {"growth",
            "Growth with the digits: " + scene,
            "The exponents are fitted over all digits shown; time grows by that of the "
            "evaluations and by that of one elementary function together.",
            {plot_of("growth-time", "time", "Median time a value against the digits asked for.",
                     digits_axis, time_axis, times),
             plot_of("growth-evaluations", "evaluations",
                     "Median number of evaluations against the digits asked for.", digits_axis,
                     evaluations_axis, counts)}};
}

Figure places(const CostReport& report, const cost::CostCase& which, const std::string& id,
              const std::string& title, const std::string& distance) {
    const unsigned digits = report.usual_digits();
    const Axis x{distance, true};
    const std::string at = " at " + std::to_string(digits) + " digits";
    return {
        id,
        title + at,
        "Every point of " + which.name + ", by the routes in MPFR and in balls.",
        {plot_of(id + "-time", "time" + at, "Time a value against the distance, point by point.", x,
                 time_axis, by_point(report, which, digits, point_time)),
         plot_of(id + "-evaluations", "evaluations" + at,
                 "Evaluations against the distance, point by point.", x, evaluations_axis,
                 by_point(report, which, digits, point_evaluations))}};
}

Figure proofs(const CostReport& report) {
    constexpr std::array colours{Colour::black,  Colour::orange, Colour::sky_blue,
                                 Colour::green,  Colour::blue,   Colour::vermilion,
                                 Colour::purple, Colour::yellow};
    std::vector<Line> lines;
    for (const cost::BoundCost& b : bound_costs(report.cells)) {
        const std::size_t k = lines.size();
        const Pen pen{colours.at(k % colours.size()), k < colours.size() ? 1U : 4U,
                      static_cast<unsigned>(4 + k)};
        line_named(lines, b.scene, pen)
            .points.emplace_back(b.digits, b.enclosure_seconds / b.bare_seconds);
    }
    return {"proofs",
            "What a proof costs",
            "Time of an enclosure over that of a bare value by the fastest route in MPFR that has "
            "all its digits. Below 1 the proved value is the cheaper one.",
            {plot_of("proofs-ratio", "enclosure over bare value",
                     "The ratio of times against the digits, a line a contact.", digits_axis,
                     {"time of the enclosure / bare time", true}, lines)}};
}

} // namespace

std::vector<Figure> cost_figures(const CostReport& report) {
    std::vector<Figure> figures;
    const cost::CostCase& first = report.cases.front();
    figures.push_back(work_precision(report, first.name));
    figures.push_back(growth(report, first.name));
    figures.push_back(places(report, first, "by-u", "Cost against the distance from the edge",
                             "u, distance from the edge"));
    for (const cost::CostCase& c : report.cases) {
        if (c.near.sign() != 0) {
            figures.push_back(places(report, c, "by-knot", "Cost against the distance from a knot",
                                     "distance from the knot"));
            break;
        }
    }
    figures.push_back(proofs(report));
    for (Figure& figure : figures) {
        std::erase_if(figure.plots, [](const Plot& plot) { return plot.rows.empty(); });
    }
    std::erase_if(figures, [](const Figure& figure) { return figure.plots.empty(); });
    return figures;
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/design_figure.hpp"

#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"

#include <algorithm>
#include <cmath>

namespace edgeproof::report {
namespace {

/// A step between neighbours of more than this share of the highest reach is drawn as a gap in the
/// line (run_design.cpp adds points where the curve is only steep).
constexpr double share_of_a_jump = 0.02;
constexpr unsigned digits_of_a_mark = 6;

} // namespace

Plot design_plot(const scene::DesignScene& design, const scene::DesignResult& result) {
    const std::string& name = design.parameters.front().name;
    const bool measure = design.objective == scene::DesignObjective::measure;
    const std::string reach = measure ? "measure" : "reach";
    Plot plot;
    plot.id = "design";
    const bool slip = design.objective == scene::DesignObjective::slip_load;
    plot.title = design.title.empty() ? "Reach of the approximation" : design.title;
    plot.description = "The " + reach + " of " + std::to_string(design.terms) +
                       " term(s) against " + name + ", its best value marked";
    plot.x = {name, false, {}};
    plot.y = {slip ? "slip load, Q/(f P)"
                   : reach + (design.unit == contact::ReachUnit::fraction ? ", fraction of a + b"
                                                                          : ", distance from the "
                                                                            "edge"),
              false,
              {}};
    plot.columns = {name, "reach", "best", "printed"};
    plot.key_below = true;
    plot.curves.push_back({"reach", "within " + design.tolerance.text(), {Pen::Colour::blue, 1}});
    const auto mark = [](const Ball& x) { return to_decimal(x.midpoint(), digits_of_a_mark); };
    plot.curves.push_back({"best",
                           "best: " + name + " = " + mark(result.best.value[0]),
                           {Pen::Colour::vermilion, 0, 7, 1}});
    double highest = 0;
    for (const auto& [x, y] : result.curve) {
        highest = std::isnan(y) ? highest : std::max(highest, y);
    }
    std::optional<double> before;
    for (const auto& [x, y] : result.curve) {
        if (before && (std::isnan(y) || std::fabs(y - *before) > share_of_a_jump * highest)) {
            plot.rows.push_back({Real(x), {}, {}, {}});
        }
        before = std::isnan(y) ? std::nullopt : std::optional(y);
        plot.rows.push_back({Real(x), before ? std::optional(Real(y)) : std::nullopt, {}, {}});
    }
    plot.rows.push_back({result.best.value[0].midpoint(), {}, result.best.reach.midpoint(), {}});
    if (result.printed_reach) {
        const Rational& printed = *design.parameters.front().printed;
        plot.rows.push_back(
            {from_rational<Real>(printed), {}, {}, result.printed_reach->midpoint()});
        plot.curves.push_back({"printed",
                               "printed: " + name + " = " + exact_text(printed),
                               {Pen::Colour::black, 0, 9, 1}});
    }
    return plot;
}

void write_design_figure(const scene::DesignScene& design, const scene::DesignResult& result,
                         const std::filesystem::path& file) {
    const PrecisionScope scope(figure_digits + 10);
    write_figure(design_plot(design, result), file);
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/comparison_figures.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/figures_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string_view>
#include <utility>

namespace edgeproof::report {
namespace {

using comparison::FileComparison;
using comparison::Node;

std::optional<Real> point(double x) {
    return std::isfinite(x) ? std::optional(Real(x)) : std::nullopt;
}

/// The places of the exact curve: dense at the edges.
std::vector<double> curve_places(const comparison::ExactContact& exact) {
    std::vector<double> places;
    constexpr int count = 240;
    const double middle = 0.5 * (exact.a().value - exact.b().value);
    for (int i = 0; i <= count; ++i) {
        const double angle = 3.14159265358979 * i / count;
        places.push_back(middle - 0.5 * exact.length() * std::cos(angle));
    }
    for (const comparison::ContactKnot& knot : exact.knots()) {
        for (const double side : {-1e-6, -1e-4, -1e-3, 1e-3, 1e-4, 1e-6}) {
            places.push_back(knot.x + side * exact.length());
        }
    }
    std::ranges::sort(places);
    return places;
}

/// Returns a unique name for the figures of a file.
std::string file_id(const std::filesystem::path& file, std::set<std::string>& taken) {
    static constexpr std::array<std::string_view, 5> endings{"", "-pressure", "-error", "-shear",
                                                             "-shear-error"};
    const std::string stem = io::FileStem(file.stem().string()).text();
    std::string id = stem;
    const auto is_taken = [&](std::string_view ending) {
        return taken.contains(id + std::string(ending));
    };
    for (int i = 2; std::ranges::any_of(endings, is_taken); ++i) {
        id = stem + "-" + std::to_string(i);
    }
    for (const std::string_view ending : endings) {
        taken.insert(id + std::string(ending));
    }
    return id;
}

std::string shown_name(const FileComparison& file) {
    return std::filesystem::path(file.table.file).filename().string();
}

/// The plotted properties of the pressure, or of the shear traction.
struct Traction {
    std::string symbol;
    std::string id;
    std::string title;
    std::optional<double> limit; ///< for the exact curve, if that is infinite somewhere
    std::function<std::optional<double>(double)> exact;
    std::function<std::optional<double>(const Node&)> data;
    std::string error_label;
    std::string error_what;
    /// The error of a node inside; nothing if there is none.
    std::function<std::optional<double>(const Node&)> error;
    std::optional<double> tolerance; ///< for that error
};

Traction pressure_of(const ComparisonReport& report) {
    const comparison::ExactContact& exact = *report.exact;
    const comparison::Tolerances& t = report.comparison.tolerances;
    return {"p",
            "pressure",
            "Pressure",
            exact.scale().mean ? std::optional(3 * exact.scale().value) : std::nullopt,
            [&exact](double x) { return exact.at(Real(x)).p; },
            [](const Node& node) { return std::optional(node.p); },
            "|error of p|/p",
            "relative error of the data's pressures",
            [](const Node& node) {
                const bool comparable = node.exact.p && *node.exact.p > 0;
                return comparable ? std::optional(std::abs(node.error / *node.exact.p))
                                  : std::nullopt;
            },
            t.of == comparison::Norm::local ? std::optional(t.pressure) : std::nullopt};
}

Traction shear_of(const ComparisonReport& report) {
    const comparison::ExactContact& exact = *report.exact;
    const comparison::Tolerances& t = report.comparison.tolerances;
    const double scale = exact.shear()->scale();
    const bool infinite = exact.shear()->singular() || exact.scale().mean;
    return {
        "q",
        "shear",
        "Shear traction",
        infinite ? std::optional(3 * scale) : std::nullopt,
        [&exact](double x) { return exact.traction(exact.at(Real(x))); },
        [](const Node& node) { return node.shear ? std::optional(node.shear->q) : std::nullopt; },
        "|error of q|/(" + exact.shear()->scale_text() + ")",
        "error of the data's shear traction, relative to " + exact.shear()->scale_text() + ",",
        [scale](const Node& node) {
            const bool comparable = node.shear && node.shear->exact;
            return comparable ? std::optional(std::abs(node.shear->error) / scale) : std::nullopt;
        },
        t.of == comparison::Norm::peak ? std::optional(t.q.value_or(t.pressure)) : std::nullopt};
}

/// Plots the data of a file and the exact curve. `id` names its files.
Plot traction_plot(const ComparisonReport& report, const FileComparison& file,
                   const std::string& id, const Traction& traction) {
    const comparison::ExactContact& exact = *report.exact;
    Plot plot;
    plot.id = id + "-" + traction.id;
    plot.title = traction.title + ": " + shown_name(file);
    plot.description = "The " + traction.id + " of the data as points, and the exact one as a " +
                       "line, along the contact";
    const scene::Units units = report.units.value_or(scene::Units{});
    plot.x = {"x" + unit_label(units.length)};
    plot.y = {traction.symbol + unit_label(units.pressure)};
    plot.columns = {"x", "exact", "data"};
    plot.curves = {{"exact", "exact", {Pen::Colour::blue, 1, {}, 2}},
                   {"data", "data", {Pen::Colour::black, 0, 6, 1.5}}};
    double least = 0;
    double most = 0;
    const auto reach = [&](double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    };
    for (const double x : curve_places(exact)) {
        const auto value = traction.exact(x);
        if (value && traction.limit) {
            reach(std::clamp(*value, -*traction.limit, *traction.limit));
        }
        plot.add_row(Real(x))[1] = value ? point(*value) : std::nullopt;
    }
    for (const Node& node : file.data.nodes) {
        const auto value = traction.data(node);
        // Nodes far outside are not shown.
        if (value && node.exact.u() > -0.15 * exact.length()) {
            reach(*value);
            plot.add_row(Real(node.x))[2] = point(*value);
        }
    }
    if (traction.limit) {
        plot.y.range = {fmt::format("{:.6g}", 1.1 * least), fmt::format("{:.6g}", 1.1 * most)};
    }
    return plot;
}

/// Plots the errors of the nodes inside against u/(a + b). The elements at the edge and, for the
/// pressure, the window of the fit of c_0 are shaded.
Plot error_plot(const ComparisonReport& report, const FileComparison& file, const std::string& id,
                const Traction& traction) {
    const comparison::ExactContact& exact = *report.exact;
    const bool fitted = traction.symbol == "p";
    Plot plot;
    plot.id = id + (fitted ? "-error" : "-" + traction.id + "-error");
    plot.title = "Error of " + traction.symbol + ": " + shown_name(file);
    plot.description =
        "The " + traction.error_what +
        " against the distance from the edge, on logarithmic axes; the two "
        "elements at the edge " +
        (fitted ? "and the window that c_0 is fitted over are shaded" : "are shaded");
    plot.x = {"distance from the edge, u/(a + b)", true};
    plot.y = {.label = traction.error_label + " [%]", .logarithmic = true, .percent = true};
    plot.columns = {"u", "right", "left"};
    double least_u = 0.5;
    double least = 1;
    double most = 1e-16;
    for (const Node& node : file.data.nodes) {
        const auto found = node.exact.inside() ? traction.error(node) : std::nullopt;
        if (!found || *found == 0) {
            continue;
        }
        const double u = node.exact.u() / exact.length();
        const double error = *found;
        const bool right = node.exact.nearer() == contact::Edge::right;
        plot.add_row(Real(u))[right ? 1 : 2] = point(error);
        least_u = std::min(least_u, u);
        least = std::min(least, error);
        most = std::max(most, error);
    }
    plot.sort_rows();
    plot.curves = {{"right", "right edge", {Pen::Colour::vermilion, 0, 7, 1}},
                   {"left", "left edge", {Pen::Colour::blue, 0, 4, 1}}};
    const double from = least_u / 2;
    const auto number = [](double x) { return fmt::format("{:.6g}", x); };
    plot.x.range = {number(from), "0.6"};
    plot.y.range = {fmt::format("1e{:d}", static_cast<int>(std::floor(std::log10(least))) + 1),
                    fmt::format("1e{:d}", static_cast<int>(std::ceil(std::log10(most))) + 3)};
    const contact::Edge edge = file.data.half.value_or(contact::Edge::right);
    const double element = file.contact.element[index_of(edge)] / exact.length();
    if (2 * element > from && 2 * element < 0.6) {
        plot.bands.push_back({number(from), number(2 * element), "two elements", 0.3});
    }
    if (const auto& fit = file.fits[index_of(edge)]; fit && fitted) {
        plot.bands.push_back({number(fit->from / exact.length()), number(fit->to / exact.length()),
                              "c_0 fitted here", 0.12});
    }
    if (traction.tolerance) {
        plot.level = {number(100 * *traction.tolerance),
                      fmt::format("tolerance {:g} %", 100 * *traction.tolerance)};
    }
    return plot;
}

Plot convergence_plot(const ComparisonReport& report) {
    const comparison::ExactContact& exact = *report.exact;
    Plot plot;
    plot.id = "convergence";
    plot.title = "Errors of several meshes";
    plot.description = "Errors relative to the exact values against the mean width of an element, "
                       "on logarithmic axes";
    plot.x = {"width of an element/(a + b)", true};
    plot.y = {.label = "relative error [%]", .logarithmic = true, .percent = true};
    plot.columns = {"h"};
    plot.add_curve("peak", "p, of the peak", {Pen::Colour::vermilion, 1, 7, 1});
    plot.add_curve("L2", "p, L2", {Pen::Colour::blue, 2, 4, 1});
    plot.add_curve("a", "a", {Pen::Colour::green, 3, 8, 1});
    plot.add_curve("P", "P", {Pen::Colour::purple, 4, 10, 1});
    plot.add_curve("c_0", "c_0", {Pen::Colour::black, 5, 12, 1});
    for (const FileComparison& file : report.comparison.files) {
        const auto relative = [](const std::optional<double>& data,
                                 double value) -> std::optional<Real> {
            const double error = data ? std::abs(*data / value - 1) : 0;
            constexpr double roundoff = 1e-8; // a load that was prescribed
            return error > roundoff ? point(error) : std::nullopt;
        };
        const auto& fit = file.fits[0];
        plot.rows.push_back({point(file.contact.mean_element / exact.length()),
                             file.errors.peak > 0 ? point(file.errors.peak) : std::nullopt,
                             file.errors.l2 > 0 ? point(file.errors.l2) : std::nullopt,
                             relative(file.contact.a, exact.a().value),
                             relative(file.contact.force, exact.force().value),
                             relative(fit ? std::optional(fit->c0.value) : std::nullopt,
                                      exact.c(contact::Edge::right, 0).value)});
    }
    plot.sort_rows();
    return plot;
}

} // namespace

std::vector<DrawnPlot> draw_comparison(const ComparisonReport& report) {
    const PrecisionScope scope(comparison::ExactContact::place_digits);
    std::vector<DrawnPlot> drawn;
    const auto draw = [&](Plot plot) {
        std::string svg = draw_svg({plot});
        drawn.push_back({std::move(plot), std::move(svg)});
    };
    std::set<std::string> taken{"convergence"};
    for (const FileComparison& file : report.comparison.files) {
        const std::string id = file_id(file.table.file, taken);
        std::vector<Traction> tractions{pressure_of(report)};
        if (report.exact->shear() != nullptr && file.shear) {
            tractions.push_back(shear_of(report));
        }
        for (const Traction& traction : tractions) {
            draw(traction_plot(report, file, id, traction));
            if (Plot errors = error_plot(report, file, id, traction); !errors.rows.empty()) {
                draw(std::move(errors));
            }
        }
    }
    if (report.comparison.files.size() > 1) {
        draw(convergence_plot(report));
    }
    return drawn;
}

void write_figures(const std::vector<DrawnPlot>& drawn, const std::filesystem::path& folder) {
    const PrecisionScope scope(figure_digits + 10);
    for (const auto& [plot, svg] : drawn) {
        write_plot_files(plot, svg, folder);
    }
}

} // namespace edgeproof::report

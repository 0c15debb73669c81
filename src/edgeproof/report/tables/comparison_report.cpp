// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/tables/comparison_report.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgeproof::report {
namespace {

constexpr std::size_t margin_of_tables = 2;

using comparison::Convergence;
using comparison::Errors;
using comparison::FileComparison;

/// A table without rows: a column of text, then numbers.
Table table_of(std::initializer_list<const char*> names) {
    Table table;
    for (const char* name : names) {
        table.columns.push_back(
            {name, table.columns.empty() ? Column::Kind::text : Column::Kind::number});
    }
    return table;
}

std::string number_text(const std::optional<double>& x, int digits) {
    return x ? fmt::format("{:.{}g}", *x, digits) : "-";
}

std::string percent_text(double x) { return fmt::format("{:.3g} %", 100 * x); }

std::vector<std::string> lines_of(const std::optional<comparison::Diagnosis>& diagnosis,
                                  const char* symbol) {
    std::vector<std::string> lines;
    if (!diagnosis) {
        return lines;
    }
    const comparison::Diagnosis& d = *diagnosis;
    if (!d.causes.empty()) {
        // the causes are sufficient
    } else if (d.at_edges_only) {
        const bool outside = d.worst == comparison::Worst::outside;
        const std::string where =
            outside ? fmt::format(": the largest error of {0} is outside the exact contact, where "
                                  "{0} is 0",
                                  symbol)
            : d.worst == comparison::Worst::inside
                ? fmt::format(", and scatters by {} from node to node: no known mistake can be "
                              "distinguished from that scatter",
                              percent_text(d.noise))
                : ": the errors are at the edges, as those of a mesh usually are";
        lines.push_back(fmt::format("away from the edges {} is right to {}{}", symbol,
                                    percent_text(outside ? d.inside : d.unexplained), where));
    } else if (d.too_few) {
        lines.push_back(fmt::format("fewer than eight nodes lie in the exact contact, away from "
                                    "its edges: too few to find the cause of an error of {}",
                                    symbol));
    } else if (d.factor) {
        lines.push_back(
            fmt::format("away from the edges {0} is {1:.6g} +- {2:.2g} times the exact {0}, "
                        "by a fit: no known cause explains that",
                        d.factor->of_x ? "x" : symbol, d.factor->value, d.factor->error));
    } else {
        lines.push_back(fmt::format(
            "no known cause explains {}: errors of {} remain, and the nodes scatter by {}", symbol,
            percent_text(d.unexplained), percent_text(d.noise)));
    }
    for (std::size_t i = 0; i < d.causes.size(); ++i) {
        const comparison::Cause& cause = d.causes[i];
        lines.push_back(fmt::format("{}: {} ({}); it leaves {} of {}",
                                    d.causes.size() == 1 ? "likely cause"
                                    : i == 0 ? "likely causes, which the data do not distinguish"
                                             : "or",
                                    cause.name, cause.what, percent_text(cause.scatter),
                                    percent_text(d.unexplained)));
    }
    return lines;
}

std::vector<std::string> diagnosis_lines(const FileComparison& file) {
    std::vector<std::string> lines = lines_of(file.diagnosis, "p");
    const std::vector<std::string> more = lines_of(file.shear_diagnosis, "q");
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
}

/// In brackets; empty if the scene has no units.
std::string unit_of(const comparison::ComparedQuantity& q, const ComparisonReport& report) {
    const scene::Units units = report.units.value_or(scene::Units{});
    const std::string length = units.length ? units.length->name : "";
    const std::string pressure = units.pressure ? units.pressure->name : "";
    std::string unit = q.name == "a" || q.name == "b" ? length : pressure;
    if (q.name == "P" || q.name == "Q") {
        const bool whole = report.exact->axisymmetric();
        unit = units.force && (whole || units.length)
                   ? units.force->name + (whole ? "" : "/" + length)
                   : "";
    } else if (q.name.starts_with("c_")) {
        unit = units.length && units.pressure
                   ? pressure + "/" + length + (q.name[2] == '0' ? "^(1/2)" : "^(3/2)")
                   : "";
    }
    return unit.empty() ? "" : " [" + unit + "]";
}

Table quantities_table(const ComparisonReport& report, const FileComparison& file) {
    Table table = table_of({"", "data", "+-", "exact p", "exact", "off by", ""});
    for (const auto& q : compared_quantities(file, *report.exact)) {
        table.rows.push_back(
            {q.name + unit_of(q, report), number_text(q.data, 7),
             q.spread > 0 ? fmt::format("{:.2g}", q.spread) : "",
             q.of_exact ? number_text(q.of_exact, 7) : "", number_text(q.exact, 10),
             q.data && q.exact != 0 ? fmt::format("{:+.3g} %", 100 * (*q.data / q.exact - 1)) : "",
             q.note});
    }
    return table;
}

Table errors_table(const ComparisonReport& report, const FileComparison& file) {
    const bool mean = report.exact->scale().mean;
    Table table =
        table_of({"nodes by distance from an edge", "nodes", mean ? "of the mean" : "of the peak",
                  "of p itself", "median", "digits right"});
    const auto add = [&](const std::string& name, const Errors& e) {
        table.rows.push_back({name, std::to_string(e.nodes), percent_text(e.peak),
                              percent_text(e.local), percent_text(e.median_local),
                              fmt::format("{:.1f}", e.digits())});
    };
    for (const comparison::DistanceErrors& d : file.distances) {
        add(fmt::format("{}: {:g} to {:g} of a + b", scene::edge_name(d.edge), d.from, d.to),
            d.errors);
    }
    for (const comparison::KnotErrors& k : file.knots) {
        add(fmt::format("near the {} at x = {:.6g}", k.knot.corner ? "corner" : "knot", k.knot.x),
            k.errors);
    }
    return table;
}

Table orders_table(const ComparisonReport& report) {
    Table table = table_of({"of several meshes", "order"});
    for (const Convergence& c : report.comparison.convergence) {
        table.rows.push_back({c.quantity, number_text(c.order, 3)});
    }
    return table;
}

std::string file_text(const ComparisonReport& report, const FileComparison& file) {
    std::string out = printable(file.table.file) + "\n";
    for (const std::string& finding : file.findings()) {
        out += "  " + printable(finding) + "\n";
    }
    out += "\n" + aligned_lines(quantities_table(report, file), margin_of_tables, false) + "\n" +
           aligned_lines(errors_table(report, file), margin_of_tables, false) + "\n";
    const Errors& all = file.errors;
    out +=
        fmt::format("  error of p{}: {} of the {}, {} of p itself, {} in the L2 norm\n",
                    file.all.nodes == all.nodes
                        ? std::string()
                        : fmt::format(", {} of {} nodes (the others lie in the edge zones)",
                                      all.nodes, file.all.nodes),
                    percent_text(all.peak), report.exact->scale().mean ? "mean pressure" : "peak",
                    percent_text(all.local), percent_text(all.l2));
    if (file.shear) {
        out += fmt::format("  error of q, {} nodes: {} of {}, {} of q itself, {} in the L2 norm\n",
                           file.shear->nodes, percent_text(file.shear->peak),
                           report.exact->shear()->scale_text, percent_text(file.shear->local),
                           percent_text(file.shear->l2));
    }
    for (const comparison::SurfaceErrors& e : file.surface) {
        out += fmt::format(
            "  error of {}, {} nodes: {} {}, at x = {:.6g} ({:.6g}, exact {:.6g}, {})\n", e.name,
            e.nodes, percent_text(e.peak), e.reference, file.data.nodes[e.worst].x, e.data, e.exact,
            e.route);
    }
    const double element = file.contact.element[0];
    out += fmt::format("  an element at the right edge is {:.4g} wide, {:.3g} of a + b; at the "
                       "left {:.4g}\n",
                       element, element / report.exact->length(), file.contact.element[1]);
    for (const std::string& failure : file.failures) {
        out += "  FAIL: " + printable(failure) + "\n";
    }
    for (const std::string& line : diagnosis_lines(file)) {
        out += "  " + printable(line) + "\n";
    }
    return out + "\n";
}

} // namespace

std::string tolerance_text(const comparison::Tolerances& t) {
    std::string out = fmt::format("p within {} {}", percent_text(t.pressure),
                                  t.of == comparison::Norm::peak    ? "of the peak"
                                  : t.of == comparison::Norm::local ? "of p itself"
                                                                    : "in the L2 norm");
    if (t.zone.length) {
        out += fmt::format(", {:g} at each edge left out", *t.zone.length);
    } else if (t.zone.elements > 0) {
        out += fmt::format(", {:g} elements at each edge left out", t.zone.elements);
    }
    const auto add = [&out](const char* name, const std::optional<double>& tolerance) {
        out += tolerance ? fmt::format(", {} within {}", name, percent_text(*tolerance)) : "";
    };
    add("a and b", t.edges);
    add("P", t.force);
    add("c_0", t.c0);
    add("q", t.q);
    add("gap, slip and sxx", t.surface);
    out += t.partial ? ", a part of the contact" : "";
    return out + (t.stated ? "" : " (none is stated: --tolerance)");
}

std::string comparison_text(const ComparisonReport& report) {
    std::string out = "scene: " + printable(report.scene) +
                      (report.title.empty() ? "" : " (" + printable(report.title) + ")") + "\n";
    if (report.units) {
        out += "units: " + report.units->text() + "\n";
    }
    out += fmt::format("exact: a and b {}, P {}, c_0 {}; pressures {}\n", report.exact->a().route,
                       report.exact->force().route, report.exact->c(contact::Edge::right, 0).route,
                       report.exact->pressure_route());
    out += "edges, fits and orders of the data are estimates; exact p: the result of the same rule "
           "for the exact pressure at these nodes\n\n";
    for (const FileComparison& file : report.comparison.files) {
        out += file_text(report, file);
    }
    if (!report.comparison.convergence.empty()) {
        out += aligned_lines(orders_table(report), margin_of_tables, false) + "\n";
    }
    out += "tolerance: " + tolerance_text(report.comparison.tolerances) + "\n";
    const auto failing = std::ranges::count_if(
        report.comparison.files, [](const FileComparison& file) { return !file.passes(); });
    const std::size_t files = report.comparison.files.size();
    return out + (failing == 0 ? fmt::format("pass: {} file{}\n", files, files == 1 ? "" : "s")
                               : fmt::format("FAIL: {} of {} file{}\n", failing, files,
                                             files == 1 ? "" : "s"));
}

ComparedResults compare_results(const std::function<void(std::size_t, std::size_t)>& progress,
                                const scene::Scene& scene, const std::string& name,
                                const std::vector<std::pair<std::string, std::string>>& results,
                                const std::map<std::string, std::string, std::less<>>& options) {
    const auto option = [&](std::string_view key, const char* otherwise = "") {
        const auto found = options.find(key);
        return found == options.end() ? otherwise : found->second;
    };
    const auto tolerance = [&](std::string_view key) {
        const std::string text = option(key);
        return text.empty() ? std::nullopt
                            : std::optional(scene::parse_tolerance(text).to<double>());
    };
    comparison::Tolerances t;
    t.partial = !option("partial").empty();
    t.stated = !option("tolerance").empty();
    t.pressure = tolerance("tolerance").value_or(t.pressure);
    t.of = comparison::norm_named(option("of", "peak"));
    t.zone = comparison::parse_edge_zone(option("edge_zone", "0"));
    t.edges = tolerance("tolerance_a");
    t.force = tolerance("tolerance_P");
    t.c0 = tolerance("tolerance_c0");
    t.q = tolerance("tolerance_q");
    t.surface = tolerance("tolerance_surface");
    std::optional<Rational> origin; // none: fitted to the data
    if (const std::string text = option("origin", "0"); text != "auto") {
        origin = io::read_number(text);
        require(origin.has_value(), "--origin " + text + " is no place",
                "give the x of the data at which the scene has its origin, or auto");
    }
    const comparison::ResultReading reading =
        comparison::reading_of(scene.units, option("columns"), option("scale"));
    std::vector<comparison::ResultTable> tables; // all are read before any work
    for (const auto& [text, file] : results) {
        tables.push_back(comparison::parse_result(text, file, reading));
    }
    const comparison::ExactContact exact(scene);
    const ComparisonReport report{
        name, scene.title, scene.units, &exact,
        compare_tables(std::move(tables), scene, exact, t, origin, progress)};
    return {report.comparison.passes(), comparison_text(report), comparison_json(report)};
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/comparison_page.hpp"

#include "edgeproof/report/figures/figures_gnuplot.hpp"
#include "edgeproof/report/text/html_markup.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

namespace edgeproof::report {
namespace {

using comparison::FileComparison;

std::string html_rows(const std::vector<std::string>& head,
                      const std::vector<std::vector<std::string>>& rows) {
    std::string out = "<div class=\"scroll\" tabindex=\"0\"><table class=\"cost\"><thead><tr>";
    const auto cells = [&out](const std::vector<std::string>& row, const char* tag,
                              const char* scope) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += fmt::format("<{0}{1}{2}>{3}</{0}>", tag, scope,
                               i == 0 ? "" : " class=\"number\"", escape_html(row[i]));
        }
    };
    cells(head, "th", " scope=\"col\"");
    out += "</tr></thead><tbody>\n";
    for (const auto& row : rows) {
        out += "<tr>";
        cells(row, "td", "");
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string share(double x) { return fmt::format("{:.3g} %", 100 * x); }

std::string file_html(const ComparisonReport& report, const FileComparison& file) {
    std::string out = "<ul>\n";
    for (const std::string& failure : file.failures) {
        out += "<li><strong>Fails:</strong> " + escape_html(failure) + "</li>\n";
    }
    for (const std::string& line : diagnosis_lines(file)) {
        out += "<li><strong>" + escape_html(line) + "</strong></li>\n";
    }
    for (const std::string& finding : file.findings()) {
        out += "<li>" + escape_html(finding) + "</li>\n";
    }
    out += "</ul>\n";
    std::vector<std::vector<std::string>> rows;
    for (const HeldQuantity& q : held_quantities(report, file)) {
        rows.push_back(
            {q.name + (q.unit.empty() ? "" : " [" + q.unit + "]"),
             q.data ? fmt::format("{:.7g}", *q.data) : "-",
             q.spread > 0 ? fmt::format("{:.2g}", q.spread) : "",
             q.of_exact ? fmt::format("{:.7g}", *q.of_exact) : "", fmt::format("{:.10g}", q.exact),
             q.data ? fmt::format("{:+.3g} %", 100 * (*q.data / q.exact - 1)) : "", q.route});
    }
    out += html_rows({"Quantity", "By the data", "+-", "Same rule on exact p", "Exact", "Off by",
                      "Route of the exact value"},
                     rows);
    rows.clear();
    const auto add = [&rows](const std::string& name, const comparison::Errors& e) {
        rows.push_back({name, std::to_string(e.nodes), share(e.peak), share(e.local),
                        share(e.median_local), fmt::format("{:.1f}", e.digits())});
    };
    for (const comparison::DistanceErrors& d : file.distances) {
        add(distance_text(d), d.errors);
    }
    for (const comparison::KnotErrors& k : file.knots) {
        add(fmt::format("near the {} at x = {:.6g}", k.knot.corner ? "corner" : "knot", k.knot.x),
            k.errors);
    }
    const char* const scale = report.exact->scale().mean ? "Of the mean pressure" : "Of the peak";
    return out + html_rows({"Distance from an edge", "Nodes", scale, "Of p itself", "Median",
                            "Digits right"},
                           rows);
}

std::string figure_html(const DrawnComparison& drawn, const Figure& figure) {
    if (!drawn.with_gnuplot) {
        return "<p class=\"missing\">There is no gnuplot: no figures.</p>\n";
    }
    std::string out =
        "<figure id=\"figure-" + escape_html(figure.id) + "\">\n<div class=\"panels\">\n";
    for (const Plot& plot : figure.plots) {
        out +=
            "<div class=\"panel\">" + inline_svg(drawn.svg.at(plot.id.text()), plot) + "</div>\n";
    }
    return out + "</div>\n<figcaption>" + escape_html(figure.caption) +
           "</figcaption>\n</figure>\n";
}

std::string limits_html(const ComparisonReport& report) {
    std::vector<std::vector<std::string>> rows;
    const auto number = [](const std::optional<double>& x) {
        return x ? fmt::format("{:.7g}", *x) : std::string("-");
    };
    for (const comparison::Convergence& c : report.comparison.convergence) {
        rows.push_back({c.quantity, c.order ? fmt::format("{:.3g}", *c.order) : "-",
                        c.own_order ? fmt::format("{:.3g}", *c.own_order) : "-",
                        number(c.extrapolated),
                        c.extrapolated ? fmt::format("{:.2g}", c.extrapolation_error) : "",
                        c.exact != 0 ? fmt::format("{:.8g}", c.exact) : "",
                        !c.agrees   ? c.why_not
                        : *c.agrees ? "agrees"
                                    : "differs"});
    }
    return html_rows(
        {"Quantity", "Order", "Order without the exact value", "Limit", "+-", "Exact", ""}, rows);
}

} // namespace

std::string comparison_page(const ComparisonReport& report, const DrawnComparison& drawn) {
    const auto& files = report.comparison.files;
    const std::vector<Figure>& figures = drawn.figures;
    std::string contents;
    std::string parts;
    const auto part = [&](const std::string& id, const std::string& title,
                          const std::string& body) {
        contents +=
            "<li><a href=\"#" + escape_html(id) + "\">" + escape_html(title) + "</a></li>\n";
        parts += "<section id=\"" + escape_html(id) + "\">\n<h2>" + escape_html(title) + "</h2>\n" +
                 body + "</section>\n";
    };
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < files.size(); ++i) {
        rows.push_back({figures[i].title, files[i].passes() ? "pass" : "FAIL",
                        std::to_string(files[i].inside), share(files[i].errors.peak),
                        share(files[i].errors.local), share(files[i].errors.l2)});
    }
    part("figures", "Outcome",
         "<p>Tolerances: " + escape_html(tolerance_text(report.comparison.tolerances)) + "</p>\n" +
             html_rows({"File", "Outcome", "Nodes inside", "Of the peak", "Of p itself", "L2"},
                       rows));
    for (std::size_t i = 0; i < files.size(); ++i) {
        part(figures[i].id, figures[i].title,
             figure_html(drawn, figures[i]) + file_html(report, files[i]));
    }
    if (files.size() > 1) {
        part("convergence", "Several meshes",
             figure_html(drawn, figures.back()) + limits_html(report));
    }
    return fill_template(
        cost_template::cost_html,
        {{"title",
          "Edgeproof compare: " + escape_html(report.title.empty() ? report.scene : report.title)},
         {"css", std::string(report_template::page_css)},
         {"machine", escape_html(report.scene + (report.units ? ": " + report.units->text() : ""))},
         {"contents", contents},
         {"parts", parts},
         {"footer",
          "Made by edgeproof compare. Exact values have the routes that are named; edges, "
          "fits and limits of data are estimates."}});
}

} // namespace edgeproof::report

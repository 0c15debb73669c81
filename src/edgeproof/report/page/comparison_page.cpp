// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/comparison_page.hpp"

#include "edgeproof/report/figures/figures_svg.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <vector>

namespace edgeproof::report {
namespace {

using comparison::FileComparison;

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
    return out + html_table(quantities_table(report, file, true)) +
           html_table(errors_table(report, file, true));
}

std::string figure_html(const DrawnComparison& drawn, const Figure& figure) {
    std::string out =
        "<figure id=\"figure-" + escape_html(figure.id) + "\">\n<div class=\"panels\">\n";
    for (const Plot& plot : figure.plots) {
        out +=
            "<div class=\"panel\">" + inline_svg(drawn.svg.at(plot.id.text()), plot) + "</div>\n";
    }
    return out + "</div>\n<figcaption>" + escape_html(figure.caption) +
           "</figcaption>\n</figure>\n";
}

} // namespace

std::string parts_page(const std::string& title, const std::string& about,
                       const std::vector<PagePart>& parts, bool labelled,
                       const std::string& footer) {
    std::string contents;
    std::string body;
    for (const PagePart& part : parts) {
        const std::string id = escape_html(part.id);
        contents += part.listed.empty()
                        ? ""
                        : "<li><a href=\"#" + id + "\">" + escape_html(part.listed) + "</a></li>\n";
        body += "<section id=\"" + id + '"' +
                (labelled ? " aria-labelledby=\"" + id + "-title\"" : "") + ">\n<h2" +
                (labelled ? " id=\"" + id + "-title\"" : "") + '>' + escape_html(part.title) +
                "</h2>\n" + part.html + "</section>\n";
    }
    return fill_template(cost_template::cost_html, {{"title", escape_html(title)},
                                                    {"css", std::string(report_template::page_css)},
                                                    {"machine", escape_html(about)},
                                                    {"contents", contents},
                                                    {"parts", body},
                                                    {"footer", escape_html(footer)}});
}

std::string comparison_page(const ComparisonReport& report, const DrawnComparison& drawn) {
    const auto& files = report.comparison.files;
    const std::vector<Figure>& figures = drawn.figures;
    Table outcome;
    outcome.columns = {{"File", Column::Kind::text},
                       {"Outcome"},
                       {"Nodes inside"},
                       {"Of the peak"},
                       {"Of p itself"},
                       {"L2"}};
    for (std::size_t i = 0; i < files.size(); ++i) {
        outcome.rows.push_back({figures[i].title, files[i].passes() ? "pass" : "FAIL",
                                std::to_string(files[i].inside), percent_text(files[i].errors.peak),
                                percent_text(files[i].errors.local),
                                percent_text(files[i].errors.l2)});
    }
    std::vector<PagePart> parts;
    const auto part = [&](const std::string& id, const std::string& title,
                          const std::string& html) {
        parts.push_back({id, title, html, title});
    };
    part("figures", "Outcome",
         "<p>Tolerances: " + escape_html(tolerance_text(report.comparison.tolerances)) + "</p>\n" +
             html_table(outcome));
    for (std::size_t i = 0; i < files.size(); ++i) {
        part(figures[i].id, figures[i].title,
             figure_html(drawn, figures[i]) + file_html(report, files[i]));
    }
    if (files.size() > 1) {
        part("convergence", "Several meshes",
             figure_html(drawn, figures.back()) + html_table(limits_table(report, true)));
    }
    return parts_page("Edgeproof compare: " + (report.title.empty() ? report.scene : report.title),
                      report.scene + (report.units ? ": " + report.units->text() : ""), parts,
                      false,
                      "Made by " + program_line() +
                          ". Exact values have the routes that are named; "
                          "edges, fits and limits of data are estimates.");
}

} // namespace edgeproof::report

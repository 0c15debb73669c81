// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_page.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"
#include "edgeproof/report/page/comparison_page.hpp"
#include "edgeproof/report/text/html_markup.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/cost/cost_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeproof::report {
namespace {

std::string notes_html(const Table& table) {
    std::string out;
    for (const std::string& note : table.notes) {
        out += "<p class=\"caption\">" + escape_html(note) + "</p>\n";
    }
    return out;
}

/// Draws a line above each row with a new text in its first column.
std::string table_html(const Table& table) {
    std::string out = "<div class=\"scroll\" tabindex=\"0\"><table class=\"cost\"><thead><tr>";
    const auto number = [&](std::size_t i) {
        return table.columns[i].kind == Column::Kind::text ? "" : " class=\"number\"";
    };
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        out += fmt::format("<th scope=\"col\"{}>{}</th>", number(i),
                           escape_html(table.columns[i].name));
    }
    out += "</tr></thead><tbody>\n";
    std::string last;
    for (const auto& row : table.rows) {
        const bool next = !row[0].empty() && row[0] != last;
        out += next && !last.empty() ? "<tr class=\"next\">" : "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += fmt::format("<td{}>{}</td>", number(i), escape_html(row[i]));
        }
        out += "</tr>\n";
        last = row[0].empty() ? last : row[0];
    }
    return out + "</tbody></table></div>\n";
}

/// The cost of each effect, with a bar proportional to its time.
std::string effects_html(const CostReport& report) {
    double most = 0;
    for (const cost::EffectCost& e : report.effects) {
        most = std::max(most, e.seconds);
    }
    std::string out = "<div class=\"scroll\" tabindex=\"0\"><table class=\"cost\"><thead><tr>"
                      "<th scope=\"col\">Effect</th><th scope=\"col\">Compared with</th>"
                      "<th scope=\"col\" class=\"number\">Time</th>"
                      "<th scope=\"col\" class=\"number\">Ratio</th><th scope=\"col\"></th></tr>"
                      "</thead><tbody>\n";
    for (const cost::EffectCost& e : report.effects) {
        out += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td>"
                           "<td class=\"number\">{}</td><td><span class=\"bar\" "
                           "style=\"width:{:.2f}rem\"></span></td></tr>\n",
                           escape_html(e.effect), escape_html(e.base), time_text(e.seconds),
                           e.base.empty() ? "" : fmt::format("{:.2f}", e.ratio),
                           most > 0 ? 14 * e.seconds / most : 0.0);
    }
    return out + "</tbody></table></div>\n";
}

struct Drawing {
    std::optional<std::filesystem::path> gnuplot;
    std::filesystem::path folder;
};

std::string figure_html(const Figure& figure, const Drawing& drawing) {
    std::string out = "<figure id=\"" + escape_html(figure.id) + "\">\n<h3>" +
                      escape_html(figure.title) + "</h3>\n<div class=\"panels\">\n";
    for (const Plot& plot : figure.plots) {
        const std::string svg = drawing.gnuplot ? draw_svg(plot, *drawing.gnuplot) : "";
        write_plot_files(plot, svg, drawing.folder);
        const std::string picture =
            svg.empty() ? "<p>" + escape_html(plot.title) + "</p>" : inline_svg(svg, plot);
        out +=
            "<div class=\"panel\">" + picture + "<p class=\"data\"><a href=\"figures/" +
            plot.id.text() +
            ".csv\">Data (CSV)</a><span class=\"soft\"> in the folder figures</span></p></div>\n";
    }
    return out + "</div>\n<figcaption>" + escape_html(figure.caption) +
           "</figcaption>\n</figure>\n";
}

std::string figures_html(const CostReport& report, const Drawing& drawing) {
    std::string out;
    if (!drawing.gnuplot) {
        out = "<p class=\"missing\">gnuplot was not found, so nothing is drawn here; the data of "
              "the figures are in the folder figures. With gnuplot installed the next run draws "
              "them.</p>\n";
    }
    for (const Figure& figure : cost_figures(report)) {
        out += figure_html(figure, drawing);
    }
    return out;
}

struct Part {
    std::string id;
    std::string title;
    std::string html;
};

std::string page(const CostReport& report, const std::string& figures) {
    std::vector<Part> parts;
    const auto add = [&](std::string id, const Table& table) {
        if (!table.rows.empty()) {
            parts.push_back({std::move(id), table.title, table_html(table) + notes_html(table)});
        }
    };
    parts.push_back({"figures", "Figures", figures});
    add("first", cost_table(report, report.cases.front().name));
    add("proofs-table", bound_table(report));
    add("growth-table", growth_table(report));
    if (!report.effects.empty()) {
        const Table table = effect_table(report);
        parts.push_back({"effects", table.title, effects_html(report) + notes_html(table)});
    }
    for (std::size_t i = 1; i < report.cases.size(); ++i) {
        add("contact-" + std::to_string(i), cost_table(report, report.cases[i].name));
    }
    std::string contents;
    std::string body;
    for (const Part& part : parts) {
        const bool one_of_many = part.id.starts_with("contact-") && part.id != "contact-1";
        if (!one_of_many) {
            contents += "<li><a href=\"#" + part.id + "\">" +
                        escape_html(part.id == "contact-1" ? "Other contacts" : part.title) +
                        "</a></li>\n";
        }
        body += "<section id=\"" + part.id + "\" aria-labelledby=\"" + part.id +
                "-title\">\n<h2 id=\"" + part.id + "-title\">" + escape_html(part.title) +
                "</h2>\n" + part.html + "</section>\n";
    }
    std::string machine;
    for (const auto& [name, value] : report.machine) {
        machine.append(machine.empty() ? "" : ", ").append(name).append(" ").append(value);
    }
    return fill_template(cost_template::cost_html,
                         {{"title", "Edgeproof: what accuracy costs"},
                          {"css", std::string(report_template::page_css)},
                          {"machine", escape_html(machine)},
                          {"contents", contents},
                          {"parts", body},
                          {"footer", escape_html("Made by edgeproof cost (" + program_line() +
                                                 "). Times are the processor's and belong to this "
                                                 "machine; counts of evaluations do not.")}});
}

} // namespace

void write_cost_page(const CostReport& report, const std::filesystem::path& folder) {
    io::make_folder(folder / "figures");
    const std::string figures = figures_html(report, {find_gnuplot(), folder / "figures"});
    io::write_whole(folder / "cost.csv", write_table(cost_cells(report), TableFormat::csv));
    io::write_whole(folder / "points.csv", write_table(cost_points(report), TableFormat::csv));
    io::write_whole(folder / "cost.json", cost_json(report));
    io::write_whole(folder / "cost.html", page(report, figures));
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/cost_page.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/report/figures/figures_svg.hpp"
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/page/parts_page.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::report {
namespace {

std::string notes_html(const Table& table) {
    std::string out;
    for (const std::string& note : table.notes) {
        out += "<p class=\"caption\">" + escape_html(note) + "</p>\n";
    }
    return out;
}

/// The cost of each effect, with a bar proportional to its time.
std::string effects_html(const CostReport& report) {
    double most = 0;
    for (const cost::EffectCost& e : report.effects) {
        most = std::max(most, e.seconds);
    }
    Table table;
    table.columns = {{"Effect", Column::Kind::text},
                     {"Compared with", Column::Kind::text},
                     {"Time"},
                     {"Ratio"},
                     {"", Column::Kind::markup}};
    for (const cost::EffectCost& e : report.effects) {
        table.rows.push_back({e.effect, e.base, time_text(e.seconds),
                              e.base.empty() ? "" : fmt::format("{:.2f}", e.ratio),
                              fmt::format("<span class=\"bar\" style=\"width:{:.2f}rem\"></span>",
                                          most > 0 ? 14 * e.seconds / most : 0.0)});
    }
    return html_table(table);
}

/// Writes the files of the figures, and returns the figures as HTML.
std::string drawn_figures(const CostReport& report, const std::filesystem::path& folder) {
    std::vector<DrawnFigure> figures;
    for (const Figure& figure : cost_figures(report)) {
        figures.push_back({figure.id, figure.title, figure.caption, {}, {}});
        for (const Plot& plot : figure.plots) {
            figures.back().panels.push_back(drawn_panel(plot, draw_svg({plot}), folder));
        }
    }
    return figures_html(figures);
}

std::string page(const CostReport& report, const std::string& figures) {
    std::vector<PagePart> parts{{"figures", "Figures", figures, "Figures"}};
    const auto add = [&](const std::string& id, const Table& table, const std::string& html,
                         const std::string& listed) {
        if (!table.rows.empty()) {
            parts.push_back({id, table.title, html + notes_html(table), listed});
        }
    };
    const auto add_table = [&](const std::string& id, const Table& table) {
        add(id, table, html_table(table, true), table.title);
    };
    add_table("first", cost_table(report, report.cases.front().name));
    add_table("proofs-table", bound_table(report));
    add_table("growth-table", growth_table(report));
    const Table effects = effect_table(report);
    add("effects", effects, effects_html(report), effects.title);
    for (std::size_t i = 1; i < report.cases.size(); ++i) {
        const Table table = cost_table(report, report.cases[i].name);
        add("contact-" + std::to_string(i), table, html_table(table, true),
            i == 1 ? "Other contacts" : "");
    }
    std::string machine;
    for (const auto& [name, value] : report.machine) {
        machine += (machine.empty() ? "" : ", ") + name + " " + value;
    }
    return parts_page("Edgeproof: what accuracy costs", machine, parts, true,
                      "Made by edgeproof cost (" + program_line() +
                          "). Times are the processor's and belong to this machine; counts of "
                          "evaluations do not.");
}

} // namespace

void write_cost_page(const CostReport& report, const std::filesystem::path& folder) {
    io::make_folder(folder / "figures");
    const std::string figures = drawn_figures(report, folder / "figures");
    io::write_whole(folder / "cost.csv", write_table(cost_cells(report), TableFormat::csv));
    io::write_whole(folder / "points.csv", write_table(cost_points(report), TableFormat::csv));
    io::write_whole(folder / "cost.json", cost_json(report));
    io::write_whole(folder / "cost.html", page(report, figures));
}

} // namespace edgeproof::report

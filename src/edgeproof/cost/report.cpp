// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cost/cost.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/text/filled_template.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/roots/roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <thread>

namespace edgeproof::cost {
namespace {

using Json = nlohmann::ordered_json;
using report::Pen;
using report::Table;
using ColumnKind = report::Column::Kind;

Table table(std::string title, const std::vector<const char*>& texts,
            const std::vector<const char*>& numbers) {
    Table t;
    t.title = std::move(title);
    for (const char* name : texts) {
        t.columns.push_back({name, ColumnKind::text});
    }
    for (const char* name : numbers) {
        t.columns.push_back({name});
    }
    return t;
}

/// For example "4.21 us", "1.30 ms", "0.83 s".
std::string time_text(double seconds) {
    const auto three = [](double x, const char* unit) {
        return fmt::format("{:.{}f} {}", x, x < 10 ? 2 : x < 100 ? 1 : 0, unit);
    };
    return seconds < 0.9995e-3 ? three(1e6 * seconds, "us")
           : seconds < 0.9995  ? three(1e3 * seconds, "ms")
                               : three(seconds, "s");
}

/// Empty for 0: evaluations that are not counted.
std::string count_text(double count) { return count > 0 ? fmt::format("{:.0f}", count) : ""; }

std::vector<std::string> row_of(const CostCell& c) {
    std::vector<std::string> row{c.route, c.arithmetic, std::to_string(c.digits),
                                 std::to_string(c.points.size())};
    if (c.failed() == c.points.size()) {
        row.insert(row.end(), {"none", "", "", "", ""});
        return row;
    }
    // Correct digits are rounded down: "50" only for at least 50.
    row.insert(row.end(),
               {fmt::format("{:.0f}{}", std::floor(c.right().least), c.failed() > 0 ? "*" : ""),
                count_text(c.over_points(&PointCost::evaluations).median),
                time_text(c.seconds().median), time_text(c.seconds().most),
                fmt::format("{:.0f} %", 100 * c.over_points(&PointCost::spread).median)});
    return row;
}

using Coordinate = double (*)(const CostCell&);
double digits_asked(const CostCell& c) { return c.digits; }
double digits_right(const CostCell& c) { return c.right().least; }
double microseconds(const CostCell& c) { return 1e6 * c.seconds().median; }

struct Line {
    std::string route;
    std::string title;
    std::vector<std::pair<double, double>> points;
};

/// Returns a line for each route of a contact. A coordinate that is 0 is missing.
std::vector<Line> lines_of(const std::vector<CostCell>& cells, const std::string& scene,
                           Coordinate x, Coordinate y) {
    std::vector<Line> lines;
    for (const CostCell& c : cells) {
        if (c.scene == scene && x(c) > 0 && y(c) > 0) {
            if (lines.empty() || lines.back().route != c.route) {
                lines.push_back({c.route, c.route, {}});
            }
            lines.back().points.emplace_back(x(c), y(c));
        }
    }
    return lines;
}

void add_growth(Table& table, const std::vector<CostCell>& cells, const std::string& scene) {
    for (const Line& line : lines_of(cells, scene, digits_asked, microseconds)) {
        if (const auto fit = roots::power_law_fit(line.points)) {
            table.rows.push_back(
                {scene, line.route, fmt::format("{:.2f}", fit->exponent),
                 fmt::format("{:+.0f} %", 100 * (std::pow(60.0 / 50, fit->exponent) - 1))});
        }
    }
}

Table point_table(const std::vector<CostCell>& cells) {
    Table t = table("Cost point by point", {"contact", "route", "arithmetic"}, {"digits"});
    t.columns.push_back({"u", ColumnKind::text});
    for (const char* name :
         {"right", "evaluations", "seconds", "repeats_spread", "contact_seconds"}) {
        t.columns.push_back({name});
    }
    t.columns.push_back({"failure", ColumnKind::text});
    t.facts = {{"machine", machine()}};
    t.notes = {"right: -log10 of the true relative error; seconds of the processor a value; "
               "repeats_spread: interquartile range over median; contact_seconds: once a contact"};
    for (const CostCell& c : cells) {
        for (const PointCost& p : c.points) {
            const auto text = [&](const char* format, double number) {
                return p.failure.empty() ? fmt::format(fmt::runtime(format), number) : "";
            };
            t.rows.push_back({c.scene, c.route, c.arithmetic, std::to_string(c.digits), p.u,
                              text("{:.2f}", p.right), count_text(p.evaluations),
                              text("{:.4g}", p.seconds), text("{:.3f}", p.spread),
                              fmt::format("{:.4g}", c.contact_seconds), p.failure});
        }
    }
    return t;
}

/// Writes the files of a picture to the folder. Returns the picture as HTML; empty if it has no
/// data. The lines share only the axes: each has its own column and its own rows.
std::string picture(const std::string& id, const std::string& title, const std::string& caption,
                    const report::Axis& x, const report::Axis& y, const std::vector<Line>& lines,
                    const std::filesystem::path& folder) {
    const PrecisionScope scope(20);
    report::Plot plot;
    plot.id = id + "-time";
    plot.title = title;
    plot.description = caption;
    plot.x = x;
    plot.y = y;
    using Colour = Pen::Colour;
    const std::array<Pen, 4> pens{{{Colour::blue, 1, 4},
                                   {Colour::orange, 1, 6},
                                   {Colour::black, 1, 5},
                                   {Colour::sky_blue, 1, 12}}};
    for (const Line& line : lines) {
        plot.add_curve(line.route, line.title, pens.at(plot.curves.size() % pens.size()));
        for (const auto& [x_value, y_value] : line.points) {
            plot.add_row(Real(x_value)).back() = Real(y_value);
        }
    }
    if (plot.rows.empty()) {
        return "";
    }
    const Json figure{{"id", id},
                      {"title", title},
                      {"caption", caption},
                      {"panels", {drawn_panel(plot, report::draw_svg({plot}), folder)}},
                      {"problem", ""}};
    return report::figures_html(Json::array({figure}));
}

/// Returns both pictures of the first contact.
std::string pictures(const std::vector<CostCell>& cells, const std::filesystem::path& folder) {
    const report::Axis time{"time a value, microseconds", true};
    const std::string& first = cells.front().scene;
    std::vector<Line> growth = lines_of(cells, first, digits_asked, microseconds);
    for (Line& line : growth) {
        if (const auto fit = roots::power_law_fit(line.points); fit && fit->points > 2) {
            line.title += fmt::format(" ~ d^{:.2f}", fit->exponent);
        }
    }
    return picture("work-precision", "What digits cost: " + first,
                   "For each route, the digits right at the worst point (by an enclosure) against "
                   "the median time of the processor a value, both on logarithmic axes. Further "
                   "left and further up is better.",
                   time, {"digits right, worst point", true},
                   lines_of(cells, first, microseconds, digits_right), folder) +
           picture("growth", "Growth with the digits: " + first,
                   "Median time a value against the digits asked for. The exponents are fitted "
                   "over all digits shown.",
                   {"digits asked for", true}, time, growth, folder);
}

std::string page(const std::vector<CostCell>& cells, const std::string& pictures_html) {
    Json tables = Json::array();
    for (const Table& t : cost_tables(cells)) {
        tables.push_back({{"id", fmt::format("table-{}", tables.size() + 1)},
                          {"title", t.title},
                          {"notes", t.notes},
                          {"lines", aligned_lines(t, 0, true)}});
    }
    return report::filled(cost_html, {{"css", report::report_template::page_css},
                                      {"machine", machine()},
                                      {"pictures", pictures_html},
                                      {"tables", tables},
                                      {"program", report::program_line()}});
}

} // namespace

std::string machine() {
    std::string processor = "unknown";
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            processor = line.substr(colon + 2);
        }
    }
#ifdef __clang__
    constexpr const char* compiler = "Clang " __clang_version__;
#else
    constexpr const char* compiler = "GCC " __VERSION__;
#endif
    return fmt::format("processor {}, cores {}, compiler {}", processor,
                       std::thread::hardware_concurrency(), compiler);
}

std::vector<Table> cost_tables(const std::vector<CostCell>& cells) {
    std::vector<Table> tables;
    Table growth = table("Growth with the digits", {"contact", "route"},
                         {"time ~ digits^", "ten digits more, at 50"});
    growth.notes = {
        "exponents by least squares in the logarithms, over all digits that were timed"};
    for (const CostCell& c : cells) {
        const std::string title = "What a value costs: " + c.scene;
        if (tables.empty() || tables.back().title != title) {
            tables.push_back(table(title, {"route", "in"},
                                   {"digits", "points", "right", "evaluations", "time a value",
                                    "slowest", "repeats"}));
            add_growth(growth, cells, c.scene);
        }
        tables.back().rows.push_back(row_of(c));
    }
    if (!tables.empty()) {
        tables.front().notes = {
            "digits: requested; right: digits that are right at the worst point, by an enclosure "
            "(*: some points have no value)",
            "evaluations of the integrand and time of the processor: median over the points; "
            "slowest: the slowest point",
            "repeats: how far repeats of one point lie apart (middle half over median)"};
    }
    tables.push_back(std::move(growth));
    std::erase_if(tables, [](const Table& t) { return t.rows.empty(); });
    return tables;
}

void write_cost_page(const std::vector<CostCell>& cells, const std::filesystem::path& folder) {
    io::make_folder(folder / "figures");
    io::write_whole(folder / "cost.csv", write_table(point_table(cells), report::TableFormat::csv));
    io::write_whole(folder / "cost.html", page(cells, pictures(cells, folder / "figures")));
}

} // namespace edgeproof::cost

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace edgeproof::cli {
namespace {

struct CompareOptions {
    std::string scene;
    std::string step; ///< of a load history; empty: the last one
    std::vector<std::string> results;
    std::string columns;
    std::string scale;
    std::string origin = "0";
    std::string tolerance;                         ///< "3%", or "p=3%,a=1%"
    std::map<std::string, std::string> tolerances; ///< by the names of tolerance_names
    std::string of = "peak";
    std::string zone = "0";
    bool partial = false;
    bool json = false;
    std::string format;
    std::string out;
};

struct ToleranceRow {
    std::string_view name;
    std::optional<double> comparison::Tolerances::*field;
};
constexpr ToleranceRow tolerance_rows[] = {{"a", &comparison::Tolerances::edges},
                                           {"P", &comparison::Tolerances::force},
                                           {"c0", &comparison::Tolerances::c0},
                                           {"q", &comparison::Tolerances::q},
                                           {"surface", &comparison::Tolerances::surface}};

double tolerance_value(const std::string& option, const std::string& text) {
    refuse_whole_tolerance(option, text);
    try {
        return scene::parse_tolerance(text).to<double>();
    } catch (const InputError& error) {
        throw InputError(option + " " + text + ": " + error.problem(),
                         "write it as 3%, 0.03 or 3/100");
    }
}

comparison::Tolerances tolerances_of(const CompareOptions& o) {
    comparison::Tolerances t;
    std::map<std::string, std::string> given = o.tolerances;
    for (const std::string& part :
         o.tolerance.empty() ? std::vector<std::string>{} : parts_of(o.tolerance)) {
        const std::size_t equals = part.find('=');
        const std::string name = equals == std::string::npos ? "p" : part.substr(0, equals);
        given[name] = equals == std::string::npos ? part : part.substr(equals + 1);
    }
    for (const auto& [name, text] : given) {
        if (text.empty()) {
            continue;
        }
        const std::string option = name == "p" ? "--tolerance" : "--tolerance-" + name;
        const double value = tolerance_value(option, text);
        if (name == "p") {
            t.pressure = value;
            t.stated = true;
            continue;
        }
        const auto* const row = std::ranges::find(tolerance_rows, name, &ToleranceRow::name);
        require(row != std::end(tolerance_rows),
                "--tolerance " + o.tolerance + ": there is no " + name,
                "write p, a, P, c0, q or surface, such as p=3%,a=1%");
        t.*row->field = value;
    }
    t.of = comparison::norm_named(o.of);
    t.zone = comparison::parse_edge_zone(o.zone);
    t.partial = o.partial;
    return t;
}

std::optional<Rational> origin_of(const std::string& text) {
    if (text == "auto") {
        return {};
    }
    const auto number = io::read_number(text);
    require(number.has_value(), "--origin " + text + " is no place",
            "give the x of the data at which the scene has its origin, or auto");
    return number;
}

int compare_results(const CompareOptions& o) {
    const bool json = o.json || text_or_json(o.format);
    io::check_output(o.out);
    require(!o.scene.empty() && !o.results.empty(),
            o.scene.empty() ? "no scene is given" : "no result is given",
            "write edgeproof compare SCENE.toml RESULT.csv");
    const comparison::Tolerances tolerances = tolerances_of(o);
    const auto origin = origin_of(o.origin);
    comparison::ResultReading reading = comparison::reading_of({}, o.columns, o.scale);
    scene::Scene scene = scene::read_scene(file_or_shipped(o.scene, shipped_scenes));
    choose_step(scene, o.step);
    reading.units = scene.units;
    std::vector<comparison::ResultTable> tables; // all are read before any work
    for (const std::string& file : o.results) {
        tables.push_back(comparison::read_result(file, reading));
    }
    const comparison::ExactContact exact(scene);
    std::function<void(std::size_t, std::size_t)> progress;
    const report::ComparisonReport report{
        o.scene, scene.title, scene.units, &exact, with_progress("files", progress, [&] {
            return compare_tables(std::move(tables), scene, exact, tolerances, origin, progress);
        })};
    const std::string text =
        json ? comparison_json(report) : printable_lines(comparison_text(report));
    const bool printed = o.out.empty() || o.out == "-";
    const std::string end = json || printed ? "" : "program: " + report::program_line() + "\n";
    io::write_output(printed ? "-" : o.out, text + end);
    return report.comparison.passes() ? 0 : 1;
}

} // namespace

void add_compare(CLI::App& app, int& code) {
    auto [sub, o] = add_command<CompareOptions>(app, code, "compare", compare_results);
    option(sub, "scene", o.scene);
    option(sub, "results", o.results);
    option(sub, "--step", o.step);
    option(sub, "--columns", o.columns);
    option(sub, "--scale", o.scale);
    option(sub, "--origin", o.origin);
    option(sub, "--tolerance", o.tolerance);
    for (const ToleranceRow& row : tolerance_rows) { // the older spelling
        const std::string name(row.name);
        sub.add_option("--tolerance-" + name, o.tolerances[name])->group("");
    }
    option(sub, "--of", o.of);
    option(sub, "--edge-zone", o.zone);
    option(sub, "--partial", o.partial);
    option(sub, "--json", o.json);
    option(sub, "--format", o.format);
    option(sub, "--out", o.out);
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace edgeproof::cli {
namespace {

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

comparison::Tolerances tolerances_of(const Options& o) {
    comparison::Tolerances t;
    std::map<std::string, std::string> given;
    for (const ToleranceRow& row : tolerance_rows) { // the older spelling
        given.emplace(row.name, o["--tolerance-" + std::string(row.name)]);
    }
    for (const std::string& part :
         o["--tolerance"].empty() ? std::vector<std::string>{} : parts_of(o["--tolerance"])) {
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
                "--tolerance " + o["--tolerance"] + ": there is no " + name,
                "write p, a, P, c0, q or surface, such as p=3%,a=1%");
        t.*row->field = value;
    }
    t.of = comparison::norm_named(o["--of"]);
    t.zone = comparison::parse_edge_zone(o["--edge-zone"]);
    t.partial = o.has("--partial");
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

} // namespace

int compare(Options& o) {
    const bool json = o.has("--json") || text_or_json(o["--format"]);
    io::check_output(o["--out"]);
    require(!o["scene"].empty() && !o.list("results").empty(),
            o["scene"].empty() ? "no scene is given" : "no result is given",
            "write edgeproof compare SCENE.toml RESULT.csv");
    const comparison::Tolerances tolerances = tolerances_of(o);
    const auto origin = origin_of(o["--origin"]);
    comparison::ResultReading reading = comparison::reading_of({}, o["--columns"], o["--scale"]);
    scene::Scene scene = scene::read_scene(file_or_shipped(o["scene"], shipped_scenes));
    choose_step(scene, o["--step"]);
    reading.units = scene.units;
    std::vector<comparison::ResultTable> tables; // all are read before any work
    for (const std::string& file : o.list("results")) {
        tables.push_back(comparison::read_result(file, reading));
    }
    const comparison::ExactContact exact(scene);
    std::function<void(std::size_t, std::size_t)> progress;
    const report::ComparisonReport report{
        o["scene"], scene.title, scene.units, &exact, with_progress("files", progress, [&] {
            return compare_tables(std::move(tables), scene, exact, tolerances, origin, progress);
        })};
    const std::string text =
        json ? comparison_json(report) : printable_lines(comparison_text(report));
    const bool printed = o["--out"].empty() || o["--out"] == "-";
    const std::string end = json || printed ? "" : "program: " + report::program_line() + "\n";
    io::write_output(printed ? "-" : o["--out"], text + end);
    return report.comparison.passes() ? 0 : 1;
}

} // namespace edgeproof::cli

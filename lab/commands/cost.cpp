// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab.hpp"

#include "edgeproof/cli/all_commands.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/staged_folder.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/cost/cost_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_cost = 100'000;
constexpr std::size_t most_points = 100'000;

struct CostArguments {
    std::vector<std::string> scenes;
    std::string digits = "16,34,50,100,200,500,1000";
    std::string points;
    std::string out;
    bool full = false;
    bool json = false;
};

std::vector<unsigned> digits_of_costs(const std::string& text) {
    const auto list = whole_numbers("--digits", text, 2, most_digits_of_a_cost);
    const std::set<unsigned> digits(list.begin(), list.end());
    return {digits.begin(), digits.end()};
}

std::vector<cost::CostCase> cases_of(const CostArguments& a) {
    std::vector<cost::CostCase> cases =
        a.scenes.empty() ? cost::usual_cases() : std::vector<cost::CostCase>{};
    std::set<std::string> names;
    for (const std::string& file : a.scenes) {
        cost::CostCase asked =
            cost::case_of(scene::read_scene(file_or_shipped(file, shipped_scenes)));
        const std::string name = asked.name;
        for (std::size_t k = 2; !names.insert(asked.name).second; ++k) {
            asked.name = name + " " + std::to_string(k);
        }
        cases.push_back(std::move(asked));
    }
    return cases;
}

report::CostReport measured(const CostArguments& a) {
    report::CostReport report;
    report.machine = cost::machine();
    report.cases = cases_of(a);
    cost::CostOptions options;
    options.digits = report.digits = digits_of_costs(a.digits);
    options.points = a.points.empty() ? 0 : whole_number("--points", a.points, 1, most_points);
    options.full = a.full;
    if (a.scenes.empty()) {
        report.effects = with_progress("effects", options.progress, [&] {
            return cost::effect_costs(report.effect_digits(), true, options.progress);
        });
    }
    report.cells = with_progress("routes by digits", options.progress,
                                 [&] { return measure(report.cases, options); });
    return report;
}

void print(const report::CostReport& report, bool usual) {
    const auto show = [](const report::Table& table) {
        if (!table.rows.empty()) {
            std::printf("%s\n", aligned_text(table).c_str());
        }
    };
    for (const cost::CostCase& c : report.cases) {
        if (!usual || &c == &report.cases.front()) {
            show(cost_table(report, c.name));
        }
    }
    if (usual) {
        show(cost_table_at(report, report.usual_digits()));
    }
    show(growth_table(report));
    show(bound_table(report));
    show(effect_table(report));
    std::string where = report::program_line();
    for (const auto& [name, value] : report.machine) {
        where += fmt::format("{} {} {}", name == "processor" ? ";" : ",", name, value);
    }
    std::printf("%s\n", where.c_str());
}

int cost(const CostArguments& a) {
    if (!a.out.empty()) {
        io::check_folder(a.out); // fails before minutes of work, not after them
    }
    const report::CostReport report = measured(a);
    if (!a.out.empty()) {
        io::write_folder(
            a.out, [&](const std::filesystem::path& folder) { write_cost_page(report, folder); });
    }
    if (a.json) {
        std::fputs(cost_json(report).c_str(), stdout);
    } else {
        print(report, a.scenes.empty());
    }
    return 0;
}

} // namespace

void add_cost(CLI::App& app, int& code) {
    auto [sub, a] = add_command<CostArguments>(app, code, lab_cost.name, lab_cost.help, cost);
    sub.add_option("scenes", a.scenes,
                   "scenes (TOML) to time at their own points; without any, a set of contacts "
                   "with easy and hard points");
    sub.add_option("--digits", a.digits, "how many digits, a list")->capture_default_str();
    sub.add_option("--points", a.points,
                   "points of a contact, at most, for every route and number of digits (default: "
                   "fewer the more digits there are, and few of the reference routes)");
    sub.add_flag("--full", a.full,
                 "every route at every point and number of digits, however long it takes");
    sub.add_option("--out,--out-dir", a.out,
                   "write cost.html, CSV files and figures to this folder");
    sub.add_flag("--json", a.json, "print JSON, with every point");
}

} // namespace edgeproof::cli

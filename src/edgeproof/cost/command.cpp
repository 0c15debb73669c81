// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/cost/cost.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <cstdio>
#include <set>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_cost = 100'000;
constexpr std::size_t most_points = 100'000;

std::vector<cost::CostCase> cases_of(const Options& o) {
    const std::vector<std::string>& scenes = o.list("scenes");
    std::vector<cost::CostCase> cases =
        scenes.empty() ? cost::usual_cases() : std::vector<cost::CostCase>{};
    std::set<std::string> names;
    for (const std::string& file : scenes) {
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

std::vector<cost::CostCell> measured(const Options& o) {
    std::vector<std::size_t> list;
    for (const std::string& digits : parts_of(o["--digits"])) {
        list.push_back(whole_number("--digits", digits, 2, most_digits_of_a_cost));
    }
    const std::set<unsigned> digits(list.begin(), list.end());
    cost::CostOptions options;
    options.digits.assign(digits.begin(), digits.end());
    options.points =
        o["--points"].empty() ? 0 : whole_number("--points", o["--points"], 1, most_points);
    const std::vector<cost::CostCase> cases = cases_of(o);
    return with_progress("routes by digits", options.progress,
                         [&] { return measure(cases, options); });
}

/// Returns title, notes and aligned columns: text to the left, numbers to the right.
std::string aligned_text(const report::Table& table) {
    std::string text = table.title + "\n";
    for (const std::string& note : table.notes) {
        text += "  " + note + "\n";
    }
    return text + "\n" + report::aligned_lines(table, 0, true);
}

} // namespace

int cost(Options& o) {
    if (!o["--out"].empty()) {
        io::check_folder(o["--out"]); // fails before minutes of work, not after them
    }
    const std::vector<cost::CostCell> cells = measured(o);
    if (!o["--out"].empty()) {
        io::write_folder(o["--out"], [&](const std::filesystem::path& folder) {
            write_cost_page(cells, folder);
        });
    }
    for (const report::Table& table : cost_tables(cells)) {
        std::printf("%s\n", aligned_text(table).c_str());
    }
    std::printf("%s; %s\n", report::program_line().c_str(), cost::machine().c_str());
    return 0;
}

} // namespace edgeproof::cli

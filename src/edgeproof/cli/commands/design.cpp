// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::cli {
namespace {

/// Moves what [design] has under a name of its own out of [ask].
void move_question(GivenScene& given, const std::string& maximise) {
    io::TomlTable design{"design", 0, {}};
    for (io::TomlTable& table : given.instead) {
        for (io::TomlEntry& entry : table.entries) {
            if (table.name != "ask") {
                continue;
            }
            if (entry.key == "edges") {
                const auto& edges = std::get<std::vector<std::string>>(entry.value);
                design.entries.push_back({"edge", edges.size() == 2 ? "both" : edges.front()});
            } else if (entry.key == "terms") {
                design.entries.push_back(
                    {"terms", std::get<std::vector<std::string>>(entry.value).front()});
            } else if (entry.key == "tolerance") {
                design.entries.push_back(entry);
            } else {
                throw InputError(entry.key + " has no effect on a design",
                                 "leave " + entry.key + " out");
            }
        }
    }
    std::erase_if(given.instead, [](const io::TomlTable& table) { return table.name == "ask"; });
    if (!maximise.empty()) {
        design.entries.push_back({"maximise", maximise});
    }
    require(!given.file.empty() ||
                std::ranges::count(design.entries, "tolerance", &io::TomlEntry::key) != 0,
            "no tolerance is given", "add tolerance=1%");
    if (!design.entries.empty()) {
        given.instead.push_back(std::move(design));
    }
}

scene::DesignScene design_of(const Options& o) {
    GivenScene given = given_scene(o.list("scene"), shipped_designs);
    move_question(given, o["--maximise"]);
    if (given.file.empty()) {
        o.as_file = scene::scene_text(given.instead);
    }
    const std::string text =
        given.file.empty() ? "" : io::read_text(given.file, "scene (TOML)", io::most_toml_bytes);
    try {
        return scene::parse_design(
            text, given.file.empty() ? "command line" : io::input_name(given.file), given.instead);
    } catch (const InputError& error) {
        if (error.line() != 0) {
            throw;
        }
        throw InputError(error.problem(), error.instead());
    }
}

Rational gap_of(const std::string& text) {
    const Rational gap = parse_decimal(text);
    require(gap > 0, "--gap " + text + " is not positive", "write --gap 1e-6");
    return gap;
}

} // namespace

int design(Options& o) {
    const scene::DesignScene asked = design_of(o);
    scene::Digits digits;
    digits.count = !o["--digits"].empty() ? digits_of(o["--digits"], scene::most_design_digits)
                   : is_short(o)          ? digits_of_short_answer
                                          : 30;
    (void)table_format(o);
    io::check_output(o["--out"]);
    contact::DesignOptions options;
    options.digits = digits.count;
    options.gap = gap_of(o["--gap"]);
    const scene::DesignResult result = with_progress("thousandths of the range", options.progress,
                                                     [&] { return run_design(asked, options); });
    report::Table table = report::design_table(asked, result, options);
    table.asked = fmt::format("the best value for the reach of {} term{} within {}", asked.terms,
                              asked.terms == 1 ? "" : "s", report::in_percent(asked.tolerance));
    emit(table, o);
    return 0;
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/child_process.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/commands/bounds_tables.hpp"
#include "lab/cost/cost.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_scenes = 1'000'000;
constexpr std::size_t most_digits_of_a_scan = 1000;
constexpr std::size_t longest_limit = 86'400;
constexpr double most_waiting = 20; ///< elapsed time over processor time, on a busy machine

struct SpeedChoice {
    std::string scenes = "100";
    std::string seed = "1";
    std::string only;
    std::string digits = "50,200";
    std::string limit = "100";
    std::string threads = "1";
    std::string write;
    bool csv = false;
};

/// Runs this program in a process of its own, as a user does: caches are empty, and a run that
/// takes too long can be ended.
cost::TimedAnswer answered(const cost::SampledScene& scene, const cost::ScannedCommand& command,
                           unsigned digits, std::size_t limit) {
    io::ProgramCall call;
    call.arguments = {"/bin/sh",
                      "-c",
                      fmt::format("ulimit -t {}; exec \"$0\" \"$@\"", limit),
                      std::filesystem::read_symlink("/proc/self/exe").string(),
                      command.name,
                      "-"};
    std::istringstream options(command.options);
    for (std::string option; options >> option;) {
        call.arguments.push_back(option);
    }
    call.arguments.insert(call.arguments.end(), {"--digits", std::to_string(digits)});
    call.input = scene.text;
    call.seconds = static_cast<double>(limit) * most_waiting;
    std::string said;
    call.said = [&](std::string_view text) { said += text; };
    const io::ProgramRun run = run_program(call);
    cost::TimedAnswer answer;
    answer.seconds = run.processor_seconds;
    answer.stopped = run.timed_out || run.signal == SIGXCPU || run.signal == SIGKILL;
    if (!answer.stopped && !run.ending().empty()) {
        answer.failure = said.empty() ? run.ending() : said.substr(0, said.find('\n'));
    }
    return answer;
}

report::Table speed_table(const std::vector<cost::SpeedCell>& cells, const SpeedChoice& o) {
    using Kind = report::Column::Kind;
    report::Table t;
    t.title = "Processor time of scenes drawn from seed " + o.seed;
    for (const cost::ScannedCommand& command : cost::scanned_commands) {
        t.notes.push_back(std::string(command.name) + ": edgeproof " + command.name + " SCENE " +
                          command.options);
    }
    t.notes.push_back("seconds, the start of the program included; ratio: of the slowest scene to "
                      "the median of its kind, command and digits");
    t.notes.push_back("stopped: took longer than " + o.limit + " s, which counts as that long");
    t.notes.push_back("scene: the number of the slowest one: bounds speed --seed " + o.seed +
                      " --only NUMBER");
    t.columns = {{"kind", Kind::text},    {"command", Kind::text},  {"digits", Kind::count},
                 {"scenes", Kind::count}, {"median", Kind::number}, {"slowest", Kind::number},
                 {"ratio", Kind::number}, {"scene", Kind::count},   {"stopped", Kind::count},
                 {"failed", Kind::count}};
    for (const cost::SpeedCell& c : cells) {
        t.rows.push_back({c.kind, cost::scanned_commands.at(c.command).name,
                          std::to_string(c.digits), std::to_string(c.scenes.size()),
                          fmt::format("{:.3f}", c.median()),
                          fmt::format("{:.3f}", c.scenes.front().answer.seconds),
                          fmt::format("{:.1f}", c.ratio()), std::to_string(c.scenes.front().number),
                          std::to_string(c.stopped()), std::to_string(c.failed())});
    }
    return t;
}

int speed(const SpeedChoice& o) {
    cost::SpeedOptions options;
    options.seed = whole_number("--seed", o.seed, 0, most_scenes);
    options.scenes = whole_number("--scenes", o.scenes, 1, most_scenes);
    if (!o.only.empty()) {
        options.only = whole_number("--only", o.only, 0, most_scenes);
    }
    const auto list = whole_numbers("--digits", o.digits, 2, most_digits_of_a_scan);
    options.digits.assign(list.begin(), list.end());
    const std::size_t limit = whole_number("--limit", o.limit, 1, longest_limit);
    options.threads = threads_of(o.threads);
    options.answer = [&](const cost::SampledScene& scene, const cost::ScannedCommand& command,
                         unsigned digits) { return answered(scene, command, digits, limit); };
    if (!o.write.empty()) {
        io::make_folder(o.write); // fails before the work, not after it
    }
    const auto cells =
        with_progress("scenes", options.progress, [&] { return scan_speed(options); });
    if (options.only) {
        std::printf("%s\n", cost::sampled_scene(options.seed, *options.only).text.c_str());
    }
    const report::Table table = speed_table(cells, o);
    std::printf("%s", o.csv ? write_table(table, report::TableFormat::csv).c_str()
                            : (aligned_text(table) + report::program_line() + "\n").c_str());
    bool failed = false;
    for (const cost::SpeedCell& c : cells) {
        for (const cost::SpeedCell::Scene& s : c.scenes) {
            if (!s.answer.failure.empty()) {
                failed = true;
                std::fprintf(stderr, "scene %zu, %s, %u digits: %s\n", s.number,
                             cost::scanned_commands.at(c.command).name, c.digits,
                             s.answer.failure.c_str());
            }
        }
        if (!o.write.empty()) {
            const std::size_t number = c.scenes.front().number;
            io::write_whole(std::filesystem::path(o.write) / fmt::format("scene-{}.toml", number),
                            fmt::format("# bounds speed --seed {} --only {}\n{}", o.seed, number,
                                        cost::sampled_scene(options.seed, number).text));
        }
    }
    return failed ? 1 : 0;
}

} // namespace

void add_bounds_speed(CLI::App& bounds, int& code) {
    auto [sub, o] = add_command<SpeedChoice>(
        bounds, code, "speed",
        "scenes drawn from a seed, each timed: those that take much longer than others of their "
        "kind; exit 1 where one has no answer",
        speed);
    sub.add_option("--scenes", o.scenes, "how many")->capture_default_str();
    sub.add_option("--seed", o.seed, "what they are drawn from")->capture_default_str();
    sub.add_option("--only", o.only, "only the scene of this number, which is printed too");
    sub.add_option("--digits", o.digits, "digits asked for, a list")->capture_default_str();
    sub.add_option("--limit", o.limit, "seconds after which an answer is stopped")
        ->capture_default_str();
    sub.add_option("--threads", o.threads, "scenes at a time")->capture_default_str();
    sub.add_option("--write", o.write, "write the slowest scene of each row to this folder");
    sub.add_flag("--csv", o.csv, "write CSV");
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab.hpp"

#include "edgeproof/cli/all_commands.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/commands/bounds_tables.hpp"

#include <cstdio>
#include <filesystem>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_bounds = 1000;
constexpr std::size_t most_values = 100'000'000;

struct Output {
    bool csv = false;
    bool json = false;
    bool md = false;
};

void add_output(CLI::App& sub, Output& o) {
    auto* csv = sub.add_flag("--csv", o.csv, "write CSV");
    auto* json = sub.add_flag("--json", o.json, "write JSON");
    auto* md = sub.add_flag("--md", o.md, "write Markdown");
    csv->excludes(json)->excludes(md);
    json->excludes(md);
    sub.add_option_function<std::string>(
           "--format",
           [&o](const std::string& format) {
               o.csv = format == "csv";
               o.json = format == "json";
               o.md = format == "md";
           },
           "in place of the three options above")
        ->type_name("csv|json|md")
        ->check(CLI::IsMember({"csv", "json", "md"}))
        ->excludes(csv)
        ->excludes(json)
        ->excludes(md);
}

std::string written(const report::Table& table, const Output& o) {
    return o.csv    ? write_table(table, report::TableFormat::csv)
           : o.json ? write_table(table, report::TableFormat::json)
           : o.md   ? write_table(table, report::TableFormat::markdown)
                    : aligned_text(table) + report::program_line() + "\n";
}

struct CountingOptions {
    std::string values = "100000";
    std::string seed = "1";
    std::string digits = "50";
    std::string threads;
    std::string state;
    Output output;
};

/// Returns counting(state) with the options of the command line and with progress; the state is
/// kept in a file if one is given.
template <class Counting>
auto counted(const validation::CountKind& kind, const CountingOptions& o,
             validation::CountOptions& options, const Counting& counting) {
    options.values = whole_number("--values", o.values, 1, most_values);
    options.seed = whole_number("--seed", o.seed, 0, most_values);
    options.digits = digits_of(o.digits, most_digits_of_bounds);
    options.threads = threads_of(o.threads);
    validation::CountState state{options.seed, options.values, options.digits, {}};
    const std::string& file = o.state;
    check_state(file);
    if (!file.empty()) {
        if (std::filesystem::exists(file)) {
            state = parse_count_state(kind, io::read_text(file, "state of a count"), file, state);
        }
        options.checkpoint = [&](const validation::CountState& now) {
            io::write_checkpoint(file, write_count_state(kind, now));
        };
    }
    const io::KeptNote note(file.empty() ? ""
                                         : "what is done is kept in " + file +
                                               "; the same command goes on from there");
    try {
        return with_progress("values", options.progress, [&] { return counting(state); });
    } catch (const Interrupted& e) {
        throw Interrupted(e.what() +
                          (file.empty()
                               ? "; with --state FILE a count can be gone on with"
                               : ", kept in " + file + "; the same command goes on from there"));
    }
}

int count(const CountingOptions& o) {
    validation::EnclosureCountOptions options;
    const auto result =
        counted(validation::enclosure_count(), o, options,
                [&](validation::CountState& state) { return count_values(options, state); });
    std::printf("%s", written(count_table(options, result), o.output).c_str());
    for (const validation::CountFinding& f : result.findings) {
        std::fprintf(stderr, "%s\n", finding_text(f).c_str());
    }
    return result.total.failures() == 0 ? 0 : 1;
}

int binary64(const CountingOptions& o) {
    validation::Binary64Options options;
    const auto result =
        counted(validation::binary64_count(), o, options,
                [&](validation::CountState& state) { return count_binary64(options, state); });
    std::printf("%s", written(binary64_table(result), o.output).c_str());
    for (const std::string& finding : result.findings) {
        std::fprintf(stderr, "%s\n", finding.c_str());
    }
    return result.total.failures() == 0 ? 0 : 1;
}

void add_counting_options(CLI::App& sub, CountingOptions& o, bool digits) {
    sub.add_option("--values", o.values, "how many")->capture_default_str();
    sub.add_option("--seed", o.seed, "what they are drawn from")->capture_default_str();
    if (digits) {
        sub.add_option("--digits", o.digits, "digits asked for")->capture_default_str();
    }
    add_threads_option(sub, o.threads);
    sub.add_option("--state", o.state,
                   "keep what is done in this file, and go on from it where it is there");
    add_output(sub, o.output);
}

} // namespace

void add_bounds(CLI::App& app, int& code) {
    CLI::App& all = *app.add_subcommand(lab_bounds.name, lab_bounds.help);
    all.require_subcommand(1);

    auto [counting, n] = add_command<CountingOptions>(
        all, code, "count",
        "values drawn from a seed, each tested: enclosed, rounded correctly, tight; exit 1 "
        "where one fails",
        count);
    add_counting_options(counting, n, true);

    auto [words, b] = add_command<CountingOptions>(
        all, code, "binary64",
        "values in double words (p, q, sums of terms, relative errors), compared with balls; exit "
        "1 where one is not correctly rounded",
        binary64);
    b.values = "1000000";
    add_counting_options(words, b, false);
}

} // namespace edgeproof::cli

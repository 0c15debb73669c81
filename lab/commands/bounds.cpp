// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab.hpp"

#include "edgeproof/cli/all_commands.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/counts/binary64_count.hpp"
#include "lab/counts/count.hpp"

#include <cstdio>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_bounds = 1000;
constexpr std::size_t most_values = 100'000'000;

struct CountingOptions {
    std::string values = "100000";
    std::string seed = "1";
    std::string digits = "50";
    std::string threads;
    std::string format;
};

/// Returns the result of a count with the options of the command line and with progress.
template <class Options, class Counting>
auto counted(const CountingOptions& o, Options& options, const Counting& counting) {
    options.values = whole_number("--values", o.values, 1, most_values);
    options.seed = whole_number("--seed", o.seed, 0, most_values);
    options.digits = digits_of(o.digits, most_digits_of_bounds);
    options.threads = threads_of(o.threads);
    return with_progress("values", options.progress, [&] { return counting(options); });
}

void print(const report::Table& table, const std::string& format) {
    const std::string text = format.empty() ? aligned_text(table) + report::program_line() + "\n"
                                            : write_table(table, format_of(format));
    std::printf("%s", text.c_str());
}

int count(const CountingOptions& o) {
    validation::EnclosureCountOptions options;
    const auto result = counted(o, options, validation::count_values);
    print(count_table(options, result), o.format);
    for (const validation::CountFinding& f : result.findings) {
        std::fprintf(stderr, "%s\n", text_of(f).c_str());
    }
    return result.total.failures() == 0 ? 0 : 1;
}

int binary64(const CountingOptions& o) {
    validation::Binary64Options options;
    const auto result = counted(o, options, validation::count_binary64);
    print(binary64_table(result), o.format);
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
    sub.add_option("--format", o.format, "csv, json or md (default: aligned text)")
        ->type_name("csv|json|md");
}

} // namespace

std::string aligned_text(const report::Table& table) {
    std::string text = table.title + "\n";
    for (const std::string& note : table.notes) {
        text += "  " + note + "\n";
    }
    return text + "\n" + report::aligned_lines(table, 0, true);
}

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab.hpp"

#include "edgeproof/cli/all_commands.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/child_process.hpp"
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

struct CasesOptions {
    std::string file = "reference/hard-cases.toml";
    std::string digits = "50";
    std::string threads;
    bool classes = false;
    Output output;
};

int hard_cases(const CasesOptions& o) {
    const auto cases =
        validation::parse_hard_cases(io::read_text(o.file, "file of hard cases (TOML)"), o.file);
    validation::CaseOptions options;
    options.digits = digits_of(o.digits, most_digits_of_bounds);
    options.threads = threads_of(o.threads);
    const auto outcomes =
        with_progress("cases", options.progress, [&] { return run_cases(cases, options); });
    const bool text = !o.output.csv && !o.output.json && !o.output.md;
    if (!o.classes) {
        const report::Table table = case_table(cases, outcomes, options.digits, text);
        std::printf("%s%s", written(table, o.output).c_str(), text ? "\n" : "");
    }
    if (o.classes || text) {
        std::printf("%s", written(family_table(cases, outcomes, options.digits), o.output).c_str());
    }
    std::size_t faults = 0;
    std::size_t undecided = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        undecided += outcomes[i].undecided ? 1 : 0;
        if (!outcomes[i].fault.empty()) {
            ++faults;
            std::fprintf(stderr, "%s:%zu: %s: %s\n", o.file.c_str(), cases[i].line,
                         cases[i].name.c_str(), outcomes[i].fault.c_str());
        }
    }
    if (text) {
        std::printf("\n%zu cases: %zu by ball and two routes alike, %zu undecided by balls as the "
                    "cases say why, %zu otherwise\n",
                    cases.size(), cases.size() - faults - undecided, undecided, faults);
    }
    return faults == 0 ? 0 : 1;
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

struct HonestyChoice {
    std::string digits = "50";
    std::string scripts = "bench/honesty";
    Output output;
};

constexpr double script_seconds = 600;

/// Another program for the same task, if its interpreter and its script are there.
struct Peer {
    const char* name;
    const char* needs; ///< a command that succeeds if the interpreter is suitable
    const char* script;
    const char* run; ///< the shell command; $0 is the script
};
constexpr Peer peers[] = {
    {"mpmath quad", "python3 -P -c 'import mpmath' 2>/dev/null", "mpmath_quad.py", "python3 \"$0\""},
    {"PARI intnum", "command -v gp >/dev/null", "pari_intnum.gp",
     "gp -q -f \"$0\" 3<&0 </dev/null"},
};

int honesty_of_routes(const HonestyChoice& o) {
    validation::HonestyOptions options;
    options.digits = digits_of(o.digits, most_digits_of_bounds);
    const auto points = validation::honesty_points();
    std::vector<std::pair<std::string, validation::ClaimedValues>> others;
    std::vector<std::string> skipped;
    for (const Peer& peer : peers) {
        const auto script = std::filesystem::path(o.scripts) / peer.script;
        if (!std::filesystem::exists(script)) {
            skipped.push_back(std::string(peer.name) + " is left out: there is no " +
                              script.string());
            continue;
        }
        const auto run = [&](const std::string& command, const std::string& input) {
            io::ProgramCall call = io::shell_call(command);
            call.input = input;
            call.seconds = script_seconds;
            call.said = ProgramMessages();
            return run_program(call);
        };
        if (run(peer.needs, "").exit_code != 0) {
            skipped.push_back(std::string(peer.name) + " is left out: its interpreter is not here");
            continue;
        }
        const io::ProgramRun answered =
            run("sh -c " + single_quoted(peer.run) + " " + single_quoted(script.string()),
                validation::integral_questions(points, options.digits));
        others.emplace_back(peer.name, validation::integral_answers(answered.output));
    }
    const auto rows =
        with_progress("values", options.progress, [&] { return honesty(points, others, options); });
    report::Table table = honesty_table(rows, options.digits);
    table.notes.insert(table.notes.end(), skipped.begin(), skipped.end());
    std::printf("%s", written(table, o.output).c_str());
    return 0;
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

    auto [cases, c] = add_command<CasesOptions>(
        all, code, "hard-cases",
        "values that are hard to get right, by ball and by two routes; exit 1 where they differ",
        hard_cases);
    cases.add_option("file", c.file, "the cases (TOML)")->capture_default_str();
    cases.add_option("--digits", c.digits, "digits asked for")->capture_default_str();
    add_threads_option(cases, c.threads);
    cases.add_flag("--classes", c.classes, "a row a class only");
    add_output(cases, c.output);

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

    auto [honest, h] = add_command<HonestyChoice>(
        all, code, "honesty",
        "the errors that routes claim, compared with their true errors: ours, and other "
        "libraries' used plainly",
        honesty_of_routes);
    honest.add_option("--digits", h.digits, "digits asked for")->capture_default_str();
    honest.add_option("--scripts", h.scripts, "folder of the scripts for mpmath and PARI")
        ->capture_default_str();
    add_output(honest, h.output);

    add_bounds_speed(all, code);
}

} // namespace edgeproof::cli

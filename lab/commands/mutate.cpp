// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/lab.hpp"

#include "edgeproof/cli/all_commands.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/report.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "lab/mutation/mutation_report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

namespace edgeproof::cli {
namespace {

struct MutateOptions {
    std::string ledger;
    long long digits = 30;
    long long mutants = 1000;
    std::uint64_t seed = 1;
    std::string only = "*";
    std::string out;
    std::string state;
    int threads = 0;
};

/// Lists the unchanged claims whose verdict differs from the golden file.
std::vector<std::string> false_alarms(const audit::MutationRun& run, const std::string& ledger) {
    std::vector<std::string> all;
    const auto golden = report::golden_file(ledger);
    for (const audit::ClaimResult& r : run.originals.claims) {
        if (report::has_golden_file(ledger)) {
            audit::AuditResult one;
            one.digits = run.originals.digits;
            one.claims.push_back(r);
            for (const std::string& line : report::golden_differences(one, golden, r.claim.id)) {
                all.push_back(line);
            }
        } else if (r.outcome.verdict == audit::Verdict::undecided) {
            all.push_back(r.claim.id + " is undecided as it stands");
        }
    }
    return all;
}

int mutate(MutateOptions& o) {
    o.ledger = file_or_shipped(o.ledger, shipped_ledgers);
    if (o.digits < 10 || o.digits > 1000) {
        throw InputError("--digits " + std::to_string(o.digits) + " is out of range",
                         "give a number of digits from 10 to 1000");
    }
    if (o.mutants < 1 || o.mutants > 1000000) {
        throw InputError("--mutants " + std::to_string(o.mutants) + " is out of range",
                         "give a number from 1 to 1000000");
    }
    io::check_output(o.out);
    check_state(o.state);
    const audit::Ledger ledger = audit::read_ledger(o.ledger);
    audit::MutationOptions options;
    options.audit.digits = static_cast<unsigned>(o.digits);
    options.audit.threads = o.threads;
    options.audit.only = o.only;
    options.mutants = static_cast<std::size_t>(o.mutants);
    options.seed = o.seed;
    if (!o.state.empty()) {
        const std::string of = fmt::format("edgeproof mutate, ledger {:016x}, {} digits, {}",
                                           io::fnv1a(io::read_text(o.ledger, "ledger (TOML)")),
                                           o.digits, report::program_line());
        if (std::filesystem::exists(o.state)) {
            options.known = report::parse_mutation_state(io::read_text(o.state, "state of mutants"),
                                                         o.state, of);
        }
        options.checkpoint = [&o, of](const std::vector<audit::MutantFate>& fates) {
            io::write_checkpoint(o.state, report::mutation_state(of, fates));
        };
    }
    audit::MutationRun run;
    const std::string kept = o.state.empty() ? ""
                                             : "what is done is kept in " + o.state +
                                                   "; the same command goes on from there";
    const io::KeptNote note(kept);
    try {
        run = with_progress("mutants", options.audit.progress,
                            [&] { return run_mutants(ledger, options); });
    } catch (const Interrupted&) {
        throw Interrupted(o.state.empty() ? "interrupted: nothing is written; with --state FILE a "
                                            "run keeps what is done"
                                          : "interrupted: " + kept);
    }
    if (run.fates.empty()) {
        throw InputError("no formula of the ledger is confirmed, so that there is no mutant",
                         "give a ledger with a formula that holds")
            .at(o.ledger, 0);
    }
    if (!o.out.empty()) {
        io::write_output(o.out, report::mutation_csv(run.fates));
    }
    const std::vector<std::string> alarms = false_alarms(run, o.ledger);
    std::fputs(printable_lines(report::mutation_text(run, alarms)).c_str(), stdout);
    return report::survivors(run).empty() && alarms.empty() ? 0 : 1;
}

} // namespace

void add_mutate(CLI::App& app, int& code) {
    auto [sub, o] = add_command<MutateOptions>(app, code, lab_mutate.name, lab_mutate.help, mutate);
    sub.add_option("ledger", o.ledger, "the ledger (TOML)")->required();
    sub.add_option("--mutants", o.mutants, "how many")->capture_default_str();
    sub.add_option("--seed", o.seed, "decides which")->capture_default_str();
    sub.add_option("--digits", o.digits, "digits to check to")->capture_default_str();
    sub.add_option("--only", o.only, "claims whose id matches, such as 'EQ2*'");
    sub.add_option("--out", o.out, "file for a row a mutant (CSV)");
    sub.add_option("--state", o.state,
                   "file that keeps what is done: a run that was stopped goes on from it");
    add_threads_option(sub, o.threads);
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/mutation/mutation_report.hpp"

#include "edgeproof/io/csv.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::report {
namespace {

constexpr const char* mutation_columns = "claim,kind,verdict,equivalent,named,original,mutant,note";

struct Count {
    std::size_t made = 0;
    std::size_t refuted = 0;
    std::size_t no_value = 0;
    std::size_t equivalent = 0;
    std::size_t undecided = 0;
    std::size_t surviving = 0;
    std::size_t named = 0;

    void add(const audit::MutantFate& f) {
        ++made;
        refuted += f.verdict == audit::Verdict::refuted ? 1 : 0;
        no_value += f.caught() && f.verdict != audit::Verdict::refuted ? 1 : 0;
        equivalent += !f.caught() && f.equivalent ? 1 : 0;
        undecided += f.undecided() ? 1 : 0;
        surviving += f.survives() ? 1 : 0;
        named += f.named ? 1 : 0;
    }
};

std::string row(const std::string& name, const Count& c) {
    return fmt::format(
        "{:<16}{:>6}{:>9}{:>10}{:>12}{:>11}{:>11}{:>8} ({:.0f} % of those refuted)\n", name, c.made,
        c.refuted, c.no_value, c.equivalent, c.undecided, c.surviving, c.named,
        c.refuted == 0 ? 0.0
                       : 100.0 * static_cast<double>(c.named) / static_cast<double>(c.refuted));
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return out + "\"";
}

std::string cells_of(const audit::MutantFate& f) {
    return fmt::format("{},{},{},{},{},{},{},{}", csv_cell(f.claim), quoted(f.kind),
                       name_of(f.verdict), f.equivalent ? "yes" : "no", f.named ? "yes" : "no",
                       quoted(f.original), quoted(f.mutated), quoted(f.note));
}

} // namespace

std::vector<const audit::MutantFate*> survivors(const audit::MutationRun& run) {
    std::vector<const audit::MutantFate*> all;
    for (const audit::MutantFate& f : run.fates) {
        if (f.survives()) {
            all.push_back(&f);
        }
    }
    return all;
}

std::string mutation_text(const audit::MutationRun& run,
                          const std::vector<std::string>& false_alarms) {
    std::string out = fmt::format(
        "{} mutants of {} formulas that hold, out of {} possible mutants; seed {}, {} digits\n\n",
        run.fates.size(), run.claims, run.possible, run.seed, run.originals.digits);
    out += fmt::format("{:<16}{:>6}{:>9}{:>10}{:>12}{:>11}{:>11}{:>8}\n", "kind", "made", "refuted",
                       "no value", "equivalent", "undecided", "surviving", "named");
    out += std::string(83, '-') + "\n";
    Count total;
    for (const std::string& kind : audit::mutation_kinds()) {
        Count c;
        for (const audit::MutantFate& f : run.fates) {
            if (f.kind == kind) {
                c.add(f);
                total.add(f);
            }
        }
        out += row(kind, c);
    }
    out += std::string(83, '-') + "\n" + row("all", total);
    for (const audit::MutantFate& f : run.fates) {
        if (f.survives() || f.undecided()) {
            out += fmt::format("\n{}: {} ({}), {}: {}\n  original {}\n  mutant   {}\n",
                               f.survives() ? "survives" : "undecided", f.claim, f.kind,
                               name_of(f.verdict), f.note, f.original, f.mutated);
        }
    }
    for (const std::string& line : false_alarms) {
        out += "\nfalse alarm: " + line + "\n";
    }
    out += fmt::format("\n{} survivors, {} undecided, {} false alarms\n", total.surviving,
                       total.undecided, false_alarms.size());
    return out;
}

std::string mutation_csv(const std::vector<audit::MutantFate>& fates) {
    std::string out = std::string(mutation_columns) + ",program\n";
    const std::string program = csv_text_cell(program_line());
    for (const audit::MutantFate& f : fates) {
        out += cells_of(f) + "," + program + "\n";
    }
    return out;
}

std::string mutation_state(const std::string& of, const std::vector<audit::MutantFate>& fates) {
    std::string out = "# " + of + "\n" + std::string(mutation_columns) + "\n";
    for (const audit::MutantFate& f : fates) {
        out += cells_of(f) + "\n";
    }
    return out;
}

std::vector<audit::MutantFate> parse_mutation_state(std::string_view text, const std::string& file,
                                                    const std::string& of) {
    const io::Csv csv = io::parse_csv(text, file);
    const auto reject = [&](std::size_t line, const std::string& problem) {
        throw InputError(problem, "remove the file to begin anew").at(file, line);
    };
    if (csv.notes.size() != 1 || csv.notes[0] != of) {
        reject(1, "the state is not one of \"" + of + "\"");
    }
    std::vector<audit::MutantFate> fates;
    for (const io::Csv::Row& row : csv.rows) {
        if (row.cells.size() != 8) {
            reject(row.line, "a mutant has 8 cells, not " + std::to_string(row.cells.size()));
        }
        const auto verdict = audit::find_verdict(row.cells[2]);
        if (!verdict) {
            reject(row.line, "\"" + row.cells[2] + "\" is no verdict");
        }
        audit::MutantFate f;
        f.claim = row.cells[0];
        f.kind = row.cells[1];
        f.verdict = *verdict;
        f.equivalent = row.cells[3] == "yes";
        f.named = row.cells[4] == "yes";
        f.original = row.cells[5];
        f.mutated = row.cells[6];
        f.note = row.cells[7];
        fates.push_back(std::move(f));
    }
    return fates;
}

} // namespace edgeproof::report

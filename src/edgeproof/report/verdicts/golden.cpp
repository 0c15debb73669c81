// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/verdicts/golden.hpp"

#include "edgeproof/io/csv.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <map>

namespace edgeproof::report {
namespace {

using Cells = std::vector<std::string>;

const Cells golden_head{"id", "verdict", "correct"};

std::string row(const Cells& cells) {
    std::string line;
    for (const std::string& cell : cells) {
        line += line.empty() ? "" : ",";
        add_csv_cell(line, cell);
    }
    return line;
}

/// The cells as the CSV reader returns them.
Cells cells_of(const audit::ClaimResult& r) {
    return {r.claim.id, std::string(name_of(r.outcome.verdict)),
            printable(r.outcome.correct.value_or(""))};
}

} // namespace

std::filesystem::path golden_file(const std::filesystem::path& ledger) {
    std::filesystem::path file = ledger;
    return file.replace_extension(".expected.csv");
}

std::string golden_text(const audit::AuditResult& result) {
    std::string out = row(golden_head) + '\n';
    for (const audit::ClaimResult& r : result.claims) {
        out += row(cells_of(r)) + '\n';
    }
    return out;
}

std::vector<std::string> golden_differences(const audit::AuditResult& result,
                                            const std::filesystem::path& file,
                                            const std::string& only) {
    const io::Csv csv = io::parse_csv(io::read_text(file, "recorded verdicts"), file.string());
    if (csv.header.cells != golden_head) {
        throw InputError("the first line is not '" + row(golden_head) + "'",
                         "record the verdicts anew with --record")
            .at(file.string(), csv.header.line);
    }
    std::map<std::string, Cells> expected;
    std::vector<std::string> order;
    for (const io::Csv::Row& line : csv.rows) {
        if (line.cells.size() < 2) {
            throw InputError("a row with no verdict", "write id,verdict,correct")
                .at(file.string(), line.line);
        }
        const std::string& id = line.cells.front();
        if (audit::matches(only, id)) {
            expected[id] = line.cells;
            order.push_back(id);
        }
    }
    std::vector<std::string> differences;
    std::map<std::string, bool> seen;
    for (const audit::ClaimResult& r : result.claims) {
        seen[r.claim.id] = true;
        const auto at = expected.find(r.claim.id);
        if (at == expected.end()) {
            differences.push_back(r.claim.id + ": not in the golden file; now " + row(cells_of(r)));
        } else if (at->second != cells_of(r)) {
            differences.push_back(r.claim.id + ": was " + row(at->second) + "; now " +
                                  row(cells_of(r)));
        }
    }
    for (const std::string& id : order) {
        if (!seen[id]) {
            differences.push_back(id + ": in the golden file, but no claim has this id");
        }
    }
    return differences;
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/verdicts/golden.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <fstream>
#include <map>

namespace edgeproof::report {
namespace {

constexpr const char* golden_head = "id,verdict,correct";

std::string row(const audit::ClaimResult& r) {
    return csv_cell(r.claim.id) + "," + std::string(name_of(r.outcome.verdict)) + "," +
           csv_cell(r.outcome.correct.value_or(""));
}

} // namespace

std::filesystem::path golden_file(const std::filesystem::path& ledger) {
    std::filesystem::path file = ledger;
    return file.replace_extension(".expected.csv");
}

std::string golden_text(const audit::AuditResult& result) {
    std::string out(golden_head);
    out += '\n';
    for (const audit::ClaimResult& r : result.claims) {
        out += row(r);
        out += '\n';
    }
    return out;
}

std::vector<std::string> golden_differences(const audit::AuditResult& result,
                                            const std::filesystem::path& file,
                                            const std::string& only) {
    std::ifstream in(file);
    if (!in) {
        throw InputError("cannot read " + file.string(), "give a file that can be read");
    }
    std::string line;
    if (!std::getline(in, line) || line != golden_head) {
        throw InputError("the first line is not '" + std::string(golden_head) + "'",
                         "record the verdicts anew with --record")
            .at(file.string(), 1);
    }
    std::map<std::string, std::string> expected;
    std::vector<std::string> order;
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        const std::size_t comma = line.find(',');
        if (comma == std::string::npos) {
            throw InputError("a row with no verdict", "write id,verdict,correct")
                .at(file.string(), number);
        }
        const std::string id = line.substr(0, comma);
        if (audit::matches(only, id)) {
            expected[id] = line;
            order.push_back(id);
        }
    }
    std::vector<std::string> differences;
    std::map<std::string, bool> seen;
    for (const audit::ClaimResult& r : result.claims) {
        seen[r.claim.id] = true;
        const auto at = expected.find(r.claim.id);
        if (at == expected.end()) {
            differences.push_back(r.claim.id + ": not in the golden file; now " + row(r));
        } else if (at->second != row(r)) {
            differences.push_back(r.claim.id + ": was " + at->second + "; now " + row(r));
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

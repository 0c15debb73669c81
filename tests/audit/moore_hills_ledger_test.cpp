// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/run.hpp"
#include "tests/support/namespaces.hpp"
#include "tests/support/paths.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

const Ledger& ledger() {
    static const Ledger read = read_ledger(test::source_dir() / "verify" / "moore-hills.toml");
    return read;
}

std::vector<std::string> file_lines(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// Returns the row of a claim: the part of the id before the first dot.
std::string row_of(const std::string& id) { return id.substr(0, id.find('.')); }

/// Removes white space, which has no meaning in the printed text.
std::string squeezed(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            out += c;
        }
    }
    return out;
}

} // namespace

TEST_CASE("the ledger of the paper: every id once, every claim with its TeX") {
    std::set<std::string> seen;
    for (const Claim& claim : ledger().claims) {
        CAPTURE(claim.id);
        CHECK(seen.insert(claim.id).second);
        CHECK_FALSE(claim.printed.empty());
        CHECK(claim.lines.first <= claim.lines.second);
    }
    CHECK(seen.size() >= 110);
}

TEST_CASE("every row of the list of checkable claims has a claim at lines that overlap") {
    const auto paper = test::paper_dir();
    if (!paper) {
        MESSAGE("skipped: the paper is not at hand (EDGEPROOF_PAPER)");
        return;
    }
    std::map<std::string, std::pair<std::size_t, std::size_t>> rows;
    for (const std::string& line : file_lines(*paper / "checkable.csv")) {
        std::istringstream in(line);
        std::string id;
        std::string first;
        std::string last;
        std::getline(in, id, ',');
        std::getline(in, first, ',');
        std::getline(in, last, ',');
        if (id != "id" && !id.empty()) {
            rows.emplace(id, std::pair(std::stoul(first), std::stoul(last)));
        }
    }
    REQUIRE(rows.size() == 110);
    std::set<std::string> claimed;
    for (const Claim& claim : ledger().claims) {
        CAPTURE(claim.id);
        const auto row = rows.find(row_of(claim.id));
        REQUIRE(row != rows.end());
        // The lines need only overlap: a sentence may begin before the row's lines, and a condition
        // may end after them.
        CHECK(claim.lines.first <= row->second.second);
        CHECK(claim.lines.second >= row->second.first);
        CHECK(claim.lines.second - claim.lines.first < 20);
        claimed.insert(row->first);
    }
    for (const auto& row : rows) {
        CAPTURE(row.first);
        CHECK(claimed.contains(row.first));
    }
}

TEST_CASE("the printed text is in the source, letter for letter, at the given lines") {
    const auto paper = test::paper_dir();
    if (!paper) {
        MESSAGE("skipped: the paper is not at hand (EDGEPROOF_PAPER)");
        return;
    }
    const auto source = file_lines(*paper / "moore-hills.tex");
    for (const Claim& claim : ledger().claims) {
        CAPTURE(claim.id);
        REQUIRE(claim.lines.second <= source.size());
        std::string there;
        for (std::size_t k = claim.lines.first; k <= claim.lines.second; ++k) {
            there += source[k - 1] + '\n';
        }
        CHECK(squeezed(there).find(squeezed(claim.printed)) != std::string::npos);
    }
}

TEST_CASE("the same results on one thread and on two, and at other digits the same verdicts") {
    AuditOptions options;
    options.only = "EQ3*.M";
    options.digits = 34;
    options.threads = 1;
    const AuditResult one = run_audit(ledger(), options);
    options.threads = 2;
    const AuditResult two = run_audit(ledger(), options);
    options.digits = 77;
    const AuditResult more = run_audit(ledger(), options);
    REQUIRE(one.claims.size() == two.claims.size());
    REQUIRE(one.claims.size() >= 4);
    for (std::size_t i = 0; i < one.claims.size(); ++i) {
        CAPTURE(one.claims[i].claim.id);
        CHECK(one.claims[i].outcome.verdict == two.claims[i].outcome.verdict);
        CHECK(one.claims[i].outcome.evidence == two.claims[i].outcome.evidence);
        CHECK(one.claims[i].outcome.verdict == more.claims[i].outcome.verdict);
        CHECK(one.claims[i].outcome.correct == more.claims[i].outcome.correct);
    }
}

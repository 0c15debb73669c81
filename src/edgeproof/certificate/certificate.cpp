// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/certificate/certificate.hpp"

#include "edgeproof/audit/ledger/ledger_parts.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace edgeproof::certificate {
namespace {

namespace fs = std::filesystem;
using audit::Claim;
using audit::collect_words;
using audit::Family;
using audit::Ledger;

/// Each part ends with a line feed, and parts of it are separated by tabs, so that two different
/// claims have two different texts. Fields of a ledger have neither character unescaped.
std::string line_of(const std::vector<std::string>& parts) {
    std::string line;
    for (std::string part : parts) {
        for (char& c : part) {
            c = c == '\t' || c == '\n' ? '\x1f' : c;
        }
        line += part + '\t';
    }
    return line + '\n';
}

std::string text_of(const Claim& claim) {
    std::string text = line_of({"claim", claim.id, claim.kind, claim.printed, claim.reading});
    for (const auto& [name, field] : claim.fields) {
        if (name == "remark") {
            continue;
        }
        std::vector<std::string> parts{"field", name};
        if (const auto* one = std::get_if<std::string>(&field.value)) {
            parts.push_back(*one);
        } else if (const auto* list = std::get_if<audit::Field::List>(&field.value)) {
            parts.insert(parts.end(), list->begin(), list->end());
        } else {
            for (const auto& [key, values] : std::get<audit::Field::Table>(field.value)) {
                parts.push_back(key + " =");
                parts.insert(parts.end(), values.begin(), values.end());
            }
        }
        text += line_of(parts);
    }
    for (const Claim& reading : claim.readings) {
        text += text_of(reading);
    }
    return text;
}

std::vector<std::string> texts_of(const std::vector<formula::Expr>& all) {
    std::vector<std::string> texts;
    std::ranges::transform(all, std::back_inserter(texts),
                           [](const formula::Expr& e) { return to_text(e); });
    return texts;
}

std::string text_of(const Family& family, const Ledger& ledger) {
    std::string text =
        line_of({"family", family.profile, family.axisymmetric() ? "axisymmetric" : "plane"});
    const auto add = [&](std::string name, std::vector<std::string> values) {
        values.insert(values.begin(), std::move(name));
        text += line_of(values);
    };
    for (const auto& [name, values] : family.parameters) {
        add(name, texts_of(values));
    }
    add("knots", texts_of(family.knots));
    add("slopes", texts_of(family.slopes));
    for (const std::string& member : family.union_of) {
        text += text_of(ledger.family(member), ledger);
    }
    return text;
}

/// Adds to a text the definitions whose names occur in it, and those that these use.
std::string with_definitions(std::string text, const Claim& claim) {
    std::set<std::string> words;
    std::set<std::string> added;
    collect_words(text, words);
    for (bool more = true; more;) {
        more = false;
        for (const audit::Vocabulary::Definition& d : claim.vocabulary.definitions) {
            if (words.contains(d.name) && added.insert(d.name).second) {
                const std::string line =
                    line_of({"define", d.name, d.argument.value_or(""), to_text(d.body)});
                collect_words(line, words);
                text += line;
                more = true;
            }
        }
    }
    return text;
}

struct Listed {
    std::string verdict;
    std::string file;
    std::string fields_sha256;
    bool whole = false;
    std::vector<std::string> theorems;
};

/// A CSV file of the folder, with exactly these columns.
io::Csv read_table(const fs::path& file, const std::vector<std::string>& columns) {
    io::Csv csv = io::parse_csv(io::read_text(file, "table of theorems"), file.string());
    const std::string wanted = fmt::format("{}", fmt::join(columns, ","));
    if (csv.header.cells != columns) {
        throw InputError("the first line is not '" + wanted + "'",
                         "write it with scripts/certificates")
            .at(csv.file, csv.header.line);
    }
    for (const io::Csv::Row& row : csv.rows) {
        if (row.cells.size() != columns.size()) {
            throw InputError(
                fmt::format("a row of {} cells, not {}", row.cells.size(), columns.size()),
                "write '" + wanted + "'")
                .at(csv.file, row.line);
        }
    }
    return csv;
}

/// The files of theorems by the id of their claim.
std::map<std::string, Listed> read_index(const fs::path& folder) {
    const io::Csv csv =
        read_table(folder / "index.csv", {"claim", "verdict", "file", "theorem", "states",
                                          "leaves_out", "whole", "fields_sha256"});
    std::map<std::string, Listed> all;
    for (const io::Csv::Row& row : csv.rows) {
        const std::vector<std::string>& c = row.cells;
        if (c[2].empty()) {
            continue; // the reason why the claim has no theorem
        }
        if (c[2].find('/') != std::string::npos || !c[2].ends_with(".v") ||
            (c[6] != "whole" && c[6] != "part") || c[3].empty()) {
            throw InputError("this row names no theorem of a file NAME.v in the same folder, as "
                             "whole or part",
                             "write for example EQ18,refuted,EQ18.v,EQ18_refuted,...,whole,...")
                .at(csv.file, row.line);
        }
        const Listed listed{c[1], c[2], c[7], c[6] == "whole", {}};
        Listed& known = all.emplace(c[0], listed).first->second;
        if (std::tie(known.verdict, known.file, known.fields_sha256, known.whole) !=
            std::tie(listed.verdict, listed.file, listed.fields_sha256, listed.whole)) {
            throw InputError("two rows of the claim " + c[0] + " contradict each other",
                             "write the same verdict, file, part and hash")
                .at(csv.file, row.line);
        }
        known.theorems.push_back(c[3]);
    }
    return all;
}

/// What accepted.csv records for a theorem of a file: the hashes of the file and of the
/// definitions.
using Accepted = std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>>;

Accepted read_accepted(const fs::path& folder) {
    Accepted accepted;
    if (!fs::is_regular_file(folder / "accepted.csv")) {
        return accepted;
    }
    const io::Csv csv =
        read_table(folder / "accepted.csv", {"theorem", "file", "sha256", "imports_sha256", "coq"});
    for (const io::Csv::Row& row : csv.rows) {
        if (!accepted
                 .emplace(std::pair(row.cells[1], row.cells[0]),
                          std::pair(row.cells[2], row.cells[3]))
                 .second) {
            throw InputError("the theorem " + row.cells[0] + " a second time", "keep one row")
                .at(csv.file, row.line);
        }
    }
    return accepted;
}

std::string file_sha256(const fs::path& file) {
    return fs::is_regular_file(file) ? io::sha256(io::read_text(file, "file of theorems")) : "";
}

/// The SHA-256 of what `sha256sum` prints for the definitions that all theorems may import: the
/// other files NAME.v of the folder, in the order of their names.
std::string imports_sha256(const fs::path& folder, const std::map<std::string, Listed>& index) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool claim = std::ranges::any_of(
            index, [&](const auto& listed) { return listed.second.file == name; });
        if (name.ends_with(".v") && name != "Assumptions.v" && !claim) {
            names.insert(name);
        }
    }
    std::string lines;
    for (const std::string& name : names) {
        lines += fmt::format("{}  {}\n", file_sha256(folder / name), name);
    }
    return io::sha256(lines);
}

} // namespace

std::string fields_sha256(const Claim& claim, const Ledger& ledger) {
    std::string text = text_of(claim);
    for (const Family& family : ledger.families) {
        const bool used = std::ranges::any_of(claim.fields, [&](const auto& field) {
            const auto* name = std::get_if<std::string>(&field.second.value);
            return name != nullptr && *name == family.name;
        });
        text += used ? text_of(family, ledger) : "";
    }
    return io::sha256(with_definitions(std::move(text), claim));
}

void attach_certificates(audit::AuditResult& result, const Ledger& ledger, const fs::path& folder,
                         const std::string& shown) {
    for (audit::ClaimResult& claim : result.claims) {
        claim.fields_sha256 = fields_sha256(claim.claim, ledger);
    }
    if (!fs::is_regular_file(folder / "index.csv")) {
        return;
    }
    const std::map<std::string, Listed> index = read_index(folder);
    const Accepted accepted = read_accepted(folder);
    const std::string imports = imports_sha256(folder, index);
    for (audit::ClaimResult& claim : result.claims) {
        const auto found = index.find(claim.claim.id);
        if (found == index.end()) {
            continue;
        }
        const Listed& listed = found->second;
        const std::string text = file_sha256(folder / listed.file);
        const bool recorded = std::ranges::all_of(listed.theorems, [&](const std::string& theorem) {
            const auto row = accepted.find({listed.file, theorem});
            return row != accepted.end() && row->second == std::pair(text, imports);
        });
        std::string problem;
        if (listed.fields_sha256 != claim.fields_sha256) {
            problem = "it is about another text of the claim";
        } else if (listed.verdict != name_of(claim.outcome.verdict)) {
            problem = "it is about the verdict " + listed.verdict;
        } else if (!recorded) {
            problem = "it is not recorded that Coq accepts it as it is";
        }
        claim.certificate = {(fs::path(shown) / listed.file).generic_string(), listed.whole,
                             problem.empty(), (folder / listed.file).string(), problem};
    }
}

} // namespace edgeproof::certificate

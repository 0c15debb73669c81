// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/verdicts/verdict_writers.hpp"
#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/tables/reference_table.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <set>

namespace edgeproof::report {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

Json or_null(const std::optional<std::string>& text) { return text ? Json(*text) : Json(nullptr); }
std::string or_empty(const std::optional<std::string>& text) { return text.value_or(""); }

std::optional<std::string> quoted(const audit::Claim& claim) {
    return claim.has("quoted") ? std::optional(claim.text("quoted")) : std::nullopt;
}
std::optional<std::string> certificate_of(const audit::ClaimResult& r) {
    return r.certificate && r.certificate->accepted ? std::optional(r.certificate->path)
                                                    : std::nullopt;
}
/// Returns "5-7"; nothing for a formula without a source.
std::optional<std::string> lines_of(const audit::Claim& claim) {
    const auto& [first, last] = claim.lines;
    return first == 0      ? std::nullopt
           : first == last ? std::optional(std::to_string(first))
                           : std::optional(fmt::format("{}-{}", first, last));
}

/// LaTeX text that can be broken into lines in a narrow column: after operators, brackets and
/// underscores, after the point of an id, and after every fifth digit of a long number.
std::string breakable_latex(std::string_view text) {
    constexpr std::string_view breaks_after = "*/,;=()+_^";
    constexpr std::size_t most_digits = 5;
    std::string out;
    std::string part;
    std::size_t digits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool digit = c >= '0' && c <= '9';
        digits = digit ? digits + 1 : 0;
        part += c;
        const bool exponent = c == '+' && i > 0 && text[i - 1] == 'e'; // 1e+08
        const bool point = c == '.' && i + 1 < text.size() &&
                           std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0;
        if ((breaks_after.find(c) != std::string_view::npos && !exponent) || point ||
            digits == most_digits) {
            out += latex_text(part) + "\\allowbreak{}";
            part.clear();
            digits = 0;
        }
    }
    return out + latex_text(part);
}

} // namespace

std::array<std::size_t, audit::all_verdicts.size()>
count_verdicts(const audit::AuditResult& result) {
    std::array<std::size_t, audit::all_verdicts.size()> counts{};
    for (const audit::ClaimResult& r : result.claims) {
        ++counts.at(static_cast<std::size_t>(r.outcome.verdict.verdict()));
    }
    return counts;
}

std::string counts_line(const audit::AuditResult& result) {
    const auto counts = count_verdicts(result);
    const auto rounded =
        std::count_if(result.claims.begin(), result.claims.end(),
                      [](const audit::ClaimResult& r) { return is_rounded(r.outcome); });
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) {
            text += (text.empty() ? "" : ", ") + std::to_string(counts[i]) + " " +
                    std::string(name_of(audit::all_verdicts[i]));
            if (audit::all_verdicts[i] == audit::Verdict::confirmed && rounded > 0) {
                text += " (" + std::to_string(rounded) + " of them to the printed digits)";
            }
        }
    }
    return text;
}

std::string verdicts_json(const audit::AuditResult& result) {
    Json root;
    root["ledger"] = result.ledger;
    root["digits"] = result.digits;
    root["program"] = program_line();
    Json claims = Json::array();
    for (const audit::ClaimResult& r : result.claims) {
        Json c;
        c["id"] = r.claim.id;
        c["verdict"] = name_of(r.outcome.verdict);
        c["printed"] = r.claim.printed;
        c["correct"] = or_null(r.outcome.correct);
        c["quoted"] = or_null(quoted(r.claim));
        c["computed"] = or_null(r.outcome.computed);
        c["note"] = r.outcome.note;
        c["rests_on"] = name_of(basis_of(r));
        c["certificate"] = or_null(certificate_of(r));
        c["fields_sha256"] = r.fields_sha256;
        Json evidence = Json::object();
        evidence["lines"] = or_null(lines_of(r.claim));
        evidence["kind"] = r.claim.kind;
        if (r.claim.has("says")) {
            evidence["says"] = r.claim.text("says");
            if (const std::string* typed = r.claim.typed("says")) {
                evidence["says_as_typed"] = *typed;
            }
        }
        evidence.update(r.outcome.evidence);
        c["evidence"] = std::move(evidence);
        claims.push_back(std::move(c));
    }
    root["claims"] = std::move(claims);
    if (!result.errors.empty()) {
        Json errors = Json::array();
        for (const audit::ClaimError& e : result.errors) {
            errors.push_back({{"id", e.id.empty() ? Json(nullptr) : Json(e.id)},
                              {"line", e.error.line()},
                              {"problem", e.error.problem()},
                              {"instead", e.error.instead()}});
        }
        root["errors"] = std::move(errors);
    }
    return root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string verdicts_csv(const audit::AuditResult& result) {
    std::string out = "id,lines,verdict,quoted,computed,correct,note,printed,program\n";
    for (const audit::ClaimResult& r : result.claims) {
        out += fmt::format(
            "{},{},{},{},{},{},{},{},{}\n", csv_text_cell(r.claim.id), or_empty(lines_of(r.claim)),
            name_of(r.outcome.verdict), csv_text_cell(or_empty(quoted(r.claim))),
            csv_text_cell(or_empty(r.outcome.computed)), csv_text_cell(or_empty(r.outcome.correct)),
            csv_text_cell(r.outcome.note), csv_text_cell(r.claim.printed),
            csv_text_cell(program_line()));
    }
    return out;
}

std::string verdicts_markdown(const audit::AuditResult& result) {
    std::string out = fmt::format("# {}\n\n{}\n\n{} claims at {} digits: {}.\n\nMade by {}.\n\n",
                                  markdown_text(result.ledger), markdown_text(result.source),
                                  result.claims.size(), result.digits, counts_line(result),
                                  markdown_text(program_line()));
    out +=
        "| id | lines | verdict | quoted | computed | correct | note | rests on | certificate |\n"
        "|---|---|---|---|---|---|---|---|---|\n";
    const auto code = [](const std::optional<std::string>& text) {
        return text ? markdown_code(*text) : "";
    };
    for (const audit::ClaimResult& r : result.claims) {
        out += fmt::format(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", markdown_text(r.claim.id),
            or_empty(lines_of(r.claim)), verdict_text(r), markdown_text(or_empty(quoted(r.claim))),
            markdown_text(or_empty(r.outcome.computed)), code(r.outcome.correct),
            markdown_text(r.outcome.note), name_of(basis_of(r)), code(certificate_of(r)));
    }
    return out;
}

std::string verdicts_latex(const audit::AuditResult& result) {
    // The widths and ten times \tabcolsep are at most the 345 pt of an article on A4.
    std::string out = "% " + printable(result.ledger) + ": " + counts_line(result) + "\n" +
                      "% program: " + program_line() + "\n" +
                      "% needs the packages array and longtable\n"
                      "{\\footnotesize\\setlength{\\tabcolsep}{3pt}\\begin{longtable}{";
    for (const char* width : {"0.15", "0.10", "0.17", "0.19", "0.30"}) {
        out += std::string(">{\\raggedright}p{") + width + "\\textwidth}";
    }
    out += "}\nclaim & lines & verdict & computed & note \\tabularnewline \\hline \\endhead\n";
    for (const audit::ClaimResult& r : result.claims) {
        std::string note = breakable_latex(r.outcome.note);
        if (r.outcome.correct) {
            note += (note.empty() ? "" : "; ") + std::string("correct: \\texttt{") +
                    breakable_latex(*r.outcome.correct) + "}";
        }
        out += fmt::format("{} & {} & {} & {} & {} \\tabularnewline\n", breakable_latex(r.claim.id),
                           or_empty(lines_of(r.claim)), verdict_text(r),
                           breakable_latex(or_empty(r.outcome.computed)), note);
    }
    return out + "\\end{longtable}}\n";
}

namespace {

const Cells golden_head{"id", "verdict", "correct"};

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

bool has_golden_file(const std::filesystem::path& ledger) {
    std::error_code failed;
    return std::filesystem::exists(std::filesystem::symlink_status(golden_file(ledger), failed));
}

std::string golden_text(const audit::AuditResult& result) {
    std::string out = csv_line(golden_head);
    for (const audit::ClaimResult& r : result.claims) {
        out += csv_line(cells_of(r));
    }
    return out;
}

std::vector<std::string> golden_differences(const audit::AuditResult& result,
                                            const std::filesystem::path& file,
                                            const std::string& only) {
    const io::Csv csv = io::parse_csv(io::read_text(file, "recorded verdicts"), file.string());
    if (csv.header.cells != golden_head) {
        throw InputError(fmt::format("the first line is not '{}'", fmt::join(golden_head, ",")),
                         "record the verdicts anew with --record")
            .at(file.string(), csv.header.line);
    }
    std::set<std::string> ids;
    for (const io::Csv::Row& line : csv.rows) {
        if (!ids.insert(line.cells.front()).second) {
            throw InputError("a second row of " + line.cells.front(), "keep the row that is right")
                .at(file.string(), line.line);
        }
    }
    std::vector<Cells> made;
    std::ranges::transform(result.claims, std::back_inserter(made), cells_of);
    return row_differences(csv, made,
                           [&](const std::string& id) { return audit::matches(only, id); });
}

} // namespace edgeproof::report

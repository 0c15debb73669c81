// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include "edgeproof/audit/agreement/enclosures.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/report/text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgeproof::report {
namespace {

std::string padded(const std::string& text, std::size_t width) {
    const std::size_t n = text_width(text);
    return n < width ? text + std::string(width - n, ' ') : text;
}

/// Returns lines of at most `width` columns; a longer word is divided.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    std::vector<std::string> lines;
    std::string line;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t end = text.find(' ', at);
        end = end == std::string::npos ? text.size() : end;
        std::string word = text.substr(at, end - at);
        at = end + 1;
        while (word.size() > width) {
            if (!line.empty()) {
                lines.push_back(std::move(line));
                line.clear();
            }
            lines.push_back(word.substr(0, width));
            word.erase(0, width);
        }
        if (!line.empty() && text_width(line) + 1 + text_width(word) > width) {
            lines.push_back(std::move(line));
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    if (!line.empty() || lines.empty()) {
        lines.push_back(std::move(line));
    }
    return lines;
}

const char* colour_of(audit::Verdict verdict) {
    switch (verdict) {
    case audit::Verdict::proved:
    case audit::Verdict::confirmed:
        return "\033[32m";
    case audit::Verdict::refuted:
        return "\033[31m";
    case audit::Verdict::imprecise:
    case audit::Verdict::underspecified:
    case audit::Verdict::undecided:
        return "\033[33m";
    case audit::Verdict::definition:
        break;
    }
    return "\033[2m";
}

/// The text of a row in addition to its verdict: the figure, then the note.
std::string remark(const audit::ClaimResult& r) {
    std::string text;
    if (r.outcome.computed) {
        text = (r.claim.has("quoted") ? r.claim.text("quoted") + " quoted, " : std::string()) +
               *r.outcome.computed + " computed";
    }
    if (!r.outcome.note.empty()) {
        text += (text.empty() ? "" : "; ") + r.outcome.note;
    }
    if (r.certificate) {
        text +=
            (text.empty() ? "" : "; ") +
            std::string(r.certificate->accepted ? "theorem: " : "does not count as a theorem: ") +
            r.certificate->path +
            (r.certificate->accepted ? "" : " (" + r.certificate->problem + ")");
    }
    return printable(text);
}

/// The formulas that were typed as LaTeX or without `*`, as they are read, for confirmation.
std::string readings_text(const audit::AuditResult& result) {
    std::string text;
    for (const audit::ClaimResult& r : result.claims) {
        for (const auto& [key, field] : r.claim.fields) {
            if (const std::string* typed = r.claim.typed(key)) {
                text += printable(r.claim.id) + ", " + key + "\n  typed    " + printable(*typed) +
                        "\n  read as  " + printable(r.claim.text(key)) + "\n";
            }
        }
    }
    return text.empty() ? text : "\nReadings\n--------\n" + text;
}

/// A Refutation is made of enclosures only, so that this holds for every ledger.
std::string refutations_line(const audit::AuditResult& result) {
    const bool refuted =
        std::any_of(result.claims.begin(), result.claims.end(), [](const audit::ClaimResult& r) {
            return r.outcome.verdict == audit::Verdict::refuted;
        });
    return refuted ? "all refutations rest on disjoint enclosures\n" : "";
}

/// States how many certificates do not count, for the reasons given with the claims.
std::string unaccepted_line(const audit::AuditResult& result) {
    const auto count =
        std::count_if(result.claims.begin(), result.claims.end(), [](const audit::ClaimResult& r) {
            return r.certificate && !r.certificate->accepted;
        });
    return count == 0
               ? ""
               : fmt::format("{} of the certificates do not count (docs/certificates.md)\n", count);
}

/// A row for each verdict that occurs: the number of claims, their bases (audit::Basis), and the
/// number for which a theorem proves a part.
std::string bases_table(const audit::AuditResult& result) {
    using audit::ClaimResult;
    Table table;
    table.columns = {{"verdict", Column::Kind::text}, {"claims"}};
    for (const audit::Basis basis : audit::all_bases) {
        table.columns.push_back({std::string(name_of(basis))});
    }
    table.columns.push_back({"also a theorem of part"});
    const auto row = [&](std::string_view name, const auto& counted) {
        std::vector<std::string> cells{std::string(name)};
        const auto count = [&](const auto& holds) {
            cells.push_back(std::to_string(std::ranges::count_if(
                result.claims, [&](const ClaimResult& r) { return counted(r) && holds(r); })));
        };
        count([](const ClaimResult&) { return true; });
        for (const audit::Basis basis : audit::all_bases) {
            count([&](const ClaimResult& r) { return basis_of(r) == basis; });
        }
        count([](const ClaimResult& r) {
            return r.certificate && r.certificate->accepted && !r.certificate->whole_verdict;
        });
        if (cells[1] != "0") {
            table.rows.push_back(std::move(cells));
        }
    };
    for (const audit::Verdict verdict : audit::all_verdicts) {
        row(name_of(verdict), [&](const ClaimResult& r) { return r.outcome.verdict == verdict; });
    }
    row("all", [](const ClaimResult&) { return true; });
    return aligned_lines(table, 0, false);
}

} // namespace

std::string verdicts_terminal(const audit::AuditResult& result, std::size_t width, bool colour) {
    std::size_t id_width = 2;
    std::size_t verdict_width = 14;
    for (const audit::ClaimResult& r : result.claims) {
        id_width = std::max(id_width, text_width(r.claim.id));
        verdict_width = std::max(verdict_width, verdict_text(r).size());
    }
    const std::size_t left = id_width + 2 + verdict_width + 2;
    const std::size_t rest = width > left + 30 ? width - left : 30;
    const auto paint = [&](audit::Verdict v, const std::string& text) {
        return colour ? colour_of(v) + text + "\033[0m" : text;
    };
    std::string out = padded("id", id_width) + "  " + padded("verdict", verdict_width) +
                      "  what was found\n" +
                      std::string(left + std::min<std::size_t>(rest, 60), '-') + "\n";
    for (const audit::ClaimResult& r : result.claims) {
        const std::vector<std::string> lines = wrapped(remark(r), rest);
        std::string first = padded(printable(r.claim.id), id_width) + "  " +
                            paint(r.outcome.verdict, padded(verdict_text(r), verdict_width)) +
                            (lines[0].empty() ? "" : "  " + lines[0]);
        while (!first.empty() && first.back() == ' ') {
            first.pop_back();
        }
        out += first + "\n";
        for (std::size_t k = 1; k < lines.size(); ++k) {
            out += std::string(left, ' ') + lines[k] + "\n";
        }
    }
    out += readings_text(result);
    bool any = false;
    for (const audit::ClaimResult& r : result.claims) {
        if (r.outcome.verdict != audit::Verdict::refuted) {
            continue;
        }
        if (!any) {
            out += "\nErrata\n" + std::string(6, '-') + "\n";
            any = true;
        }
        out += paint(audit::Verdict::refuted, printable(r.claim.id));
        if (r.claim.lines.first > 0) { // formulas of the user have no source
            out += " (lines " + std::to_string(r.claim.lines.first) + "-" +
                   std::to_string(r.claim.lines.second) + ")";
        }
        out += "\n";
        if (r.claim.has("says")) {
            out += "  printed  " + printable(r.claim.text("says")) + "\n";
        }
        if (r.outcome.correct) {
            out += "  correct  " + *r.outcome.correct + "\n";
        }
        if (r.outcome.computed && r.claim.has("quoted")) {
            out += "  quoted   " + r.claim.text("quoted") + "\n  computed " + *r.outcome.computed +
                   "\n";
        }
    }
    out += "\n" + std::to_string(result.claims.size()) + " claims at " +
           std::to_string(result.digits) + " digits: " + counts_line(result) + "\n";
    return out + refutations_line(result) + "\nWhat they rest on\n" + bases_table(result) +
           unaccepted_line(result);
}

} // namespace edgeproof::report

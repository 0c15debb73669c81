// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html.hpp"

#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/page/evidence_words.hpp"
#include "edgeproof/report/page/html_claim.hpp"
#include "edgeproof/report/text/html_markup.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::report {
namespace {

/// A key of the filter for a section: its index in the list, 0 if sections are not known.
std::string section_key(const audit::PrintedSource& source, const audit::Claim& claim) {
    const auto next = std::ranges::upper_bound(source.sections, claim.lines.first, {},
                                               [](const auto& section) { return section.first; });
    return "s" + std::to_string(next - source.sections.begin());
}

std::size_t count_of(const audit::AuditResult& result, audit::Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(
        result.claims, verdict, [](const audit::ClaimResult& r) { return r.outcome.verdict; }));
}

std::string_view meaning(audit::Verdict verdict) {
    switch (verdict) {
    case audit::Verdict::proved:
        return "symbolic identity: printed minus derived is zero";
    case audit::Verdict::confirmed:
        return "agrees to the digits needed at every sample, or rounds to what is quoted";
    case audit::Verdict::imprecise:
        return "off by one unit in the last quoted place, or true under one reading only";
    case audit::Verdict::refuted:
        return "different: by disjoint enclosures, or by estimates where the evidence states so";
    case audit::Verdict::underspecified:
        return "cannot be evaluated as printed";
    case audit::Verdict::undecided:
        return "the evidence at the budget given does not decide";
    case audit::Verdict::definition:
        return "nothing to check";
    }
    return "";
}

std::string summary(const audit::AuditResult& result) {
    std::string out = "<table class=\"counts\"><thead><tr><th scope=\"col\">Verdict</th>"
                      "<th scope=\"col\" class=\"number\">Claims</th>"
                      "<th scope=\"col\">Means</th></tr></thead><tbody>\n";
    for (const audit::Verdict verdict : audit::all_verdicts) {
        const std::string name(name_of(verdict));
        out += "<tr><th scope=\"row\"><a href=\"#verdict=" + name + "\">" + verdict_mark(verdict) +
               "</a></th><td class=\"number\">" + std::to_string(count_of(result, verdict)) +
               "</td><td>" + std::string(meaning(verdict)) + "</td></tr>\n";
    }
    return out + "<tr><th scope=\"row\">all</th><td class=\"number\">" +
           std::to_string(result.claims.size()) + "</td><td>checked to " +
           std::to_string(result.digits) + " digits</td></tr>\n</tbody></table>\n";
}

std::string fact(const char* name, const std::string& value) {
    return value.empty() ? "" : std::string("<dt>") + name + "</dt><dd>" + value + "</dd>\n";
}

std::string facts(const audit::AuditResult& result, const PageHead& head) {
    const audit::PrintedSource& source = head.source;
    std::string libraries;
    for (const auto& [name, version] : library_versions()) {
        libraries += (libraries.empty() ? "" : ", ") + name + ' ' + version;
    }
    std::string paper = escape_html(result.source);
    if (!source.doi.empty()) {
        const std::string doi = escape_html(source.doi);
        paper += "; <a href=\"https://doi.org/" + doi + "\">doi:" + doi + "</a>";
    }
    if (!source.arxiv.empty()) {
        const std::string arxiv = escape_html(source.arxiv);
        paper += "; <a href=\"https://arxiv.org/abs/" + arxiv + "\">arXiv:" + arxiv + "</a>";
    }
    return "<dl class=\"facts\">\n" + fact("Paper", paper) +
           fact("Version read", escape_html(source.version)) +
           fact("Ledger",
                escape_html(head.ledger_file) +
                    (head.ledger_sha256.empty() ? ""
                                                : " <span class=\"soft\">SHA-256</span> <code>" +
                                                      head.ledger_sha256 + "</code>")) +
           fact("Program", "Edgeproof " + escape_html(program_version) +
                               (program_commit.empty()
                                    ? ""
                                    : ", commit <code>" + escape_html(program_commit) + "</code>") +
                               " (" + escape_html(libraries) + ")") +
           fact("Made", escape_html(head.date)) +
           fact("Command",
                head.command.empty() ? "" : "<code>" + escape_html(head.command) + "</code>") +
           fact("To cite", "Edgeproof " + escape_html(program_version) + ", report on: " +
                               escape_html(result.source) + ". " + escape_html(head.date) +
                               ". CITATION.cff of the program has the entry.") +
           "</dl>\n";
}

std::string errata_list(const std::vector<Erratum>& errata, const audit::AuditResult& result,
                        const PageFigures& figures, const PageHead& head) {
    std::string out;
    for (const Erratum& erratum : errata) {
        out += erratum_html(erratum, result, head, figures);
    }
    return out.empty() ? "<p>No claim is refuted.</p>\n" : out;
}

std::string doubtful(const audit::AuditResult& result, const PageHead& head) {
    std::string rows;
    for (const audit::ClaimResult& r : result.claims) {
        if (!holds(r.outcome.verdict) && r.outcome.verdict != audit::Verdict::refuted) {
            rows += "<tr><th scope=\"row\"><a href=\"#" + escape_html(r.claim.id) + "\">" +
                    escape_html(place_words(r.claim, head.source)) + "</a></th><td>" +
                    verdict_mark(r.outcome.verdict) + "</td><td><div class=\"said\">" +
                    printed_html(r.claim, head.source) + "</div></td><td>" +
                    note_html(r.outcome.note, r.claim, head.source) + "</td></tr>\n";
        }
    }
    if (rows.empty()) {
        return "<p>None.</p>\n";
    }
    return "<table class=\"stack doubtful\"><thead><tr><th scope=\"col\">Place</th><th "
           "scope=\"col\">Verdict</th><th scope=\"col\">Printed</th><th scope=\"col\">Found</th>"
           "</tr></thead><tbody>\n" +
           rows + "</tbody></table>\n";
}

std::string figure_html(const DrawnFigure& figure) {
    std::string out = "<figure id=\"" + escape_html(figure.id) + "\">\n<h3>" +
                      escape_html(figure.title) + "</h3>\n<div class=\"panels\">\n";
    for (const DrawnFigure::Panel& panel : figure.panels) {
        const std::string id = escape_html(panel.id);
        out +=
            "<div class=\"panel\">" +
            (panel.svg.empty() ? "<p>" + escape_html(panel.title) + "</p>" : panel.svg) +
            "<p class=\"data\"><a href=\"figures/" + id +
            ".csv\">Data (CSV)</a><span class=\"soft\"> in the folder figures</span></p></div>\n";
    }
    out += "</div>\n<figcaption>" + escape_html(figure.caption) + "</figcaption>\n";
    if (!figure.problem.empty()) {
        out += "<p class=\"missing\">" + escape_html(figure.problem) + "</p>\n";
    }
    return out + "</figure>\n";
}

std::string figures_html(const std::vector<DrawnFigure>& figures, const std::string& missing) {
    std::string out =
        missing.empty() ? "" : "<p class=\"missing\">" + escape_html(missing) + "</p>\n";
    for (const DrawnFigure& figure : figures) {
        out += figure_html(figure);
    }
    return out.empty() ? "<p>No figures are defined for this ledger.</p>\n" : out;
}

std::string option(const std::string& value, const std::string& text) {
    return "<option value=\"" + value + "\">" + escape_html(text) + "</option>\n";
}

} // namespace

std::string html_page(const audit::AuditResult& result, const PageFigures& figures,
                      const PageHead& head) {
    std::string claims;
    std::string verdict_options;
    std::string section_options;
    std::set<std::string> used;
    for (const audit::ClaimResult& r : result.claims) {
        const std::string key = section_key(head.source, r.claim);
        used.insert(key);
        claims += claim_html(r, head, key);
    }
    for (const audit::Verdict verdict : audit::all_verdicts) {
        if (count_of(result, verdict) > 0) {
            verdict_options += option(std::string(name_of(verdict)), std::string(name_of(verdict)));
        }
    }
    for (std::size_t i = 0; i < head.source.sections.size(); ++i) {
        if (const std::string key = "s" + std::to_string(i + 1); used.contains(key)) {
            section_options += option(key, head.source.sections[i].second);
        }
    }
    const std::vector<Erratum> errata = errata_of(result, head.source);
    return fill_template(
        report_template::page_html,
        {{"title", "Report: " + escape_html(result.ledger)},
         {"source", escape_html(result.source)},
         {"css", std::string(report_template::page_css)},
         {"js", std::string(report_template::page_js)},
         {"facts", facts(result, head)},
         {"count", escape_html(errata_count(errata))},
         {"digits", std::to_string(result.digits)},
         {"summary", summary(result)},
         {"errata", errata_list(errata, result, figures, head)},
         {"doubtful", doubtful(result, head)},
         {"figures", figures_html(figures.paper, figures.missing)},
         {"residuals", figures_html(figures.residuals, figures.missing)},
         {"claims", claims},
         {"verdict_options", verdict_options},
         {"section_options", section_options},
         {"footer", "Made by edgeproof verify at " + std::to_string(result.digits) +
                        " digits: " + escape_html(program_line()) +
                        ". The page needs no network; the data of the figures are in the folder "
                        "figures next to it."}});
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html.hpp"

#include "edgeproof/report/figures/figures_paper.hpp"
#include "edgeproof/report/page/html_claim.hpp"
#include "edgeproof/report/text/html_markup.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <algorithm>
#include <set>

namespace edgeproof::report {
namespace {

/// Where in the paper a line is.
class Sections {
public:
    explicit Sections(const std::string& ledger) : list_(paper_sections(ledger)) {}
    /// Index + 1 of the section; 0 if the paper's sections are not known.
    [[nodiscard]] std::size_t of(std::size_t line) const {
        const auto next = std::ranges::upper_bound(
            list_, line, {}, [](const auto& section) { return section.first; });
        return static_cast<std::size_t>(next - list_.begin());
    }
    [[nodiscard]] std::string title(std::size_t index) const {
        return index == 0 ? "" : list_[index - 1].second;
    }
    static std::string key(std::size_t index) { return "s" + std::to_string(index); }

private:
    std::vector<std::pair<std::size_t, std::string>> list_;
};

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
        return "different: by disjoint enclosures, or by estimates where the evidence says so";
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

std::string errata(const audit::AuditResult& result, const PageFigures& figures,
                   const Sections& sections) {
    std::string out;
    for (const audit::ClaimResult& r : result.claims) {
        if (r.outcome.verdict == audit::Verdict::refuted) {
            const auto plot = figures.errata.find(r.claim.id);
            out += erratum_html(r, sections.title(sections.of(r.claim.lines.first)),
                                plot == figures.errata.end() ? nullptr : &plot->second);
        }
    }
    return out.empty() ? "<p>No claim is refuted.</p>\n" : out;
}

std::string doubtful(const audit::AuditResult& result) {
    std::string rows;
    for (const audit::ClaimResult& r : result.claims) {
        if (!holds(r.outcome.verdict) && r.outcome.verdict != audit::Verdict::refuted) {
            const std::string id = escape_html(r.claim.id);
            rows.append("<tr><th scope=\"row\"><a href=\"#")
                .append(id)
                .append("\">")
                .append(id)
                .append("</a></th><td>")
                .append(verdict_mark(r.outcome.verdict))
                .append("</td><td>")
                .append(lines_words(r.claim))
                .append("</td><td>")
                .append(escape_html(r.outcome.note))
                .append("</td></tr>\n");
        }
    }
    if (rows.empty()) {
        return "<p>None.</p>\n";
    }
    return "<table class=\"stack\"><thead><tr><th scope=\"col\">Claim</th><th scope=\"col\">Verdict"
           "</th><th scope=\"col\">Source</th><th scope=\"col\">Note</th></tr></thead><tbody>\n" +
           rows + "</tbody></table>\n";
}

std::string figure_html(const DrawnFigure& figure) {
    std::string out = "<figure id=\"" + escape_html(figure.id) + "\">\n<h3>" +
                      escape_html(figure.title) + "</h3>\n<div class=\"panels\">\n";
    for (const DrawnFigure::Panel& panel : figure.panels) {
        const std::string id = escape_html(panel.id);
        out += "<div class=\"panel\">" +
               (panel.svg.empty() ? "<p>" + escape_html(panel.title) + "</p>" : panel.svg) +
               "<p class=\"data\"><a href=\"figures/" + id +
               ".csv\">Data (CSV)</a><span class=\"soft\"> beside this page</span></p></div>\n";
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
    return out.empty() ? "<p>None are known for this ledger.</p>\n" : out;
}

std::string option(const std::string& value, const std::string& text) {
    return "<option value=\"" + value + "\">" + escape_html(text) + "</option>\n";
}

} // namespace

std::string html_page(const audit::AuditResult& result, const PageFigures& figures) {
    const Sections sections(result.ledger);
    std::string claims;
    std::string verdict_options;
    std::string section_options;
    std::set<std::size_t> used;
    for (const audit::ClaimResult& r : result.claims) {
        const std::size_t section = sections.of(r.claim.lines.first);
        used.insert(section);
        claims += claim_html(r, sections.title(section), Sections::key(section));
    }
    for (const audit::Verdict verdict : audit::all_verdicts) {
        if (count_of(result, verdict) > 0) {
            verdict_options += option(std::string(name_of(verdict)), std::string(name_of(verdict)));
        }
    }
    for (const std::size_t section : used) {
        if (section > 0) {
            section_options += option(Sections::key(section), sections.title(section));
        }
    }
    return fill_template(
        report_template::page_html,
        {{"title", "Edgeproof: " + escape_html(result.ledger)},
         {"source", escape_html(result.source)},
         {"css", std::string(report_template::page_css)},
         {"js", std::string(report_template::page_js)},
         {"summary", summary(result)},
         {"errata", errata(result, figures, sections)},
         {"doubtful", doubtful(result)},
         {"figures", figures_html(figures.paper, figures.missing)},
         {"residuals", figures_html(figures.residuals, figures.missing)},
         {"claims", claims},
         {"verdict_options", verdict_options},
         {"section_options", section_options},
         {"footer", "Made by edgeproof verify at " + std::to_string(result.digits) +
                        " digits: " + escape_html(program_line()) +
                        ". The page needs no network; the figures' data stand in the folder "
                        "figures beside it."}});
}

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/figures/audit_figures.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <mutex>
#include <optional>
#include <sstream>
#include <utility>

namespace edgeproof::report {
namespace {

/// In the order of audit::all_verdicts.
constexpr std::array<const char*, audit::all_verdicts.size()> meanings{
    "symbolic identity: printed minus derived is zero",
    "the enclosures agree to the required digits, or round to the quoted figure",
    "differs by one unit of the last quoted digit, or is true in one reading only",
    "different: the enclosures are disjoint",
    "cannot be evaluated as printed",
    "the enclosures do not decide",
    "there is nothing to check"};

std::string summary(const audit::AuditResult& result) {
    std::string out = "<table class=\"counts\"><thead><tr><th scope=\"col\">Verdict</th>"
                      "<th scope=\"col\" class=\"number\">Claims</th>"
                      "<th scope=\"col\">Means</th></tr></thead><tbody>\n";
    const auto counts = count_verdicts(result);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const audit::Verdict verdict = audit::all_verdicts[i];
        out += fmt::format("<tr><th scope=\"row\"><a href=\"#verdict={}\">{}</a></th>"
                           "<td class=\"number\">{}</td><td>{}</td></tr>\n",
                           name_of(verdict), verdict_mark(verdict), counts[i], meanings[i]);
    }
    return out + "<tr><th scope=\"row\">all</th><td class=\"number\">" +
           std::to_string(result.claims.size()) + "</td><td>checked to " +
           std::to_string(result.digits) + " digits</td></tr>\n</tbody></table>\n";
}

/// Explains why the number of errors and the number of refuted claims differ.
std::string errors_and_claims(const std::vector<Erratum>& errata) {
    std::size_t claims = 0;
    for (const Erratum& erratum : errata) {
        claims += erratum.parts.size();
    }
    if (claims == errata.size()) {
        return "";
    }
    return fmt::format(" {} claims are refuted: claims about the same place count as one error.",
                       claims);
}

std::string fact(const char* name, const std::string& value) {
    return value.empty() ? "" : std::string("<dt>") + name + "</dt><dd>" + value + "</dd>\n";
}

std::string facts(const audit::AuditResult& result, const PageHead& head) {
    const audit::PrintedSource& source = head.source;
    std::string paper = escape_html(result.source);
    const auto link = [&](const char* kind, const char* server, const std::string& id) {
        paper += id.empty() ? ""
                            : fmt::format("; <a href=\"https://{}/{}\">{}:{}</a>", server,
                                          escape_html(id), kind, escape_html(id));
    };
    link("doi", "doi.org", source.doi);
    link("arXiv", "arxiv.org/abs", source.arxiv);
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
                               " (" + escape_html(libraries_text()) + ")") +
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

/// The figures of the paper, or of residuals.
std::string own_figures_html(const std::vector<DrawnFigure>& figures) {
    const std::string out = figures_html(figures);
    return out.empty() ? "<p>No figures are defined for this ledger.</p>\n" : out;
}

} // namespace

std::string figures_html(const std::vector<DrawnFigure>& figures) {
    std::string out;
    for (const DrawnFigure& figure : figures) {
        out += figure_html(figure);
    }
    return out;
}

DrawnFigure::Panel drawn_panel(const Plot& plot, const std::string& svg,
                               const std::filesystem::path& folder) {
    write_plot_files(plot, svg, folder);
    return {plot.id, plot.title, svg.empty() ? "" : inline_svg(svg, plot)};
}

std::string html_page(const audit::AuditResult& result, const PageFigures& figures,
                      const PageHead& head) {
    std::string claims;
    for (const audit::ClaimResult& r : result.claims) {
        claims += claim_html(r, head);
    }
    const std::vector<Erratum> errata = errata_of(result, head.source);
    return fill_template(
        report_template::page_html,
        {{"title", "Report: " + escape_html(result.ledger)},
         {"source", escape_html(result.source)},
         {"css", std::string(report_template::page_css)},
         {"js", std::string(report_template::page_js)},
         {"facts", facts(result, head)},
         {"count", escape_html(errata_count(errata) + errors_and_claims(errata))},
         {"digits", std::to_string(result.digits)},
         {"summary", summary(result)},
         {"errata", errata_list(errata, result, figures, head)},
         {"doubtful", doubtful(result, head)},
         {"figures", own_figures_html(figures.printed)},
         {"residuals", own_figures_html(figures.residuals)},
         {"claims", claims},
         {"footer", "Made by edgeproof verify at " + std::to_string(result.digits) +
                        " digits: " + escape_html(program_line()) +
                        ". The page needs no network; the data of the figures are in the folder "
                        "figures next to it."}});
}

namespace {

/// Draws the figures in `threads` threads, and writes their files to the folder.
std::vector<DrawnFigure> drawn(const std::vector<FigureRecipe>& recipes,
                               const std::filesystem::path& folder, int threads) {
    struct Job {
        std::size_t figure;
        const std::function<std::optional<Plot>()>* make;
        std::optional<Plot> plot = {};
        std::string svg = {};
    };
    std::vector<DrawnFigure> figures;
    std::vector<Job> jobs;
    for (const FigureRecipe& recipe : recipes) {
        for (const auto& make : recipe.plots) {
            jobs.push_back({figures.size(), &make});
        }
        figures.push_back({recipe.id, recipe.title, recipe.caption, {}, {}});
    }
    std::mutex problems;
    parallel::parallel_for(
        jobs.size(), static_cast<unsigned>(std::max(threads, 0)), [&](std::size_t i) {
            check_interruption();
            Job& job = jobs[i];
            try {
                job.plot = (*job.make)();
                job.svg = job.plot ? draw_svg({*job.plot}) : "";
            } catch (const std::exception& e) { // an error in one figure does not affect the others
                const std::lock_guard lock(problems);
                figures[job.figure].problem = e.what();
            }
        });
    for (const Job& job : jobs) {
        if (job.plot) {
            figures[job.figure].panels.push_back(drawn_panel(*job.plot, job.svg, folder));
        }
    }
    return figures;
}

/// Today, or the day of SOURCE_DATE_EPOCH (reproducible-builds.org), in universal time.
std::string date_text() {
    const char* set = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t now = set == nullptr
                                ? std::time(nullptr)
                                : static_cast<std::time_t>(std::strtoll(set, nullptr, 10));
    std::tm day{};
    gmtime_r(&now, &day);
    return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

/// The words with which the parts of a file for Coq begin that state what is proved.
constexpr std::array stating_words{"Definition ", "Record ",     "Section ", "End ",    "Variable ",
                                   "Variables ",  "Hypothesis ", "Let ",     "Theorem "};

PageHead head_of(const audit::AuditResult& result, const audit::Ledger& ledger,
                 const std::string& command) {
    PageHead head;
    const std::filesystem::path file = ledger.file;
    head.source = ledger.print;
    head.ledger_file = file.filename().string();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) {
        head.ledger_sha256 = io::sha256(io::read_text(file, "ledger (TOML)", io::most_toml_bytes));
    }
    head.command = command;
    head.date = date_text();
    for (const audit::ClaimResult& r : result.claims) {
        if (r.certificate && r.certificate->accepted) {
            const std::string text = io::read_text(r.certificate->file, "certificate");
            head.theorems.emplace(r.claim.id, PageTheorem{r.certificate->path, io::sha256(text),
                                                          theorem_statements(text)});
        }
    }
    return head;
}

} // namespace

std::string theorem_statements(std::string_view file) {
    std::string out;
    std::string part;
    bool in_proof = false;
    std::istringstream lines{std::string(file)};
    for (std::string line; std::getline(lines, line);) {
        if (in_proof || (part.empty() && line.starts_with("Proof"))) {
            in_proof = line.find("Qed.") == std::string::npos &&
                       line.find("Defined.") == std::string::npos;
            continue;
        }
        const bool begins = part.empty() && std::ranges::any_of(stating_words, [&](auto word) {
                                return line.starts_with(word);
                            });
        if (begins || !part.empty()) {
            part += line + '\n';
        }
        if (!part.empty() && line.ends_with('.')) {
            out += std::exchange(part, "");
        }
    }
    return out;
}

void write_html_report(const audit::AuditResult& result, const audit::Ledger& ledger,
                       const FiguresOfSource& figures, const std::filesystem::path& folder,
                       int threads, const std::string& command) {
    const std::filesystem::path figures_folder = folder / "figures";
    io::make_folder(figures_folder);
    std::vector<FigureRecipe> errata;
    for (const audit::ClaimResult& r : result.claims) {
        if (r.outcome.verdict == audit::Verdict::refuted) {
            errata.push_back(
                {r.claim.id, "", "", {[&r, &ledger] { return erratum_plot(r, ledger); }}});
        }
    }
    const PageFigures page{drawn(figures.printed, figures_folder, threads),
                           drawn(figures.residuals, figures_folder, threads),
                           drawn(errata, figures_folder, threads)};
    io::write_whole(folder / "errata.tex", errata_tex(result, ledger.print));
    io::write_whole(folder / "report.html",
                    html_page(result, page, head_of(result, ledger, command)));
}

} // namespace edgeproof::report

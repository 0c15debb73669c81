// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/parallel/parallel_for.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/figures/audit_figures.hpp"
#include "edgeproof/report/text/filled_template.hpp"
#include "edgeproof/report/text/program_line.hpp"
#include "edgeproof/report/verdicts/verdict_writers.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <mutex>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace edgeproof::report {
namespace {

using Json = nlohmann::ordered_json;

/// In the order of audit::all_verdicts.
constexpr std::array<const char*, audit::all_verdicts.size()> meanings{
    "symbolic identity: printed minus derived is zero",
    "the enclosures agree to the required digits, or round to the quoted figure",
    "differs by one unit of the last quoted digit, or is true in one reading only",
    "different: the enclosures are disjoint",
    "cannot be evaluated as printed",
    "the enclosures do not decide",
    "there is nothing to check"};

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

} // namespace

std::string figures_html(const Json& figures) {
    return filled(report_template::figures_html, {{"figures", figures}});
}

Json drawn_panel(const Plot& plot, const std::string& svg, const std::filesystem::path& folder) {
    write_plot_files(plot, svg, folder);
    return {{"id", plot.id.text()},
            {"title", plot.title},
            {"svg", svg.empty() ? "" : inline_svg(svg, plot)}};
}

std::string html_page(const audit::AuditResult& result, const PageFigures& figures,
                      const PageHead& head) {
    const audit::PrintedSource& source = head.source;
    Json links = Json::array();
    for (const auto& [kind, server, id] :
         {std::tuple{"doi", "doi.org", &source.doi}, {"arXiv", "arxiv.org/abs", &source.arxiv}}) {
        if (!id->empty()) {
            links.push_back({{"kind", kind}, {"server", server}, {"id", *id}});
        }
    }
    Json counts = Json::array();
    const auto numbers = count_verdicts(result);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        counts.push_back({{"verdict", name_of(audit::all_verdicts.at(i))},
                          {"count", numbers.at(i)},
                          {"means", meanings.at(i)}});
    }
    const std::vector<Erratum> errata = errata_of(result, source);
    Json errata_list = Json::array();
    for (const Erratum& erratum : errata) {
        errata_list.push_back(erratum_values(erratum, result, head, figures));
    }
    Json claims = Json::array();
    Json doubtful = Json::array();
    for (const audit::ClaimResult& r : result.claims) {
        claims.push_back(claim_values(r, head));
        if (!holds(r.outcome.verdict) && r.outcome.verdict != audit::Verdict::refuted) {
            doubtful.push_back(claims.back());
        }
    }
    return filled(report_template::page_html,
                  {{"ledger", result.ledger},
                   {"source", result.source},
                   {"css", report_template::page_css},
                   {"js", report_template::page_js},
                   {"links", links},
                   {"version", source.version},
                   {"ledger_file", head.ledger_file},
                   {"ledger_sha256", head.ledger_sha256},
                   {"program_version", program_version},
                   {"commit", program_commit},
                   {"libraries", libraries_text()},
                   {"date", head.date},
                   {"command", head.command},
                   {"count", errata_count(errata) + errors_and_claims(errata)},
                   {"digits", result.digits},
                   {"counts", counts},
                   {"number", result.claims.size()},
                   {"errata", errata_list},
                   {"doubtful", doubtful.empty() ? Json() : Json{{"rows", doubtful}}},
                   {"figures", figures_html(figures.printed)},
                   {"residuals", figures_html(figures.residuals)},
                   {"claims", claims},
                   {"program", program_line()}});
}

namespace {

/// Draws the figures in `threads` threads, and writes their files to the folder.
Json drawn(const std::vector<FigureRecipe>& recipes, const std::filesystem::path& folder,
           int threads) {
    struct Job {
        std::size_t figure;
        const std::function<std::optional<Plot>()>* make;
        std::optional<Plot> plot = {};
        std::string svg = {};
    };
    Json figures = Json::array();
    std::vector<Job> jobs;
    for (const FigureRecipe& recipe : recipes) {
        for (const auto& make : recipe.plots) {
            jobs.push_back({figures.size(), &make});
        }
        figures.push_back({{"id", recipe.id},
                           {"title", recipe.title},
                           {"caption", recipe.caption},
                           {"panels", Json::array()},
                           {"problem", ""}});
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
                figures[job.figure]["problem"] = e.what();
            }
        });
    for (const Job& job : jobs) {
        if (job.plot) {
            figures[job.figure]["panels"].push_back(drawn_panel(*job.plot, job.svg, folder));
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
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
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

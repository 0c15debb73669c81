// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/html_report.hpp"

#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/sha256.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_limits.hpp"
#include "edgeproof/precision/interruption.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"
#include "edgeproof/report/figures/figures_residual.hpp"
#include "edgeproof/report/page/errata.hpp"
#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/text/html_markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <thread>

namespace edgeproof::report {
namespace {

struct Job {
    std::function<std::optional<Plot>()> make;
    std::optional<Plot> plot;
    std::string svg; ///< as written by gnuplot
    std::string problem;
};

void run_job(Job& job, const std::optional<std::filesystem::path>& gnuplot) {
    try {
        job.plot = job.make();
        if (job.plot && gnuplot) {
            job.svg = draw_svg(*job.plot, *gnuplot);
        }
    } catch (const std::exception& e) { // an error in one figure does not affect the others
        job.problem = e.what();
    }
}

void run_all(std::vector<Job>& jobs, int threads,
             const std::optional<std::filesystem::path>& gnuplot) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < jobs.size(); i = next++) {
                check_interruption();
                run_job(jobs[i], gnuplot);
            }
        } catch (const Interrupted&) { // thrown below, when no thread is running
            next = jobs.size();
        }
    };
    const unsigned wanted =
        threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
    {
        std::vector<std::jthread> pool;
        for (unsigned i = 1; i < std::max(1U, wanted); ++i) {
            pool.emplace_back(work);
        }
        work();
    }
    check_interruption();
}

DrawnFigure::Panel panel_of(const Job& job, const std::filesystem::path& folder) {
    const Plot& plot = *job.plot;
    write_plot_files(plot, job.svg, folder);
    return {plot.id.text(), plot.title, job.svg.empty() ? "" : inline_svg(job.svg, plot)};
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

PageHead head_of(const audit::AuditResult& result, const audit::Ledger& ledger,
                 const std::filesystem::path& home, const std::string& command) {
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
        if (r.certificate) {
            head.certificates.emplace(
                r.claim.id, std::filesystem::proximate(r.certificate->file, home).generic_string());
        }
    }
    return head;
}

} // namespace

void write_html_report(const audit::AuditResult& result, const audit::Ledger& ledger,
                       const std::filesystem::path& folder, int threads, const std::string& command,
                       const std::filesystem::path& home) {
    const std::filesystem::path figures_folder = folder / "figures";
    io::make_folder(figures_folder);
    const auto gnuplot = find_gnuplot();

    const auto paper = paper_figures(result.ledger);
    const auto residuals = residual_figures(result.ledger);
    std::vector<Job> jobs;
    for (const auto* recipes : {&paper, &residuals}) {
        for (const FigureRecipe& recipe : *recipes) {
            for (const auto& make : recipe.plots) {
                jobs.push_back({make, {}, {}, {}});
            }
        }
    }
    const std::size_t first_erratum = jobs.size();
    std::vector<const audit::ClaimResult*> refuted;
    for (const audit::ClaimResult& r : result.claims) {
        if (r.outcome.verdict == audit::Verdict::refuted) {
            refuted.push_back(&r);
            jobs.push_back({[&r, &ledger] { return erratum_plot(r, ledger); }, {}, {}, {}});
        }
    }
    run_all(jobs, threads, gnuplot);

    PageFigures page;
    if (!gnuplot) {
        page.missing = "gnuplot was not found, so nothing is drawn here; the data of the figures "
                       "are in the folder figures. With gnuplot installed the next run draws them.";
    }
    std::size_t at = 0;
    const auto collect = [&](const std::vector<FigureRecipe>& recipes,
                             std::vector<DrawnFigure>& figures) {
        for (const FigureRecipe& recipe : recipes) {
            DrawnFigure figure{recipe.id, recipe.title, recipe.caption, {}, {}};
            for (std::size_t i = 0; i < recipe.plots.size(); ++i, ++at) {
                if (!jobs[at].problem.empty()) {
                    figure.problem = jobs[at].problem;
                }
                if (jobs[at].plot) {
                    figure.panels.push_back(panel_of(jobs[at], figures_folder));
                }
            }
            figures.push_back(std::move(figure));
        }
    };
    collect(paper, page.paper);
    collect(residuals, page.residuals);
    for (std::size_t i = 0; i < refuted.size(); ++i) {
        if (const Job& job = jobs[first_erratum + i]; job.plot) {
            page.errata.emplace(refuted[i]->claim.id, panel_of(job, figures_folder));
        }
    }
    io::write_whole(folder / "errata.tex", errata_tex(result, ledger.print));
    io::write_whole(
        folder / "report.html",
        html_page(result, page, head_of(result, ledger, home.empty() ? folder : home, command)));
}

} // namespace edgeproof::report

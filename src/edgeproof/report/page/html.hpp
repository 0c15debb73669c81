// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/figures/audit_figures.hpp"
#include "edgeproof/report/page/errata.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// A figure of the page, drawn or not.
struct DrawnFigure {
    struct Panel {
        std::string id;
        std::string title;
        std::string svg; ///< to be included in the page; empty: it was not drawn
    };
    std::string id;
    std::string title;
    std::string caption;
    std::vector<Panel> panels;
    std::string problem; ///< the error, if there was one
};

/// Writes the files of a plot to the folder (write_plot_files), and returns its panel.
[[nodiscard]] DrawnFigure::Panel drawn_panel(const Plot& plot, const std::string& svg,
                                             const std::filesystem::path& folder);
/// Returns the figures as HTML, with links to their data in the folder figures.
[[nodiscard]] std::string figures_html(const std::vector<DrawnFigure>& figures);

struct PageFigures {
    std::vector<DrawnFigure> printed;
    std::vector<DrawnFigure> residuals;
    std::vector<DrawnFigure> errata; ///< with the claims' ids, and one panel or none
};

/// A claim's theorems for Coq, as shown on the page.
struct PageTheorem {
    std::string path;       ///< of the file, as shown: "certificates/EQ09_M.v"
    std::string sha256;     ///< of the file
    std::string statements; ///< definitions and theorems without their proofs
};

/// Returns the definitions and the theorems of a file for Coq, without proofs, lemmas and tactics.
[[nodiscard]] std::string theorem_statements(std::string_view file);

/// The data in the head of the page, in addition to the results.
struct PageHead {
    audit::PrintedSource source;
    std::string ledger_file;
    std::string ledger_sha256;
    std::string command; ///< the command that makes the page again
    std::string date;    ///< for example 2026-11-23
    std::map<std::string, PageTheorem, std::less<>> theorems; ///< by the claim's id
};

/// Returns report.html, a self-contained file. Every claim is an element with the claim's id, so
/// that `report.html#EQ09.M` is a permanent link; all ids are unique. Identical in every byte for
/// the same input.
[[nodiscard]] std::string html_page(const audit::AuditResult& result, const PageFigures& figures,
                                    const PageHead& head = {});

/// Writes folder/report.html, folder/errata.tex, and folder/figures/*.csv and *.svg (the recomputed
/// figures of the paper, the residual fits, a plot for each refuted coefficient); each file is
/// either complete or absent. Figures are computed and drawn in `threads` threads (0: as many as
/// the machine has) with the same result. `command` is the command named on the page; the date is
/// that of SOURCE_DATE_EPOCH if this is set. Throws InputError if the folder is not writable.
void write_html_report(const audit::AuditResult& result, const audit::Ledger& ledger,
                       const FiguresOfSource& figures, const std::filesystem::path& folder,
                       int threads = 0, const std::string& command = "");

// Parts of the page.

/// Returns a `<span>` with the name of a verdict.
[[nodiscard]] std::string verdict_mark(audit::Verdict verdict, const std::string& text = "");
/// Returns the printed text of a claim, typeset within a line.
[[nodiscard]] std::string printed_html(const audit::Claim& claim,
                                       const audit::PrintedSource& source);

/// Returns an entry of the errata list: the printed and the corrected formula, the clearest
/// counterexample, the later results. Its id is "erratum-ID" of its first claim.
[[nodiscard]] std::string erratum_html(const Erratum& erratum, const audit::AuditResult& result,
                                       const PageHead& head, const PageFigures& figures);
/// Returns a claim with its evidence, folded; its id is the claim's.
[[nodiscard]] std::string claim_html(const audit::ClaimResult& result, const PageHead& head);

/// Returns evidence as small tables: numbers are rounded (verdicts.json has all digits), formulas
/// typeset. Parts that the page shows elsewhere (TeX, the clearest counterexample, later results)
/// are left out.
[[nodiscard]] std::string evidence_html(const audit::Evidence& evidence, const audit::Claim& claim,
                                        const audit::PrintedSource& source);

/// Returns a text of the program as HTML, with typeset formulas.
[[nodiscard]] std::string note_html(const std::string& note, const audit::Claim& claim,
                                    const audit::PrintedSource& source);

} // namespace edgeproof::report

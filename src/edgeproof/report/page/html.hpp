// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/audit/run.hpp"
#include "edgeproof/report/figures/audit_figures.hpp"
#include "edgeproof/report/page/errata.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// Writes the files of a plot to the folder (write_plot_files), and returns its panel: {"id",
/// "title", "svg"}, where an empty svg was not drawn.
[[nodiscard]] nlohmann::ordered_json drawn_panel(const Plot& plot, const std::string& svg,
                                                 const std::filesystem::path& folder);
/// Returns figures, {"id", "title", "caption", "panels", "problem"}, as HTML, with links to their
/// data in the folder figures.
[[nodiscard]] std::string figures_html(const nlohmann::ordered_json& figures);

/// Lists of figures.
struct PageFigures {
    nlohmann::ordered_json printed = nlohmann::ordered_json::array();
    nlohmann::ordered_json residuals = nlohmann::ordered_json::array();
    /// With the claims' ids, and one panel or none.
    nlohmann::ordered_json errata = nlohmann::ordered_json::array();
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

// Parts of the page, as values of its template (share/edgeproof/report/page.html).

/// Returns the printed text of a claim, typeset within a line.
[[nodiscard]] std::string printed_html(const audit::Claim& claim,
                                       const audit::PrintedSource& source);

/// Returns the values of an entry of the errata list: the printed and the corrected formula, the
/// clearest counterexample, the later results. Its id is "erratum-ID" of its first claim.
[[nodiscard]] nlohmann::ordered_json erratum_values(const Erratum& erratum,
                                                    const audit::AuditResult& result,
                                                    const PageHead& head,
                                                    const PageFigures& figures);
/// Returns the values of a claim with its evidence; its id is the claim's.
[[nodiscard]] nlohmann::ordered_json claim_values(const audit::ClaimResult& result,
                                                  const PageHead& head);

/// Returns evidence as small tables: numbers are rounded (verdicts.json has all digits), formulas
/// typeset. Parts that the page shows elsewhere (TeX, the clearest counterexample, later results)
/// are left out.
[[nodiscard]] std::string evidence_html(const nlohmann::ordered_json& evidence,
                                        const audit::Claim& claim,
                                        const audit::PrintedSource& source);

/// Returns a text of the program as HTML, with typeset formulas.
[[nodiscard]] std::string note_html(const std::string& note, const audit::Claim& claim,
                                    const audit::PrintedSource& source);

} // namespace edgeproof::report

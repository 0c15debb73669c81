// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// A figure of the page, drawn or not.
struct DrawnFigure {
    struct Panel {
        std::string id;
        std::string title;
        std::string svg; ///< to be put into the page; empty: it was not drawn
    };
    std::string id;
    std::string title;
    std::string caption;
    std::vector<Panel> panels;
    std::string problem; ///< what went wrong, if anything
};

/// What the page shows beside the verdicts.
struct PageFigures {
    std::vector<DrawnFigure> paper;
    std::vector<DrawnFigure> residuals;
    std::map<std::string, DrawnFigure::Panel, std::less<>> errata; ///< by the claim's id
    std::string missing; ///< why there are no figures, if there are none
};

/// What the head of the page says beside the results.
struct PageHead {
    audit::PrintedSource source;
    std::string ledger_file;
    std::string ledger_sha256;
    std::string command; ///< that makes the page anew
    std::string date;    ///< 2026-11-23
    /// Files with the verdicts as theorems, as links from the page, by the claim's id.
    std::map<std::string, std::string, std::less<>> certificates;
};

/// report.html: one file that needs nothing else. Every claim is an element whose id is the claim's
/// id, so that `report.html#EQ09.M` stays a link to it; no id stands twice. The same to the byte
/// for the same input.
[[nodiscard]] std::string html_page(const audit::AuditResult& result, const PageFigures& figures,
                                    const PageHead& head = {});

} // namespace edgeproof::report

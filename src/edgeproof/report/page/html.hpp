// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/run.hpp"

#include <cstddef>
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

/// report.html: one file that needs nothing else. Every claim is an element whose id is the claim's
/// id, so that `report.html#EQ09.M` stays a link to it. The same to the byte for the same input.
[[nodiscard]] std::string html_page(const audit::AuditResult& result, const PageFigures& figures);

} // namespace edgeproof::report

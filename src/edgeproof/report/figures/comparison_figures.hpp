// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/comparison_report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

struct DrawnPlot {
    Plot plot;
    std::string svg;
};

/// Draws all plots of a report, file by file: the pressures of the data with the exact curve, their
/// errors against u/(a + b), and the same for the shear traction if data and scene have one; then
/// the errors of several files against the element width. Ids follow the names of the files.
[[nodiscard]] std::vector<DrawnPlot> draw_comparison(const ComparisonReport& report);

/// Writes ID.csv and ID.svg of each plot. Throws InputError if the folder is not writable.
void write_figures(const std::vector<DrawnPlot>& drawn, const std::filesystem::path& folder);

} // namespace edgeproof::report

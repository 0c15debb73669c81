// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/comparison_report.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace edgeproof::report {

/// All plots of a report, file by file: the pressures of the data beside the exact curve, their
/// errors against u/(a + b), and the same of the shear traction where data and scene have one;
/// then the errors of several files against the width of an element. Ids by the names of the files.
[[nodiscard]] std::vector<Figure> comparison_figures(const ComparisonReport& report);

/// These figures as they are drawn.
struct DrawnComparison {
    std::vector<Figure> figures;
    std::map<std::string, std::string> svg; ///< by the id of a plot
    bool with_gnuplot = false;              ///< else `svg` is empty
};
[[nodiscard]] DrawnComparison draw_comparison(const ComparisonReport& report);

/// ID.csv and ID.svg of each plot. Throws InputError where nothing can be written there.
void write_figures(const DrawnComparison& drawn, const std::filesystem::path& folder);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/comparison_report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

/// The pressures of a file and the exact curve. `id` names its files.
[[nodiscard]] Plot pressure_plot(const ComparisonReport& report,
                                 const comparison::FileComparison& file, const std::string& id);
/// |error/p| of the nodes inside against u/(a + b), with the edge's elements and the window that
/// c_0 is fitted over shaded.
[[nodiscard]] Plot error_plot(const ComparisonReport& report,
                              const comparison::FileComparison& file, const std::string& id);
/// The errors of several files against the width of an element.
[[nodiscard]] Plot convergence_plot(const ComparisonReport& report);

/// All plots of a report, file by file; ids by the names of the files.
[[nodiscard]] std::vector<Figure> comparison_figures(const ComparisonReport& report);

/// ID.csv and ID.svg of each plot. Throws InputError where there is no gnuplot, or nothing can be
/// written there.
void write_comparison_figures(const ComparisonReport& report, const std::filesystem::path& folder);

} // namespace edgeproof::report

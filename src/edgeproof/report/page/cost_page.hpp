// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/comparison_figures.hpp"
#include "edgeproof/report/tables/cost_tables.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::report {

/// share/edgeproof/report/cost.html when the program was built.
namespace cost_template {
extern const std::string_view cost_html;
} // namespace cost_template

/// Writes cost.html (a self-contained page), cost.csv (routes by digits), points.csv (every point),
/// cost.json, and figures/ with the data of each figure and, if gnuplot is installed, its picture.
/// Throws InputError if the folder is not writable.
void write_cost_page(const CostReport& report, const std::filesystem::path& folder);

/// Returns one self-contained page: outcome, quantities, errors and, if drawn, figures of each
/// file.
[[nodiscard]] std::string comparison_page(const ComparisonReport& report,
                                          const DrawnComparison& drawn);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/cost_tables.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::report {

/// share/edgeproof/report/cost.html, as it was when the program was built.
namespace cost_template {
extern const std::string_view cost_html;
} // namespace cost_template

/// Writes cost.html (a page that needs nothing else), cost.csv (routes by digits), points.csv
/// (every point), cost.json, and figures/ with the data of each figure and, where gnuplot is
/// installed, its picture. Throws InputError where the folder cannot be written to.
void write_cost_page(const CostReport& report, const std::filesystem::path& folder);

} // namespace edgeproof::report

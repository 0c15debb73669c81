// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/cost/cost_tables.hpp"

#include <filesystem>

namespace edgeproof::report {

/// Writes cost.html (a self-contained page), cost.csv (routes by digits), points.csv (every point),
/// cost.json, and figures/ with the data of each figure and its picture.
/// Throws InputError if the folder is not writable.
void write_cost_page(const CostReport& report, const std::filesystem::path& folder);

} // namespace edgeproof::report

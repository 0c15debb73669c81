// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <string>
#include <vector>

namespace edgeproof::report {

/// Plots the size of the slip zone at an edge against Q/(f P), exact and by one, two and three
/// terms: a plot for each of the paper's profiles and each edge that differs. Columns: load (Q/(f
/// P)), d, d1, d2, d3, as fractions of the distance from the edge to the origin.
[[nodiscard]] std::vector<Plot> slip_plots(const std::string& paper);

} // namespace edgeproof::report

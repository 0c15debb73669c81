// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/scene/input/bounded_value.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::report {

struct SlipTableOptions {
    std::vector<std::string> tolerances; ///< in the format of scene::parse_tolerance
    std::vector<std::size_t> terms{1};
    scene::Digits digits{10};
    std::function<void(std::size_t, std::size_t)> progress = {}; ///< rows done, and their total
};

/// Returns the proved Q/(f P) up to which the slip-zone size by n terms stays within each
/// tolerance, for all of the paper's profiles at both edges, under Q alone. Throws InputError for
/// malformed tolerances, BudgetError if the budget does not decide one of them.
[[nodiscard]] Table slip_table(const std::string& paper, const SlipTableOptions& options);

/// Plots the size of the slip zone at an edge against Q/(f P), exact and by one, two and three
/// terms: a plot for each of the paper's profiles and each edge that differs. Columns: load (Q/(f
/// P)), d, d1, d2, d3, as fractions of the distance from the edge to the origin.
[[nodiscard]] std::vector<Plot> slip_plots(const std::string& paper);

} // namespace edgeproof::report

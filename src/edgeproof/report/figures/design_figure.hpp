// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/scene/design/run_design.hpp"

#include <filesystem>

namespace edgeproof::report {

/// Plots the reach against the one parameter, with marks at the best and at the printed value, and
/// writes the plot as .svg (by gnuplot) or as .csv. The line is broken where the reach jumps.
/// Columns: the parameter, reach, best, printed. Throws InputError for another ending, and for .svg
/// without gnuplot.
void write_design_figure(const scene::DesignScene& design, const scene::DesignResult& result,
                         const std::filesystem::path& file);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/agreement_report.hpp"

#include <filesystem>

namespace edgeproof::report {

/// Plots the correct digits of p and q against u, with the digits that the rounding of the inputs
/// to double precision allows, and writes the plot as .svg (by gnuplot) or as .csv. Columns: u, p,
/// q (if there is any), inputs. Throws InputError for another ending, without a point to draw, and
/// for .svg without gnuplot.
void write_agreement_figure(const Conformance& result, const std::filesystem::path& file);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/agreement_report.hpp"
#include "edgeproof/scene/design/design_file.hpp"

#include <filesystem>

/// The option --figure of `check` and `design`.
namespace edgeproof::report {

/// Plots the correct digits of p and q against u, with the digits that the rounding of the inputs
/// to double precision allows, and writes the plot as .svg or as .csv. Columns: u, p,
/// q (if there is any), inputs. Throws InputError for another ending, and without a point to draw.
void write_agreement_figure(const Conformance& result, const std::filesystem::path& file);

/// Plots the reach against the one parameter, with marks at the best and at the printed value, and
/// writes the plot as .svg or as .csv. The line is broken where the reach jumps.
/// Columns: the parameter, reach, best, printed. Throws InputError for another ending.
void write_design_figure(const scene::DesignScene& design, const scene::DesignResult& result,
                         const std::filesystem::path& file);

} // namespace edgeproof::report

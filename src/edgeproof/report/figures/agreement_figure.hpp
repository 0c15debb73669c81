// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/tables/agreement_report.hpp"

#include <filesystem>

namespace edgeproof::report {

/// Digits right of p and q against u, and the digits that half a unit in the last place of a
/// double's inputs leaves. Columns: u, p, q (where there is any), inputs.
[[nodiscard]] Plot agreement_plot(const Conformance& c);

/// The plot as .svg (gnuplot draws it) or as .csv. Throws InputError for another ending, without a
/// point to draw, and for .svg where there is no gnuplot.
void write_agreement_figure(const Conformance& result, const std::filesystem::path& file);

} // namespace edgeproof::report

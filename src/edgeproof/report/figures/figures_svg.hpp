// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <string>
#include <vector>

namespace edgeproof::report {

/// Draws the plots side by side without gnuplot, for systems that do not have it (and for the page
/// in the browser). Positions are computed with `Real` and rounded to a tenth of a pixel, so that
/// the picture is the same on every machine. Text and axes have the colour of the page's text.
/// Throws Error for a plot without data.
[[nodiscard]] std::string svg_without_gnuplot(const std::vector<Plot>& plots);

} // namespace edgeproof::report

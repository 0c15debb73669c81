// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Draws the plots in one line as SVG. Positions are computed with `Real` and rounded to a tenth of
/// a pixel, so that the picture is the same on every machine. Text and axes have the colour of the
/// page's text. Throws Error for a plot without data.
[[nodiscard]] std::string draw_svg(const std::vector<Plot>& plots);

/// Prepares the SVG of one plot for a page: with unique ids and without a background.
[[nodiscard]] std::string inline_svg(const std::string& svg, const Plot& plot);

/// Writes PLOT.csv, and PLOT.svg if `svg` is not empty, to a folder, named by the id of the plot.
void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder);

/// Throws InputError for an ending that picture_file does not support: others than .svg, .png and
/// .pdf.
void check_picture_name(const std::string& file);
/// Returns the picture in the format of the file's ending. `rsvg-convert` makes a .png (with two
/// pixels for each of the SVG) and a .pdf. Throws InputError if there is no such program, Error if
/// it fails.
[[nodiscard]] std::string picture_file(const std::vector<Plot>& plots, const std::string& file);

} // namespace edgeproof::report

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

/// Returns an SVG as PNG (with two pixels for each of its own) or PDF, by `rsvg-convert`. Throws
/// InputError if there is no such program, Error if it fails.
[[nodiscard]] std::string converted_svg(const std::string& svg, const std::string& format);

/// Writes PLOT.csv, and PLOT.svg if `svg` is not empty, to a folder, named by the id of the plot.
void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder);

/// Throws InputError if a file of an option --figure cannot be written: for an ending other than
/// .svg and .csv, and as io::check_output.
void check_figure(const std::filesystem::path& file);
/// Writes the plot as .svg or as .csv. Throws as check_figure.
void write_figure(const Plot& plot, const std::filesystem::path& file);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::report {

/// Finds an executable program `gnuplot` in the folders of PATH.
[[nodiscard]] std::optional<std::filesystem::path> find_gnuplot();

/// Draws the plot with `gnuplot` and returns the SVG, with the title and description of the plot.
/// Throws Error with gnuplot's message if it fails.
[[nodiscard]] std::string draw_svg(const Plot& plot, const std::filesystem::path& gnuplot);

/// Draws the plots side by side and returns the bytes of the picture. Throws Error as above.
[[nodiscard]] std::string draw_picture(const std::vector<Plot>& plots, PictureKind kind,
                                       std::size_t width, const std::filesystem::path& gnuplot);

/// Writes PLOT.csv, and PLOT.svg if `svg` is not empty, to a folder, named by the id of the plot.
void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder);

/// Throws InputError if a file of an option --figure cannot be written: for an ending other than
/// .svg and .csv, for .svg without gnuplot, and as io::check_output.
void check_figure(const std::filesystem::path& file);
/// Writes the plot as .svg (by gnuplot) or as .csv. Throws as check_figure.
void write_figure(const Plot& plot, const std::filesystem::path& file);

/// Prepares the SVG for a page: without a prolog, with unique ids, without a background, and with
/// the colour of the text instead of black, so that it is readable on a dark page.
[[nodiscard]] std::string inline_svg(const std::string& svg, const Plot& plot);

} // namespace edgeproof::report

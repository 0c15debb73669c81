// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::report {

/// The program `gnuplot` in the folders of PATH, if there is one that can be run.
[[nodiscard]] std::optional<std::filesystem::path> find_gnuplot();

/// Draws the plot with `gnuplot` and gives the SVG, with the plot's title and description as its
/// own. Throws Error if gnuplot fails, with its message.
[[nodiscard]] std::string draw_svg(const Plot& plot, const std::filesystem::path& gnuplot);

/// Draws the plots side by side; the bytes of the picture. Throws Error as above.
[[nodiscard]] std::string draw_picture(const std::vector<Plot>& plots, PictureKind kind,
                                       std::size_t width, const std::filesystem::path& gnuplot);

/// PLOT.csv, and PLOT.svg where `svg` is not empty, for each id of a plot, in a folder.
void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder);

/// The plot as .svg (gnuplot draws it) or as .csv: the argument of an option --figure. Throws
/// InputError for another ending, and for .svg where there is no gnuplot.
void write_figure(const Plot& plot, const std::filesystem::path& file);

/// The SVG made part of a page: no prolog, ids of its own, no ground of its own, and black taken
/// from the text's colour, so that it can be read on a dark page.
[[nodiscard]] std::string inline_svg(const std::string& svg, const Plot& plot);

} // namespace edgeproof::report

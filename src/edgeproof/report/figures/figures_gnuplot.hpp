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

/// Throws InputError for a file of an option --figure that cannot be written: an ending other than
/// .svg and .csv, .svg where there is no gnuplot, and as io::check_output.
void check_figure(const std::filesystem::path& file);
/// The plot as .svg (gnuplot draws it) or as .csv. Throws as check_figure.
void write_figure(const Plot& plot, const std::filesystem::path& file);

/// The SVG made part of a page: no prolog, ids of its own, no ground of its own, and black taken
/// from the text's colour, so that it can be read on a dark page.
[[nodiscard]] std::string inline_svg(const std::string& svg, const Plot& plot);

} // namespace edgeproof::report

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace edgeproof::report {

/// The program `gnuplot` in the folders of PATH, if there is one that can be run.
[[nodiscard]] std::optional<std::filesystem::path> find_gnuplot();

/// Draws the plot with `gnuplot` in the folder `scratch` (which must exist) and gives the SVG, with
/// the plot's title and description as its own. Throws Error if gnuplot fails, with what it said.
[[nodiscard]] std::string draw_svg(const Plot& plot, const std::filesystem::path& gnuplot,
                                   const std::filesystem::path& scratch);

/// Draws the plots side by side; the bytes of the picture. Throws Error as above.
[[nodiscard]] std::string draw_picture(const std::vector<Plot>& plots, PictureKind kind,
                                       std::size_t width, const std::filesystem::path& gnuplot,
                                       const std::filesystem::path& scratch);

/// The plot as .svg (gnuplot draws it) or as .csv: the argument of an option --figure. Throws
/// InputError for another ending, and for .svg where there is no gnuplot.
void write_figure(const Plot& plot, const std::filesystem::path& file);

/// The SVG made part of a page: no prolog, ids of its own, no ground of its own, and black taken
/// from the text's colour, so that it can be read on a dark page.
[[nodiscard]] std::string inline_svg(const std::string& svg, const Plot& plot);

} // namespace edgeproof::report

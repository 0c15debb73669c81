// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <functional>
#include <string>
#include <vector>

namespace edgeproof::report {

/// A scene in pictures: the exact pressure (and q, where the scene has a shear) along the contact
/// with the sums of the first terms, and for each edge that is asked for the relative errors of
/// these on logarithmic axes, with the tolerance and where each first leaves it.
/// `progress`: values done, of how many.
struct ScenePicture {
    std::vector<Plot> plots;
    /// "right edge, 1 term: within 1% up to u = 0.0123" and so on; "(estimate)" where it is one.
    std::vector<std::string> exits;
};
/// Throws InputError as run_scene does.
[[nodiscard]] ScenePicture
scene_picture(const scene::Scene& scene,
              const std::function<void(std::size_t, std::size_t)>& progress);

/// The picture as a file of that name, by its ending: .svg, .png, .pdf, .html. Throws InputError
/// for other endings, and where there is no gnuplot.
[[nodiscard]] std::string picture_file(const ScenePicture& picture, const std::string& title,
                                       const std::string& file);
/// Throws InputError for an ending that picture_file does not have.
void check_picture_name(const std::string& file);
/// The pressures as text, `width` columns wide.
[[nodiscard]] std::string picture_text(const ScenePicture& picture, std::size_t width);

} // namespace edgeproof::report

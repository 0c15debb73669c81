// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

namespace edgeproof::cli {
namespace {

report::Plot contours_of(const Options& o, const scene::Scene& scene) {
    const scene::Body body = scene::body_named(o["--body"]);
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.group == scene::QuantityGroup::stress && row.name == o["--field"]) {
            return io::at_place(scene.file, scene.load_line,
                                [&] { return report::stress_picture(scene, row.quantity, body); });
        }
    }
    throw InputError("--field " + o["--field"] + ": there is no such stress",
                     "write sxx, szz, sxz, tau_max or mises");
}

} // namespace

int plot(Options& o) {
    const std::string& file = o["--out"];
    require(!file.empty(), "there is no file for the picture", "add --out pad.svg");
    check_figure_option(file);
    const scene::Scene scene = asked_scene(o);
    const std::string text = report::picture_file(
        o["--field"].empty() ? picture_of(scene) : std::vector{contours_of(o, scene)}, file);
    show_as_file(o);
    io::write_output(file, text);
    return 0;
}

} // namespace edgeproof::cli

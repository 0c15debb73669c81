// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

namespace edgeproof::cli {
namespace {

report::Panels panels_named(const std::string& name) {
    using enum report::Panels;
    for (const auto& [known, panels] :
         {std::pair{"all", all}, {"pressure", pressure}, {"errors", errors}}) {
        if (name == known) {
            return panels;
        }
    }
    throw InputError("--panel " + name + ": there is no panel of this name",
                     "write all, pressure or errors");
}

/// "85mm" or "8.5cm", in mm.
double width_in_mm(const std::string& text) {
    const bool mm = text.ends_with("mm");
    require(mm || text.ends_with("cm"), "--width " + text + " has no unit",
            "write it as 85mm or 8.5cm");
    const Rational width = parse_decimal(text.substr(0, text.size() - 2)) * (mm ? 1 : 10);
    require(width > 0 && width <= 2000, "--width " + text + " is out of range",
            "give the width of a column or page, such as 85mm");
    return width.convert_to<double>();
}

} // namespace

int plot(Options& o) {
    const std::string& file = o["--out"];
    require(!file.empty(), "there is no file for the picture", "add --out pad.svg");
    check_figure_option(file);
    const report::Panels panels = panels_named(o["--panel"]);
    const double width = o["--width"].empty() ? 0 : width_in_mm(o["--width"]);
    const scene::Scene scene = asked_scene(o);
    std::vector<report::Plot> plots =
        o["--field"].empty() ? picture_of(scene, panels)
                             : std::vector{io::at_place(scene.file, scene.load_line, [&] {
                                   return report::stress_picture(scene, o["--field"],
                                                                 scene::body_named(o["--body"]));
                               })};
    for (report::Plot& plot : plots) {
        plot.title = o.has("--no-title") ? "" : plot.title;
    }
    const std::string text = report::picture_file(plots, file, width);
    show_as_file(o);
    io::write_output(file, text);
    return 0;
}

} // namespace edgeproof::cli

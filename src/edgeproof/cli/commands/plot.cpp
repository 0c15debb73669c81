// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

namespace edgeproof::cli {
namespace {

int plot(SceneOptions& o) {
    std::string file;
    std::swap(file, o.out); // the file of the picture, not of a table
    if (!file.empty()) {
        report::check_picture_name(file);
        io::check_output(file);
    }
    scene::Scene scene = asked_scene(o);
    const report::ScenePicture picture = picture_of(scene);
    const std::string text = file.empty() ? report::picture_text(picture, terminal_width())
                                          : report::picture_file(picture, title_of(scene), file);
    show_as_file(o);
    io::write_output(file.empty() ? "-" : file, text);
    return 0;
}

} // namespace

void add_plot(CLI::App& app, int& code) {
    auto [sub, o] = add_command<SceneOptions>(
        app, code, "plot",
        "a picture of a scene: the pressure, the first terms, and where they are good", plot);
    add_given_scene(sub, o);
    add_tolerance_option(sub, o, " (default: the scene's, else 1%)");
    sub.add_option("--out,--figure", o.out,
                   "write to this file, by its ending .svg, .png, .pdf or .html, whole or not at "
                   "all (default: a small picture of letters)");
    sub.footer("Drawn by gnuplot; a .svg also without it. The edges are those of --edge or of the "
               "scene, else the right "
               "one; the terms 1, 2 and 3 unless --terms or the scene say which.");
}

} // namespace edgeproof::cli

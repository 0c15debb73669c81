// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/report/text/html_markup.hpp"
#include "edgeproof/report/text/program_line.hpp"

namespace edgeproof::report {
namespace {

std::filesystem::path gnuplot_for_picture() {
    const auto gnuplot = find_gnuplot();
    if (!gnuplot) {
        throw InputError("there is no gnuplot to draw with", "install gnuplot-nox");
    }
    return *gnuplot;
}

std::string page_of(const ScenePicture& picture, const std::string& title) {
    const auto gnuplot = gnuplot_for_picture();
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "name=\"viewport\" content=\"width=device-width\">\n<title>" +
        escape_html(title) +
        "</title>\n<style>body{font:1rem/1.4 sans-serif;color:#000;background:#fff;margin:1rem}"
        ".panels{display:grid;gap:1rem;max-width:84rem;"
        "grid-template-columns:repeat(auto-fit,minmax(min(26rem,100%),1fr))}"
        ".panels "
        "svg{width:100%;height:auto}footer{font-size:.8rem}</style>\n</head>\n<body>\n<h1>" +
        escape_html(title) + "</h1>\n<div class=\"panels\">\n";
    for (const Plot& plot : picture.plots) {
        page += inline_svg(draw_svg(plot, gnuplot), plot) + "\n";
    }
    page += "</div>\n<ul>\n";
    for (const std::string& exit : picture.exits) {
        page += "<li>" + escape_html(exit) + "</li>\n";
    }
    return page + "</ul>\n<footer>" + escape_html(program_line()) + "</footer>\n</body>\n</html>\n";
}

} // namespace

void check_picture_name(const std::string& file) {
    const std::filesystem::path ending = std::filesystem::path(file).extension();
    if (ending != ".svg" && ending != ".png" && ending != ".pdf" && ending != ".html") {
        throw InputError(file + " is neither .svg, .png, .pdf nor .html", "name the file so");
    }
}

std::string picture_file(const ScenePicture& picture, const std::string& title,
                         const std::string& file) {
    check_picture_name(file);
    const std::filesystem::path ending = std::filesystem::path(file).extension();
    if (ending == ".html") {
        return page_of(picture, title);
    }
    const auto gnuplot = gnuplot_for_picture();
    return draw_picture(picture.plots,
                        ending == ".svg"   ? PictureKind::svg
                        : ending == ".png" ? PictureKind::png
                                           : PictureKind::pdf,
                        0, gnuplot);
}

std::string picture_text(const ScenePicture& picture, std::size_t width) {
    const auto gnuplot = gnuplot_for_picture();
    Plot plot = picture.plots.front();
    for (Curve& curve : plot.curves) {
        // The key's columns are narrow in text, and gnuplot cuts its lines; the exits are listed
        // below.
        if (curve.title.starts_with("leaves")) {
            curve.title.clear();
        } else if (curve.title.ends_with(" edge")) {
            curve.title.resize(curve.title.size() - std::string_view(" edge").size());
        }
    }
    std::string text = draw_picture({plot}, PictureKind::text, width, gnuplot);
    text.erase(0, text.find_first_not_of("\f\n"));
    for (const std::string& exit : picture.exits) {
        text += exit + "\n";
    }
    return text;
}

} // namespace edgeproof::report

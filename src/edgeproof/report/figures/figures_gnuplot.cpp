// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_gnuplot.hpp"

#include "edgeproof/io/child_process.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/scratch.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/text/html_markup.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace edgeproof::report {
namespace {

constexpr std::size_t most_messages = 10'000;

std::string read_all(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
}

/// What stands between `open` and `close`, with both, is replaced.
void replace_element(std::string& text, std::string_view open, std::string_view close,
                     const std::string& with) {
    const std::size_t begin = text.find(open);
    const std::size_t end = begin == std::string::npos ? begin : text.find(close, begin);
    if (end != std::string::npos) {
        text.replace(begin, end + close.size() - begin, with);
    }
}

/// Runs gnuplot on a script with no shell in between. Environment: only what finds fonts, so that a
/// user's settings change no figure. What it says on either stream, and how it ended.
std::pair<std::string, std::string> run_gnuplot(const std::filesystem::path& program,
                                                const std::filesystem::path& script) {
    io::ProgramCall call;
    call.arguments = {program.string(), script.string()};
    call.environment = {"LC_ALL=C.UTF-8"};
    for (const char* variable : {"PATH", "HOME", "LD_LIBRARY_PATH"}) {
        if (const char* value = std::getenv(variable)) {
            call.environment->push_back(std::string(variable) + '=' + value);
        }
    }
    std::string messages;
    call.said = [&](std::string_view text) {
        messages += text.substr(0, most_messages - std::min(messages.size(), most_messages));
    };
    const io::ProgramRun run = run_program(call);
    return {messages + run.output, run.ending()};
}

/// What a script writes to the file `picture`, beside which it is put.
std::string drawn(const std::string& id, const std::string& text,
                  const std::filesystem::path& picture, const std::filesystem::path& gnuplot) {
    const auto script = picture.parent_path() / (id + ".gp");
    std::ofstream(script, std::ios::binary) << text;
    const auto [said, ending] = run_gnuplot(gnuplot, script);
    std::string bytes = read_all(picture);
    std::error_code ignored;
    for (const auto& file : {script, picture}) {
        std::filesystem::remove(file, ignored);
    }
    if (!ending.empty() || bytes.empty()) {
        throw Error("gnuplot did not draw " + id + ": " + said.substr(0, said.find('\n')) +
                    (ending.empty() ? "" : " (gnuplot " + ending + ")"));
    }
    return bytes;
}

} // namespace

std::optional<std::filesystem::path> find_gnuplot() {
    const char* path = std::getenv("PATH");
    std::string_view rest = path == nullptr ? "" : path;
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        const std::string_view folder = rest.substr(0, colon);
        rest = colon == std::string_view::npos ? "" : rest.substr(colon + 1);
        // An empty entry would be the current folder: a program is never taken from there.
        const std::filesystem::path candidate = std::filesystem::path(folder) / "gnuplot";
        if (!folder.empty() && access(candidate.c_str(), X_OK) == 0 &&
            std::filesystem::is_regular_file(candidate)) {
            return candidate;
        }
    }
    return std::nullopt;
}

std::string draw_svg(const Plot& plot, const std::filesystem::path& gnuplot,
                     const std::filesystem::path& scratch) {
    const auto picture = scratch / (plot.id + ".part.svg");
    std::string svg = drawn(plot.id, gnuplot_script(plot, picture.string()), picture, gnuplot);
    if (svg.find("</svg>") == std::string::npos) {
        throw Error("gnuplot did not draw " + plot.id);
    }
    replace_element(svg, "<title>", "</title>", "<title>" + escape_html(plot.title) + "</title>");
    replace_element(svg, "<desc>", "</desc>",
                    "<desc>" + escape_html(plot.description) + "</desc><metadata>" +
                        escape_html(program_line()) + "</metadata>");
    return svg;
}

std::string draw_picture(const std::vector<Plot>& plots, PictureKind kind, std::size_t width,
                         const std::filesystem::path& gnuplot,
                         const std::filesystem::path& scratch) {
    const auto picture = scratch / "picture";
    return drawn(plots.front().id, gnuplot_script(plots, kind, width, picture.string()), picture,
                 gnuplot);
}

void write_figure(const Plot& plot, const std::filesystem::path& file) {
    if (file.extension() == ".csv") {
        io::write_whole(file, to_csv(plot));
        return;
    }
    if (file.extension() != ".svg") {
        throw InputError("--figure " + file.string() + " is neither .svg nor .csv",
                         "name the file so");
    }
    const auto gnuplot = find_gnuplot();
    if (!gnuplot) {
        throw InputError("there is no gnuplot to draw " + file.string(),
                         "install gnuplot-nox, or write a .csv");
    }
    const io::Scratch scratch;
    io::write_whole(file, draw_svg(plot, *gnuplot, scratch.path()));
}

std::string inline_svg(const std::string& svg, const Plot& plot) {
    std::string out = svg.substr(svg.find("<svg"));
    const std::string title = plot.id + "-title";
    const std::string description = plot.id + "-desc";
    out.replace(0, 4, "<svg role=\"img\" aria-labelledby=\"" + title + ' ' + description + "\"");
    replace_element(out, "<title>", "</title>",
                    "<title id=\"" + title + "\">" + escape_html(plot.title) + "</title>");
    replace_element(out, "<desc>", "</desc>",
                    "<desc id=\"" + description + "\">" + escape_html(plot.description) +
                        "</desc>");
    replace_element(out, "<metadata>", "</metadata>", ""); // the page names the program
    const std::string own = plot.id + '-';
    replace_all(out, "id=\"gnuplot_canvas\"", "id=\"" + own + "canvas\"");
    replace_all(out, "id='gp", "id='" + own + "gp");
    replace_all(out, "href='#gp", "href='#" + own + "gp");
    for (const char* filter : {"textbox", "greybox"}) {
        replace_all(out, std::string("id='") + filter, "id='" + own + filter);
        replace_all(out, std::string("#") + filter, "#" + own + filter);
    }
    for (const char* black : {"color=\"black\" ", "color=\"white\" "}) {
        replace_all(out, black, "");
    }
    replace_element(out, "fill=\"#ffffff\"", "/>", "fill=\"none\"/>"); // the ground
    replace_all(out, "fill=\"black\"", "fill=\"currentColor\"");
    replace_all(out, "fill = 'black'", "fill = 'currentColor'");
    replace_all(out, "stroke='black'", "stroke='currentColor'");
    replace_all(out, "rgb(  0,   0,   0)", "currentColor");
    return out;
}

} // namespace edgeproof::report

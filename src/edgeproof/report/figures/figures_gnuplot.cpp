// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/figures_gnuplot.hpp"

#include "edgeproof/io/child_process.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <utility>

namespace edgeproof::report {
namespace {

constexpr std::size_t most_messages = 10'000;
constexpr std::size_t most_message_bytes = 200;

/// Replaces the text from `open` to `close`, including both.
void replace_element(std::string& text, std::string_view open, std::string_view close,
                     const std::string& with) {
    const std::size_t begin = text.find(open);
    const std::size_t end = begin == std::string::npos ? begin : text.find(close, begin);
    if (end != std::string::npos) {
        text.replace(begin, end + close.size() - begin, with);
    }
}

/// Returns the last line that is not empty, which has gnuplot's error. The lines before it repeat
/// the script.
std::string last_line(std::string_view messages) {
    const std::size_t end = messages.find_last_not_of(" \t\r\n");
    if (end == std::string_view::npos) {
        return "no message";
    }
    const std::size_t begin = messages.find_last_of('\n', end);
    const std::string_view line =
        messages.substr(0, end + 1).substr(begin == std::string_view::npos ? 0 : begin + 1);
    return printable(shortened(line.substr(line.find_first_not_of(" \t")), most_message_bytes));
}

/// Returns gnuplot's output for a script. Script and picture go through pipes, without a shell or a
/// file name. The environment has only the variables needed to find fonts, and the user's settings
/// are ignored (-d), so that they do not change a figure.
std::string drawn(const io::FileStem& id, const GnuplotScript& script,
                  const std::filesystem::path& program) {
    io::ProgramCall call;
    call.arguments = {program.string(), "-d", "-"};
    call.input = script.text();
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
    io::ProgramRun run = run_program(call);
    if (!run.ending().empty() || run.output.empty()) {
        throw Error("gnuplot did not draw " + id.text() + ": " + last_line(messages) +
                    (run.ending().empty() ? "" : " (gnuplot " + run.ending() + ")"));
    }
    return std::move(run.output);
}

} // namespace

std::optional<std::filesystem::path> find_gnuplot() {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string part; std::getline(folders, part, ':');) {
        // An empty entry would be the current folder, from which programs are never started.
        const std::filesystem::path folder(part);
        const std::filesystem::path candidate = folder / "gnuplot";
        if (!folder.empty() && access(candidate.c_str(), X_OK) == 0 &&
            std::filesystem::is_regular_file(candidate)) {
            return candidate;
        }
    }
    return std::nullopt;
}

std::string draw_svg(const Plot& plot, const std::filesystem::path& gnuplot) {
    std::string svg = drawn(plot.id, gnuplot_script(plot), gnuplot);
    if (svg.find("</svg>") == std::string::npos) {
        throw Error("gnuplot did not draw " + plot.id.text());
    }
    replace_element(svg, "<title>", "</title>", "<title>" + escape_html(plot.title) + "</title>");
    replace_element(svg, "<desc>", "</desc>",
                    "<desc>" + escape_html(plot.description) + "</desc><metadata>" +
                        escape_html(program_line()) + "</metadata>");
    return svg;
}

std::string draw_picture(const std::vector<Plot>& plots, PictureKind kind, std::size_t width,
                         const std::filesystem::path& gnuplot) {
    return drawn(plots.front().id, gnuplot_script(plots, kind, width), gnuplot);
}

void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder) {
    io::write_whole(folder / plot.id.with(".csv"), to_csv(plot));
    if (!svg.empty()) {
        io::write_whole(folder / plot.id.with(".svg"), svg);
    }
}

void check_figure(const std::filesystem::path& file) {
    if (file.extension() != ".svg" && file.extension() != ".csv") {
        throw InputError("--figure " + file.string() + " is neither .svg nor .csv",
                         "name the file so");
    }
    if (file.extension() == ".svg" && !find_gnuplot()) {
        throw InputError("there is no gnuplot to draw " + file.string(),
                         "install gnuplot-nox, or write a .csv");
    }
    io::check_output(file);
}

void write_figure(const Plot& plot, const std::filesystem::path& file) {
    check_figure(file);
    io::write_whole(file, file.extension() == ".csv" ? to_csv(plot)
                                                     : draw_svg(plot, find_gnuplot().value()));
}

std::string inline_svg(const std::string& svg, const Plot& plot) {
    std::string out = svg.substr(svg.find("<svg"));
    const std::string title = plot.id.with("-title");
    const std::string description = plot.id.with("-desc");
    out.replace(0, 4, "<svg role=\"img\" aria-labelledby=\"" + title + ' ' + description + "\"");
    replace_element(out, "<title>", "</title>",
                    "<title id=\"" + title + "\">" + escape_html(plot.title) + "</title>");
    replace_element(out, "<desc>", "</desc>",
                    "<desc id=\"" + description + "\">" + escape_html(plot.description) +
                        "</desc>");
    replace_element(out, "<metadata>", "</metadata>", ""); // the page names the program
    const std::string own = plot.id.with("-");
    replace_element(out, "fill=\"#ffffff\"", "/>", "fill=\"none\"/>"); // the background
    const std::pair<std::string, std::string> replacements[] = {
        {"id=\"gnuplot_canvas\"", "id=\"" + own + "canvas\""},
        {"id='gp", "id='" + own + "gp"},
        {"href='#gp", "href='#" + own + "gp"},
        {"id='textbox", "id='" + own + "textbox"},
        {"#textbox", "#" + own + "textbox"},
        {"id='greybox", "id='" + own + "greybox"},
        {"#greybox", "#" + own + "greybox"},
        {"color=\"black\" ", ""},
        {"color=\"white\" ", ""},
        {"fill=\"black\"", "fill=\"currentColor\""},
        {"fill = 'black'", "fill = 'currentColor'"},
        {"stroke='black'", "stroke='currentColor'"},
        {"rgb(  0,   0,   0)", "currentColor"}};
    // A figure has thousands of matches: boost::replace_all, which works in place, takes several
    // times as long.
    for (const auto& [from, to] : replacements) {
        std::string replaced;
        std::size_t at = 0;
        for (std::size_t match; (match = out.find(from, at)) != out.npos;
             at = match + from.size()) {
            replaced.append(out, at, match - at).append(to);
        }
        out = replaced.append(out, at);
    }
    return out;
}

} // namespace edgeproof::report

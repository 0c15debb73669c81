// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/process.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/figures/figures.hpp"
#include "edgeproof/report/text/escape.hpp"
#include "edgeproof/report/text/program_line.hpp"

#include <boost/crc.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace edgeproof::report {
namespace {

constexpr std::size_t most_message_bytes = 200;

/// Finds an executable program in the folders of PATH. An empty entry would be the current folder,
/// from which programs are never started.
std::optional<std::filesystem::path> program_in_path(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string part; std::getline(folders, part, ':');) {
        const std::filesystem::path candidate = std::filesystem::path(part) / name;
        if (!part.empty() && access(candidate.c_str(), X_OK) == 0 &&
            std::filesystem::is_regular_file(candidate)) {
            return candidate;
        }
    }
    return std::nullopt;
}

std::string big_endian(std::uint32_t n) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        bytes += static_cast<char>(n >> shift & 0xffU);
    }
    return bytes;
}

/// Names the program in the picture, since only a file that it wrote is replaced.
std::string with_program(std::string picture, const std::string& format) {
    if (format == "pdf") {
        return picture + "% " + program_line() + "\n";
    }
    constexpr std::size_t last_chunk = 12;
    const std::string text = std::string("tEXtSoftware") + '\0' + program_line();
    boost::crc_32_type crc;
    crc.process_bytes(text.data(), text.size());
    picture.insert(picture.size() - std::min(picture.size(), last_chunk),
                   big_endian(static_cast<std::uint32_t>(text.size() - 4)) + text +
                       big_endian(crc.checksum()));
    return picture;
}

/// Returns an SVG as PNG or PDF.
std::string converted_svg(const std::string& svg, const std::string& format) {
    const auto program = program_in_path("rsvg-convert");
    if (!program) {
        throw InputError("there is no rsvg-convert, which makes a ." + format + " of an SVG",
                         "install librsvg2-bin, or write a .svg");
    }
    io::ProgramCall call;
    call.arguments = {program->string(), "--format", format, "--zoom", format == "png" ? "2" : "1"};
    call.input = svg;
    std::string message;
    call.said = [&](std::string_view text) { message += text.substr(0, most_message_bytes); };
    io::ProgramRun run = io::run_program(call);
    const std::string_view head = format == "png" ? "\x89PNG" : "%PDF";
    if (!run.ending().empty() || !run.output.starts_with(head)) {
        throw Error("rsvg-convert made no ." + format + ": " +
                    printable(shortened(message, most_message_bytes)) + " " + run.ending());
    }
    return with_program(std::move(run.output), format);
}

std::optional<std::string> cell_text(const std::optional<Real>& value) {
    return value && isfinite(*value) ? std::optional(to_decimal(*value, figure_digits))
                                     : std::nullopt;
}

} // namespace

std::vector<std::optional<Real>>& Plot::add_row(const Real& first) {
    rows.emplace_back(1 + curves.size()).front() = first;
    return rows.back();
}

void Plot::add_curve(const std::string& column, std::string curve_title, const Pen& pen,
                     std::optional<std::size_t> marks) {
    curves.push_back({column, std::move(curve_title), pen, marks});
    for (auto& row : rows) {
        row.emplace_back();
    }
}

std::string to_csv(const Plot& plot) {
    std::string csv = "# " + printable(plot.title) + '\n';
    csv += "# " + printable(plot.description) + '\n';
    csv += "# program: " + program_line() + '\n';
    csv += plot.first_column;
    for (const Curve& curve : plot.curves) {
        add_csv_cell(csv += ',', curve.column);
    }
    csv += '\n';
    for (const auto& row : plot.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            csv += (i == 0 ? "" : ",") + cell_text(row[i]).value_or("");
        }
        csv += '\n';
    }
    return csv;
}

void write_plot_files(const Plot& plot, const std::string& svg,
                      const std::filesystem::path& folder) {
    io::write_whole(folder / plot.id.with(".csv"), to_csv(plot));
    if (!svg.empty()) {
        io::write_whole(folder / plot.id.with(".svg"), svg);
    }
}

void check_picture_name(const std::string& file) {
    const std::filesystem::path ending = std::filesystem::path(file).extension();
    require(ending == ".svg" || ending == ".png" || ending == ".pdf",
            file + " is neither .svg, .png nor .pdf", "name the file so");
}

std::string picture_file(const std::vector<Plot>& plots, const std::string& file, double width_mm) {
    const std::string ending = std::filesystem::path(file).extension();
    const std::string svg = draw_svg(plots, width_mm);
    return ending == ".svg" ? svg : converted_svg(svg, ending.substr(1));
}

} // namespace edgeproof::report

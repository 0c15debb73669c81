// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/slip_table.hpp"
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"

#include <filesystem>
#include <memory>

namespace edgeproof::cli {
namespace {

constexpr const char* slip_paper = "moore-hills";

struct SlipTableRequest {
    std::string tolerances = "1%,5%,10%";
    std::string terms = "1";
    std::string digits = "10";
    std::string format = "csv";
    std::string out;
    std::string figures;
};

void draw_slip_figures(const std::string& folder) {
    const auto gnuplot = report::find_gnuplot();
    if (!gnuplot) {
        throw InputError("there is no gnuplot to draw figures", "install gnuplot-nox, or leave "
                                                                "--figures out");
    }
    const PrecisionScope scope(report::figure_digits + 10);
    for (const report::Plot& plot : report::slip_plots(slip_paper)) {
        write_plot_files(plot, draw_svg(plot, *gnuplot), folder);
    }
}

int slip_table(const SlipTableRequest& o) {
    const report::TableFormat format = format_of(o.format);
    io::check_output(o.out);
    if (!o.figures.empty()) {
        io::check_folder(o.figures); // the folder is made when there is something to write
    }
    report::SlipTableOptions options;
    for (std::size_t at = 0; at <= o.tolerances.size();) {
        const std::size_t comma = std::min(o.tolerances.find(',', at), o.tolerances.size());
        const std::string text = o.tolerances.substr(at, comma - at);
        (void)tolerance_of(text);
        options.tolerances.push_back(text);
        at = comma + 1;
    }
    options.terms = numbers_of_terms("--terms", o.terms);
    options.digits.count = static_cast<unsigned>(whole_number("--digits", o.digits, 2, 1000));
    Progress progress("profiles");
    options.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
    const report::Table table = report::slip_table(slip_paper, options);
    if (!o.figures.empty()) {
        draw_slip_figures(o.figures);
    }
    io::write_output(o.out.empty() ? "-" : o.out, write_table(table, format));
    return 0;
}

} // namespace

void add_slip_table(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand(
        "slip-table", "up to which Q/(f P) the first terms of a slip zone's size are good enough, "
                      "for the profiles of the literature");
    auto o = std::make_shared<SlipTableRequest>();
    sub->add_option("--tolerance", o->tolerances, "tolerances, such as 1%,5%,10%")
        ->capture_default_str();
    sub->add_option("--terms", o->terms, "numbers of terms, such as 1,2,3")->capture_default_str();
    sub->add_option("--digits", o->digits, "significant digits")->capture_default_str();
    sub->add_option("--format", o->format, "csv, json, md or tex")->capture_default_str();
    sub->add_option("--out", o->out,
                    "write to this file, whole or not at all (-: standard output)");
    sub->add_option("--figures", o->figures,
                    "also draw the sizes against Q/(f P), an .svg and a .csv a profile and edge, "
                    "into this folder");
    sub->callback([o, &code] { code = slip_table(*o); });
}

} // namespace edgeproof::cli

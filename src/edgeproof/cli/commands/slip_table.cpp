// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/figures/slip_table.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/report/figures/figures_svg.hpp"

#include <filesystem>

namespace edgeproof::cli {
namespace {

constexpr const char* slip_paper = "moore-hills";

struct SlipTableRequest : OutputOptions {
    std::string tolerances = "1%,5%,10%";
    std::string terms = "1";
    std::string digits = "10";
    std::string figures;
};

void draw_slip_figures(const std::string& folder) {
    const PrecisionScope scope(report::figure_digits + 10);
    for (const report::Plot& plot : report::slip_plots(slip_paper)) {
        write_plot_files(plot, report::draw_svg({plot}), folder);
    }
}

int slip_table(const SlipTableRequest& o) {
    (void)format_of(o.format);
    io::check_output(o.out);
    if (!o.figures.empty()) {
        io::check_folder(o.figures); // the folder is made when there is something to write
    }
    report::SlipTableOptions options;
    options.tolerances = parts_of(o.tolerances);
    std::ranges::for_each(options.tolerances, tolerance_of);
    options.terms = numbers_of_terms(o.terms);
    options.digits.count = digits_of(o.digits, 1000);
    const report::Table table = with_progress(
        "profiles", options.progress, [&] { return report::slip_table(slip_paper, options); });
    if (!o.figures.empty()) {
        draw_slip_figures(o.figures);
    }
    emit(table, o);
    return 0;
}

} // namespace

void add_slip_table(CLI::App& app, int& code) {
    auto [sub, o] = add_command<SlipTableRequest>(
        app, code, "slip-table",
        "up to which Q/(f P) the first terms of a slip zone's size are good enough, "
        "for the profiles of the literature",
        slip_table);
    add_list_option(sub, "--tolerance", o.tolerances, nullptr, "tolerances (default: 1%,5%,10%)");
    add_list_option(sub, "--terms", o.terms, nullptr, "numbers of terms (default: 1)");
    sub.add_option("--digits", o.digits, "significant digits")->capture_default_str();
    add_table_options(sub, o);
    sub.add_option("--figures,--out-dir", o.figures,
                   "also draw the sizes against Q/(f P), an .svg and a .csv a profile and edge, "
                   "into this folder");
}

} // namespace edgeproof::cli

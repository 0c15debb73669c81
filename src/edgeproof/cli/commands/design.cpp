// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/report/figures/design_figure.hpp"
#include "edgeproof/report/figures/figures_gnuplot.hpp"
#include "edgeproof/report/tables/design_table.hpp"
#include "edgeproof/scene/design/run_design.hpp"

namespace edgeproof::cli {
namespace {

struct DesignCommandOptions : SceneOptions {
    std::string gap = "1e-6";
    std::string figure;
};

Rational gap_of(const std::string& text) {
    const Rational gap = parse_decimal(text);
    if (gap <= 0) {
        throw InputError("--gap " + text + " is not positive", "write --gap 1e-6");
    }
    return gap;
}

int run(const DesignCommandOptions& o) {
    const scene::DesignScene design = scene::read_design(file_or_shipped(o.scene, shipped_designs));
    scene::Digits digits;
    digits.count = o.digits.empty() ? 30 : digits_of(o.digits, scene::most_design_digits);
    (void)format_of(o.format);
    io::check_output(o.out);
    if (!o.figure.empty()) {
        report::check_figure(o.figure);
    }
    if (!o.figure.empty() && design.parameters.size() != 1) {
        throw InputError("--figure draws the reach against one parameter",
                         "leave it out, or fix one of the two");
    }
    scene::DesignRunOptions options;
    options.search.digits = digits.count;
    options.search.gap = gap_of(o.gap);
    options.curve = !o.figure.empty();
    const scene::DesignResult result =
        with_progress("thousandths of the range", options.search.progress,
                      [&] { return run_design(design, options); });
    if (!o.figure.empty()) {
        report::write_design_figure(design, result, o.figure);
    }
    emit(report::design_table(design, result, options.search), o);
    return 0;
}

} // namespace

void add_design(CLI::App& app, int& code) {
    auto [sub, o] = add_command<DesignCommandOptions>(
        app, code, "design",
        "the parameters of a scene for which an approximation reaches farthest", run);
    sub.add_option("scene", o.scene, "the scene (TOML with [design])")->required();
    sub.add_option("--digits", o.digits, "significant digits (default: 30)");
    sub.add_option("--gap", o.gap,
                   "nothing else in the range does better by more: proved (default: 1e-6)");
    sub.add_option("--figure", o.figure, "reach against the parameter, as .svg or .csv");
    add_table_options(sub, o.format, o.out);
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/report/figures/figure_option.hpp"
#include "edgeproof/report/figures/figures_svg.hpp"
#include "edgeproof/report/tables/design_table.hpp"
#include "edgeproof/scene/design/design_file.hpp"

#include <fmt/format.h>

#include <regex>

namespace edgeproof::cli {
namespace {

struct DesignCommandOptions : SceneOptions {
    std::string gap = "1e-6";
    std::string maximise;
};

std::string text_of_file(const std::string& file) {
    return io::read_text(file, "scene (TOML)", io::most_toml_bytes);
}

/// Returns the text of a scene file for quantities; FROM..TO is a range.
std::string text_of_quantities(const scene::SceneEntries& entries) {
    std::string text = scene_text(entries);
    static const std::regex range("= \"([^\"]*[^\".])\\.\\.([^\".][^\"]*)\"");
    return std::regex_replace(text, range, "= { from = \"$1\", to = \"$2\" }");
}

scene::DesignScene design_of(const DesignCommandOptions& o) {
    scene::DesignQuestion asked;
    const auto set = [](auto& target, const std::string& text) {
        if (!text.empty()) {
            target = text;
        }
    };
    set(asked.edge, o.edges);
    set(asked.maximise, o.maximise);
    if (!o.terms.empty()) {
        asked.terms = static_cast<long>(whole_number("--terms", o.terms, 1, 12));
    }
    if (!o.tolerance.empty()) {
        (void)tolerance_of(o.tolerance);
        asked.tolerance = o.tolerance;
    }
    if (!is_by_quantities(o)) {
        const std::string file = file_or_shipped(o.scene, shipped_designs);
        return scene::parse_design(text_of_file(file), io::input_name(file), asked);
    }
    if (o.tolerance.empty()) {
        throw InputError("no tolerance is given", "add --tolerance 1%");
    }
    if (o.maximise.empty()) {
        asked.maximise = "first_exit";
    }
    o.as_file = text_of_quantities(entries_of(o));
    try {
        return scene::parse_design(o.as_file, "command line", asked);
    } catch (const InputError& error) { // the line is one of the text above
        throw InputError(error.problem(), error.instead());
    }
}

Rational gap_of(const std::string& text) {
    const Rational gap = parse_decimal(text);
    if (gap <= 0) {
        throw InputError("--gap " + text + " is not positive", "write --gap 1e-6");
    }
    return gap;
}

int run(const DesignCommandOptions& o) {
    const scene::DesignScene design = design_of(o);
    scene::Digits digits;
    digits.count = !o.digits.empty() ? digits_of(o.digits, scene::most_design_digits)
                   : o.is_short()    ? digits_of_short_answer
                                     : 30;
    (void)format_of(o.format);
    io::check_output(o.out);
    if (!o.figure.empty()) {
        report::check_figure(o.figure);
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
    report::Table table = report::design_table(design, result, options.search);
    table.asked = fmt::format("the best value for the reach of {} term{} within {}", design.terms,
                              design.terms == 1 ? "" : "s", percent_text(design.tolerance));
    emit(table, o);
    return 0;
}

} // namespace

void add_design(CLI::App& app, int& code) {
    auto [sub, o] = add_command<DesignCommandOptions>(
        app, code, "design", "the parameter of a scene for which an approximation reaches farthest",
        run);
    add_given_scene(sub, o);
    sub.get_option("scene")->description("the scene (TOML with [design]); -: standard input");
    sub.get_option("--terms")->description("number of terms (default: the scene's, else 1)");
    for (const char* const none : {"--quantity", "--u", "--x", "--process-zone"}) {
        sub.remove_option(sub.get_option(none)); // what [design] asks has other names
    }
    add_tolerance_option(sub, o, " (default: the scene's)");
    sub.add_option("--maximise", o.maximise,
                   "what the approximation is to reach (default: the scene's, else first_exit)")
        ->type_name("first_exit|measure");
    sub.add_option("--digits", o.digits, "significant digits (default: 30; 6 on a terminal)");
    sub.add_option("--gap", o.gap,
                   "nothing else in the range does better by more: proved (default: 1e-6)");
    sub.add_option("--figure", o.figure, "reach against the parameter, as .svg or .csv");
    add_table_options(sub, o);
    sub.footer("A scene by its quantities has one range: --t 0..0.9.");
}

} // namespace edgeproof::cli

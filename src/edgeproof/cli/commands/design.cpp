// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/cli/shipped_file.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/report/figures/design_figure.hpp"
#include "edgeproof/scene/design/run_design.hpp"

#include <memory>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_design_digits = 1000;

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

const char* text_of(contact::BestReach::Kind kind) {
    using How = contact::BestReach::Kind;
    switch (kind) {
    case How::touching:
        return "an extremum of the error touches the tolerance";
    case How::smooth:
        return "a maximum of the reach";
    case How::two_edges:
        return "both edges reach equally far";
    case How::end_of_range:
        return "an end of the range";
    case How::everywhere:
        return "within the tolerance all over the part";
    case How::box:
        break;
    }
    return "the best of the values tried";
}

std::string reach_note(const scene::DesignScene& design) {
    if (design.objective == scene::DesignObjective::slip_load) {
        return "the Q/(f P) up to which the terms of the slip zone's size are within the tolerance "
               "of it, P and bulk_tension/Q held; 1: up to full sliding";
    }
    return std::string(design.objective == scene::DesignObjective::measure
                           ? "the length of all places at which the terms are within the tolerance"
                           : "the first distance from the edge at which the terms are off by the "
                             "tolerance") +
           (design.unit == contact::ReachUnit::fraction ? ", as a fraction of a + b" : "");
}

int run(const DesignCommandOptions& o) {
    const scene::DesignScene design = scene::read_design(file_or_shipped(o.scene, shipped_designs));
    scene::Digits digits;
    digits.count =
        o.digits.empty()
            ? 30
            : static_cast<unsigned>(whole_number("--digits", o.digits, 2, most_design_digits));
    io::check_output(o.out);
    io::check_output(o.figure);
    if (!o.figure.empty() && design.parameters.size() != 1) {
        throw InputError("--figure draws the reach against one parameter",
                         "leave it out, or fix one of the two");
    }
    scene::DesignRunOptions options;
    options.search.digits = digits.count;
    options.search.gap = gap_of(o.gap);
    options.curve = !o.figure.empty();
    Progress progress("thousandths of the range");
    options.search.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
    const scene::DesignResult result = run_design(design, options);
    const contact::BestReach& best = result.best;
    const bool proved = best.proved && result.missing.empty();
    const auto text = [&](const Ball& x) {
        return printed(scene::BoundedValue{x, proved, "", {}}, digits);
    };
    report::Table table;
    table.title = design.title;
    table.facts = {{"scene", design.file},
                   {"digits", std::to_string(digits.count)},
                   {"tolerance", design.tolerance.text()},
                   {"terms", std::to_string(design.terms)},
                   {"best", text_of(best.kind)},
                   {"proof", proved ? "yes" : "no (estimate): " + result.missing}};
    if (proved) {
        table.facts.push_back({"boxes", std::to_string(best.boxes)});
        std::string at;
        for (const Rational& q : best.shown_at) {
            at += (at.empty() ? "" : ", ") + to_decimal(q, 20, Rounding::nearest);
        }
        table.facts.push_back({"reach shown at", at});
    }
    if (best.touches_at) {
        table.facts.push_back({"touches at", text(*best.touches_at).text});
    }
    if (result.printed_reach) {
        std::string at;
        for (const scene::DesignScene::Parameter& p : design.parameters) {
            at += (at.empty() ? "" : ", ") + exact_text(*p.printed);
        }
        table.facts.push_back({"printed", at});
        table.facts.push_back({"reach at printed", text(*result.printed_reach).text});
        table.facts.push_back({"falls short by", text(*result.falls_short).text});
    }
    table.notes = {
        "reach: " + reach_note(design),
        proved ? "gap: no other value in the range reaches farther by more than this: proved by "
                 "branch and bound"
               : "value and reach are estimates, and no gap is proved"};
    if (!best.attained) {
        table.notes.emplace_back("the reach jumps at the value: it is approached from one side and "
                                 "not attained");
    }
    table.columns = {{"parameter", report::Column::Kind::text},
                     {"value"},
                     {"value_bound"},
                     {"reach"},
                     {"reach_bound"},
                     {"gap"}};
    const scene::PrintedValue reach = text(best.reach);
    for (std::size_t i = 0; i < design.parameters.size(); ++i) {
        const scene::PrintedValue value = text(best.value[i]);
        table.rows.push_back({design.parameters[i].name, value.text, value.bound, reach.text,
                              reach.bound, proved ? exact_text(options.search.gap) : ""});
    }
    if (!o.figure.empty()) {
        report::write_design_figure(design, result, o.figure);
    }
    emit(table, o);
    return 0;
}

} // namespace

void add_design(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand(
        "design", "the parameters of a scene for which an approximation reaches farthest");
    auto o = std::make_shared<DesignCommandOptions>();
    sub->add_option("scene", o->scene, "the scene (TOML with [design])")->required();
    sub->add_option("--digits", o->digits, "significant digits (default: 30)");
    sub->add_option("--gap", o->gap,
                    "nothing else in the range does better by more: proved (default: 1e-6)");
    sub->add_option("--figure", o->figure, "reach against the parameter, as .svg or .csv");
    sub->add_option("--format", o->format, "csv, json, md or tex")->capture_default_str();
    sub->add_option("--out", o->out,
                    "write to this file, whole or not at all (-: standard output)");
    sub->callback([o, &code] { code = run(*o); });
}

} // namespace edgeproof::cli

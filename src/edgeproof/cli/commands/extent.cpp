// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <memory>

namespace edgeproof::cli {
namespace {

struct ExtentOptions : SceneOptions {
    std::string tolerance;
    std::string terms;
};

formula::Exact tolerance_of(const std::string& text) {
    try {
        return scene::parse_tolerance(text);
    } catch (const InputError& error) {
        throw InputError("--tolerance " + text + ": " + error.problem(), error.instead());
    }
}

int extent(const ExtentOptions& o) {
    scene::Scene scene = asked_scene(o);
    scene.ask.edges = asked_edges(o);
    if (!o.tolerance.empty()) {
        scene.ask.tolerance = tolerance_of(o.tolerance);
    } else if (!scene.ask.tolerance) {
        throw InputError("no tolerance is given",
                         "add --tolerance 1%, or tolerance = \"1%\" to [ask]")
            .at(scene.file, scene.ask_line);
    }
    if (!o.terms.empty()) {
        scene.ask.terms = numbers_of_terms("--terms", o.terms);
    } else if (scene.ask.terms.empty()) {
        scene.ask.terms = {1, 2, 3};
    }
    scene.ask.quantities = {scene::QuantityGroup::extent};
    const scene::SceneResult result = done(scene);
    report::Table table = values_table(scene, result);
    table.facts.push_back(
        {"tolerance", o.tolerance.empty() ? scene.ask.tolerance->text() : o.tolerance});
    if (scene.ask.process_zone) {
        table.facts.push_back({"process_zone", scene.ask.process_zone->text()});
    }
    table.notes = {
        "first_exit: the first distance from the edge at which n terms are off by the tolerance; "
        "measure: the length of all places where they are not; the fractions are of a + b",
        "crossings: every distance at which the error passes the tolerance; that there are no more "
        "is proved, unless the route says scan: then it is sampled, and the bounds are estimates"};
    if (std::any_of(result.extents.begin(), result.extents.end(),
                    [](const scene::ExtentValues& e) { return !e.leaves; })) {
        table.notes.emplace_back("no first_exit: n terms stay within the tolerance all over the "
                                 "part of the contact that is looked at");
    }
    if (scene.ask.process_zone) {
        table.notes.emplace_back("covers_zone: yes where n terms stay within the tolerance all "
                                 "through the process zone");
    }
    const ValueColumns value(scene);
    table.columns = {{"edge", report::Column::Kind::text}, {"n", report::Column::Kind::count}};
    value.add(table.columns, "first_exit");
    table.columns.push_back({"first_exit_fraction"});
    value.add(table.columns, "measure");
    table.columns.push_back({"measure_fraction"});
    if (scene.ask.process_zone) {
        table.columns.push_back({"covers_zone", report::Column::Kind::text});
    }
    table.columns.push_back({"crossings", report::Column::Kind::text});
    table.columns.push_back({"route", report::Column::Kind::text});
    for (const scene::ExtentValues& e : result.extents) {
        const auto text = [&](const scene::BoundedValue& v) {
            return printed(v, scene.ask.digits).text;
        };
        std::vector<std::string> row{scene::edge_name(e.edge), std::to_string(e.n)};
        if (e.leaves) {
            value.add(row, e.first_exit, false);
            row.push_back(text(e.first_exit_fraction));
        } else {
            value.add_none(row, false);
            row.emplace_back();
        }
        value.add(row, e.measure, false);
        row.push_back(text(e.measure_fraction));
        if (e.covers_zone) {
            row.emplace_back(*e.covers_zone ? "yes" : "no");
        }
        std::string crossings;
        for (const scene::BoundedValue& u : e.crossings) {
            crossings += (crossings.empty() ? "" : " ") + text(u);
        }
        row.push_back(crossings.empty() ? "none" : crossings);
        row.push_back(e.first_exit.how());
        table.rows.push_back(std::move(row));
    }
    emit(table, o);
    return 0;
}

} // namespace

void add_extent(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand(
        "extent", "how far from each edge n terms stay within a tolerance of the pressure");
    auto o = std::make_shared<ExtentOptions>();
    add_scene_options(*sub, *o);
    add_edge_option(*sub, *o);
    sub->add_option("--tolerance", o->tolerance, "1%, 0.01 or 1/100 (default: the scene's)");
    sub->add_option("--terms", o->terms,
                    "numbers of terms, such as 1,2,3 (default: the scene's, else these)");
    sub->callback([o, &code] { code = extent(*o); });
}

} // namespace edgeproof::cli

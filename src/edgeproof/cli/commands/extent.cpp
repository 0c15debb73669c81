// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <memory>

namespace edgeproof::cli {
namespace {

struct ExtentOptions : SceneOptions {
    std::string figure;
};

int extent(const ExtentOptions& o) {
    if (!o.figure.empty()) {
        report::check_picture_name(o.figure);
        io::check_output(o.figure);
    }
    scene::Scene scene = asked_scene(o);
    ask_at_edges(scene, o);
    if (!scene.ask.tolerance) {
        throw InputError("no tolerance is given",
                         "add --tolerance 1%, or tolerance = \"1%\" to [ask]")
            .at(scene.file, scene.ask_line);
    }
    ask_terms(scene);
    ask_for(scene, o, scene::QuantityGroup::extent, {scene::QuantityGroup::contact});
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
    if (!o.figure.empty()) {
        io::write_whole(o.figure,
                        report::picture_file(picture_of(scene), title_of(scene), o.figure));
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
    add_tolerance_option(*sub, *o, " (default: the scene's)");
    sub->add_option("--figure", o->figure,
                    "also draw the pressure and these terms (edgeproof plot) into this file: "
                    ".svg, .png, .pdf or .html");
    sub->footer("1, 2 and 3 terms at both edges unless --terms and --edge, or the scene, say "
                "which.");
    sub->callback([o, &code] { code = extent(*o); });
}

} // namespace edgeproof::cli

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
    if (std::ranges::any_of(result.rows, [](const scene::Row& row) { return !row.reached; })) {
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
    using scene::Quantity;
    const auto text = [&](const scene::BoundedValue& v) {
        return printed(v, scene.ask.digits).text;
    };
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::extent)) {
        for (const std::size_t n : scene.ask.terms) {
            const scene::Row& exit = edge.row(Quantity::extent, n);
            std::vector<std::string> row{scene::edge_name(edge.edge()), std::to_string(n)};
            if (exit.reached) {
                value.add(row, *exit.value, false);
                row.push_back(text(edge.at(Quantity::extent_fraction, n)));
            } else {
                value.add_none(row, false);
                row.emplace_back();
            }
            value.add(row, edge.at(Quantity::measure, n), false);
            row.push_back(text(edge.at(Quantity::measure_fraction, n)));
            if (scene.ask.process_zone) {
                row.emplace_back(covers_zone(scene, *exit.value) ? "yes" : "no");
            }
            std::string crossings;
            for (std::size_t j = 0; const auto* u = edge.find(Quantity::crossing, n, j); ++j) {
                crossings += (crossings.empty() ? "" : " ") + text(*u->value);
            }
            row.push_back(crossings.empty() ? "none" : crossings);
            row.push_back(exit.value->how());
            table.rows.push_back(std::move(row));
        }
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <algorithm>

namespace edgeproof::cli {
namespace {

int extent(const SceneOptions& o) {
    check_figure_option(o);
    scene::Scene scene = asked_scene(o);
    ask_at_edges(scene, o);
    if (!scene.ask.tolerance) {
        throw InputError("no tolerance is given",
                         o.by_quantities ? "add --tolerance 1%"
                                         : "add --tolerance 1%, or tolerance = \"1%\" to [ask]")
            .at(scene.file, scene.ask_line);
    }
    ask_terms(scene);
    ask_for(scene, o, scene::QuantityGroup::extent, {scene::QuantityGroup::contact});
    const scene::SceneResult result = done(scene, o);
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
    table.asked = "how far from the edge the first n terms are within " +
                  percent_text(*scene.ask.tolerance) + " of the pressure";
    struct Terms {
        scene::RowsAt edge;
        std::size_t n;
    };
    std::vector<Terms> rows;
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::extent)) {
        for (const std::size_t n : scene.ask.terms) {
            rows.push_back({edge, n});
        }
    }
    using scene::Quantity;
    using Kind = report::Column::Kind;
    const auto text = [&](const scene::BoundedValue& v) {
        return printed(v, scene.ask.digits).text;
    };
    const auto exit = [](const Terms& t) -> const scene::Row& {
        return t.edge.row(Quantity::extent, t.n);
    };
    Columns<Terms> columns(scene);
    using Shown = report::Column::Shown;
    const std::string length = unit_of(scene, Quantity::extent);
    columns.add("edge", Kind::text, [](const Terms& t) { return scene::edge_name(t.edge.edge()); })
        .phrase = "{} edge";
    columns.add("n", Kind::count, [](const Terms& t) { return std::to_string(t.n); });
    report::Column& first = columns.add_value("first_exit", "", [&](const Terms& t) {
        return exit(t).reached ? exit(t).value : std::nullopt;
    });
    first.phrase = "up to u = {}";
    first.unit = length;
    columns
        .add("first_exit_fraction", Kind::number,
             [&](const Terms& t) {
                 return exit(t).reached ? text(t.edge.at(Quantity::extent_fraction, t.n)) : "";
             })
        .phrase = "{} of a + b";
    columns
        .add("everywhere", Kind::text,
             [&](const Terms& t) {
                 return exit(t).reached ? "" : "in the whole part that is looked at";
             })
        .shown = Shown::on_terminal_only;
    columns
        .add_value("measure", "", [](const Terms& t) { return t.edge.at(Quantity::measure, t.n); })
        .shown = Shown::not_on_terminal;
    columns
        .add("measure_fraction", Kind::number,
             [&](const Terms& t) { return text(t.edge.at(Quantity::measure_fraction, t.n)); })
        .shown = Shown::not_on_terminal;
    if (scene.ask.process_zone) {
        columns
            .add("covers_zone", Kind::text,
                 [&](const Terms& t) { return covers_zone(scene, *exit(t).value) ? "yes" : "no"; })
            .phrase = "covers the process zone: {}";
    }
    columns
        .add("crossings", Kind::text,
             [&](const Terms& t) {
                 std::string crossings;
                 for (std::size_t j = 0; const auto* u = t.edge.find(Quantity::crossing, t.n, j);
                      ++j) {
                     crossings += (crossings.empty() ? "" : " ") + text(*u->value);
                 }
                 return crossings.empty() ? "none" : crossings;
             })
        .shown = Shown::not_on_terminal;
    columns.add("route", Kind::text, [&](const Terms& t) { return exit(t).value->how(); }).role =
        report::Column::Role::route;
    columns.write(table, rows);
    draw_figure_option(scene, o);
    emit(table, o);
    return 0;
}

} // namespace

void add_extent(CLI::App& app, int& code) {
    auto [sub, o] = add_command<SceneOptions>(
        app, code, "extent",
        "how far from each edge n terms stay within a tolerance of the pressure", extent);
    add_scene_options(sub, o);
    add_tolerance_option(sub, o, " (default: the scene's)");
    add_figure_option(sub, o);
    sub.footer("1, 2 and 3 terms at both edges unless --terms and --edge, or the scene, say "
               "which.");
}

} // namespace edgeproof::cli

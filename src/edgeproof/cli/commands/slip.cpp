// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/precision/error.hpp"

#include <memory>

namespace edgeproof::cli {
namespace {

void add_reach(std::vector<std::string>& row, const ValueColumns& value, const scene::Row& load) {
    if (load.value) {
        value.add(row, *load.value, false);
    } else {
        value.add_none(row, false);
    }
    row.push_back(!load.value ? "undecided" : load.reached ? load.value->how() : "full sliding");
}

int slip(const SceneOptions& o) {
    scene::Scene scene = asked_scene(o);
    ask_for(scene, o, scene::QuantityGroup::slip, {scene::QuantityGroup::contact});
    ask_at_edges(scene, o);
    if (!scene.slips()) {
        throw InputError("the scene has no friction, so that nothing slips",
                         "add friction = \"0.6\" to [shear], in addition to Q")
            .at(scene.file, scene.load_line);
    }
    ask_terms(scene);
    const scene::SceneResult result = done(scene);
    report::Table table;
    table.title = scene.title;
    table.facts = facts_of(scene, result);
    add_slip_facts(table.facts, scene, result);
    table.notes = {"d: size of the slip zone at the edge, |d - exact| <= d_bound; the rest of the "
                   "contact, -stick_b < x < stick_a, sticks",
                   "d_n: the first n terms of d in powers of Q/f, P and bulk_tension/Q held; d_1 = "
                   "2 s_0/(f c_0); rel_n: |1 - d_n/d|"};
    if (scene.ask.tolerance) {
        table.notes.push_back("slip_load_n: the Q/(f P) up to which |1 - d_n/d| stays within " +
                              scene.ask.tolerance->text() +
                              ", P and bulk_tension/Q held; 1: up to full sliding");
    }
    if (result.find(scene::Quantity::cycle_energy) != nullptr) {
        table.notes.emplace_back("cycle_energy: what friction takes, per unit length, in a cycle "
                                 "from -Q to Q and back, P held");
    }
    table.notes.push_back(bound_note(result.plan));
    const ValueColumns value(scene);
    table.columns = {{"edge", report::Column::Kind::text}};
    value.add(table.columns, "d", "route");
    for (const std::size_t n : scene.ask.terms) {
        table.columns.push_back({"d_" + std::to_string(n)});
        table.columns.push_back({"rel_" + std::to_string(n)});
    }
    for (const std::size_t n : scene.ask.tolerance ? scene.ask.terms : std::vector<std::size_t>{}) {
        const std::string name = "slip_load_" + std::to_string(n);
        value.add(table.columns, name);
        table.columns.push_back({name + "_route", report::Column::Kind::text});
    }
    using scene::Quantity;
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::slip)) {
        std::vector<std::string> row{scene::edge_name(edge.edge())};
        scene::BoundedValue size = edge.at(Quantity::slip);
        std::string estimates;
        for (const std::size_t n : scene.ask.terms) {
            if (size.proved && !(edge.at(Quantity::slip_terms, n).proved &&
                                 edge.at(Quantity::slip_rel, n).proved)) {
                estimates += (estimates.empty() ? "d_" : ", d_") + std::to_string(n) + ", rel_" +
                             std::to_string(n);
            }
        }
        size.route += estimates.empty() ? "" : " (estimate: " + estimates + ")";
        value.add(row, size, true);
        for (const std::size_t n : scene.ask.terms) {
            row.push_back(printed(edge.at(Quantity::slip_terms, n), scene.ask.digits).text);
            row.push_back(printed(edge.at(Quantity::slip_rel, n), result.plan.error_digits()).text);
        }
        for (const std::size_t n : scene.ask.terms) {
            if (scene.ask.tolerance) {
                add_reach(row, value, edge.row(Quantity::slip_load, n));
            }
        }
        table.rows.push_back(std::move(row));
    }
    emit(table, o);
    return 0;
}

} // namespace

void add_slip(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand(
        "slip", "the slip zones of a scene with friction, exact and by n terms of their series");
    auto o = std::make_shared<SceneOptions>();
    add_scene_options(*sub, *o);
    add_tolerance_option(*sub, *o,
                         ": also find the Q/(f P) up to which n terms stay within it (default: "
                         "the scene's, else that is not looked for)");
    sub->footer(
        "P is held, then Q (and bulk_tension) are applied. What slips has |q| = f p in the\n"
        "direction of Q; what sticks is strained alike in both bodies. [shear] of the scene gives\n"
        "Q, bulk_tension and friction. See docs/partial-slip.md.");
    sub->callback([o, &code] { code = slip(*o); });
}

} // namespace edgeproof::cli

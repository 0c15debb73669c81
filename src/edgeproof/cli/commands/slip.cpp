// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

namespace edgeproof::cli {
namespace {

/// Returns the size of the slip zone. Its route names the values by n terms that are not proved
/// although this value is.
scene::BoundedValue marked_size(const scene::RowsAt& edge, const std::vector<std::size_t>& terms) {
    scene::BoundedValue size = edge.at(scene::Quantity::slip);
    std::string estimates;
    for (const std::size_t n : terms) {
        if (size.proved && !(edge.at(scene::Quantity::slip_terms, n).proved &&
                             edge.at(scene::Quantity::slip_rel, n).proved)) {
            estimates += (estimates.empty() ? "d_" : ", d_") + std::to_string(n) + ", rel_" +
                         std::to_string(n);
        }
    }
    size.route += estimates.empty() ? "" : " (estimate: " + estimates + ")";
    return size;
}

/// Adds a remark for each size by n terms that is negative.
void remark_negative_sizes(std::vector<std::string>& remarks, const scene::RowsAt& edge,
                           const std::vector<std::size_t>& terms) {
    for (const std::size_t n : terms) {
        if (certainly_negative(edge.at(scene::Quantity::slip_terms, n).value)) {
            remarks.push_back("d_" + std::to_string(n) + " is negative at the " +
                              scene::edge_name(edge.edge()) +
                              " edge: with this number of terms the series gives no slip zone; "
                              "use d, or more terms");
        }
    }
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
    const bool series = !scene.history; // the series is that of one step of Q
    if (!series) {
        const std::string why =
            scene.history ? "a load history" : "an axisymmetric contact"; // no series
        refuse_options({{"--terms", o.terms}, {"--tolerance", o.tolerance}},
                       "the slip zones of " + why + " have no series");
        scene.ask.terms.clear();
        scene.ask.tolerance.reset();
    } else {
        ask_terms(scene);
    }
    const scene::SceneResult result = done(scene, o);
    report::Table table = values_table(scene, result);
    add_slip_facts(table.facts, scene, result);
    table.notes = {"d: size of the slip zone at the edge, |d - exact| <= d_bound; the rest of the "
                   "contact, -stick_b < x < stick_a, sticks"};
    if (series) {
        table.notes.emplace_back(
            scene.round ? "d_n: the first n terms of d in powers of Q/f, P held; rel_n: |1 - d_n/d|"
                        : "d_n: the first n terms of d in powers of Q/f, P and bulk_tension/Q "
                          "held; d_1 = 2 s_0/(f c_0); rel_n: |1 - d_n/d|");
    }
    if (series && scene.ask.tolerance) {
        table.notes.push_back("slip_load_n: the Q/(f P) up to which |1 - d_n/d| stays within " +
                              scene.ask.tolerance->text() +
                              ", P and bulk_tension/Q held; 1: up to full sliding");
    }
    if (result.find(scene::Quantity::step_energy) != nullptr) {
        table.notes.emplace_back("step_energy: what friction takes, per unit length, in the last "
                                 "step");
    }
    if (result.find(scene::Quantity::cycle_energy) != nullptr) {
        table.notes.emplace_back(
            std::string("cycle_energy: what friction takes") +
            (scene.round ? "" : ", per unit length,") +
            (!scene.history          ? " in a cycle from -Q to Q and back, P held"
             : scene.history->steady ? " in the last pass of the repeated steps; it ends in the "
                                       "state in which it began, so that all later passes are alike"
                                     : " in the last pass of the repeated steps; the state is not "
                                       "steady yet"));
    }
    table.asked =
        "size d of the slip zone at each edge, and d_n by the first n terms of its series";
    table.remarks.push_back(bound_note());
    using scene::Quantity;
    using scene::RowsAt;
    using Kind = report::Column::Kind;
    const std::vector<std::size_t>& terms = scene.ask.terms;
    Columns<RowsAt> columns(scene);
    columns.add("edge", Kind::text, [](const RowsAt& e) { return scene::edge_name(e.edge()); })
        .phrase = "{} edge";
    const std::string length = unit_of(scene, Quantity::slip);
    columns.add_value("d", "route", [&](const RowsAt& e) { return marked_size(e, terms); }).unit =
        length;
    for (const std::size_t n : terms) {
        columns
            .add("d_" + std::to_string(n), Kind::number,
                 [&scene, n](const RowsAt& e) {
                     return printed(e.at(Quantity::slip_terms, n), scene.ask.digits).text;
                 })
            .unit = length;
        columns.add("rel_" + std::to_string(n), Kind::number, [&result, n](const RowsAt& e) {
            return printed(e.at(Quantity::slip_rel, n), result.plan.error_digits()).text;
        });
    }
    for (const std::size_t n : scene.ask.tolerance ? terms : std::vector<std::size_t>{}) {
        const std::string name = "slip_load_" + std::to_string(n);
        columns.add_value(name, "",
                          [n](const RowsAt& e) { return e.row(Quantity::slip_load, n).value; });
        columns
            .add(name + "_route", Kind::text,
                 [n](const RowsAt& e) -> std::string {
                     const scene::Row& load = e.row(Quantity::slip_load, n);
                     return !load.value    ? "undecided"
                            : load.reached ? load.value->how()
                                           : "full sliding";
                 })
            .role = report::Column::Role::route;
    }
    const std::vector<RowsAt> edges = result.at_edges(scene::QuantityGroup::slip);
    for (const RowsAt& edge : edges) {
        remark_negative_sizes(table.remarks, edge, terms);
    }
    columns.write(table, edges);
    emit(table, o);
    return 0;
}

} // namespace

void add_slip(CLI::App& app, int& code) {
    auto [sub, o] = add_command<SceneOptions>(
        app, code, "slip",
        "the slip zones of a scene with friction, exact and by n terms of their series", slip);
    add_scene_options(sub, o);
    add_tolerance_option(sub, o,
                         ": also find the Q/(f P) up to which n terms stay within it (default: "
                         "the scene's, else that is not looked for)");
    sub.footer(
        "P is held, then Q (and bulk_tension) are applied. What slips has |q| = f p in the\n"
        "direction of Q; what sticks is strained alike in both bodies. [shear] of the scene gives\n"
        "Q, bulk_tension and friction. See docs/partial-slip.md.");
}

} // namespace edgeproof::cli

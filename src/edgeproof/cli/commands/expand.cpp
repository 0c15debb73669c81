// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/stress_along_ray.hpp"
#include "edgeproof/cli/scene_command.hpp"

#include <utility>

namespace edgeproof::cli {
namespace {

/// Returns k + half_powers/2 as a quotient.
std::string power_text(std::size_t k, int half_powers) {
    return std::to_string(2 * static_cast<long>(k) + half_powers) + "/2";
}

int expand(const RayOptions& o) {
    if (along_ray(o)) {
        return expand_stresses(o);
    }
    check_figure_option(o);
    scene::Scene scene = asked_scene(o);
    ask_at_edges(scene, o);
    ask_terms(scene);
    scene.ask.terms = {scene.ask.most_terms()};
    ask_for(scene, o, scene::QuantityGroup::coefficients, {scene::QuantityGroup::contact});
    const scene::SceneResult result = done(scene, o);
    report::Table table = values_table(scene, result);
    table.notes = {"p = sum of c_k u^(k + 1/2) at the distance u from the edge; |value - exact| <= "
                   "bound",
                   "c_0, c_1, c_2 are the L_I, M_I, N_I of the literature"};
    if (result.plan.expand_shear && !scene.together()) {
        table.notes.emplace_back("q = sum of s_k u^(k - 1/2): s_0, s_1, s_2 are K_II, L_II, M_II");
    } else if (result.plan.expand_shear) {
        table.notes.emplace_back("q = (Q/P) p = sum of s_k u^(k + 1/2)");
    }
    table.asked = "coefficients of " +
                  std::string(table.notes.front().substr(0, table.notes.front().find(';')));
    table.remarks.push_back(bound_note());
    struct Coefficient {
        const scene::Row& row;
        int half_powers;
    };
    std::vector<Coefficient> coefficients;
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::coefficients)) {
        for (const auto& [quantity, half_powers] :
             {std::pair{scene::Quantity::c, 1},
              std::pair{scene::Quantity::s, scene::shear_half_powers(scene)}}) {
            for (const scene::Row& row : edge) {
                if (row.asked.quantity == quantity) {
                    coefficients.push_back({row, half_powers});
                }
            }
        }
    }
    using Kind = report::Column::Kind;
    Columns<Coefficient> columns(scene);
    using Shown = report::Column::Shown;
    columns
        .add("edge", Kind::text, [](const auto& c) { return scene::edge_name(c.row.asked.edge); })
        .phrase = "{} edge";
    columns.add("coefficient", Kind::text, [](const auto& c) { return symbol_of(c.row.asked); })
        .phrase = "{} =";
    columns.add("k", Kind::count, [](const auto& c) { return std::to_string(c.row.asked.k); })
        .shown = Shown::not_on_terminal;
    columns
        .add("power", Kind::text,
             [](const auto& c) { return power_text(c.row.asked.k, c.half_powers); })
        .shown = Shown::not_on_terminal;
    columns.add_value("value", "route", [](const auto& c) { return c.row.value; }).phrase = "{}";
    report::Column& unit = columns.add("unit", Kind::text, [&scene](const auto& c) {
        return unit_of(scene, c.row.asked.quantity, c.row.asked.k);
    });
    unit.phrase = "{}";
    unit.shown = Shown::on_terminal_only;
    columns.write(table, coefficients);
    table.columns[5].name = "bound"; // not value_bound
    draw_figure_option(scene, o);
    emit(table, o);
    return 0;
}

} // namespace

void add_expand(CLI::App& app, int& code) {
    auto [sub, o] = add_command<RayOptions>(
        app, code, "expand", "coefficients of the expansion at the edges, with bounds", expand);
    add_scene_options(sub, o);
    add_figure_option(sub, o);
    add_ray_options(sub, o);
    sub.footer("Of several numbers of --terms the greatest; 3 where none is given. Both edges "
               "unless --edge or the scene says which.");
}

} // namespace edgeproof::cli

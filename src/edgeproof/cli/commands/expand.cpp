// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"

#include <memory>
#include <utility>

namespace edgeproof::cli {
namespace {

/// Returns k + half_powers/2 as a quotient.
std::string power_text(std::size_t k, int half_powers) {
    return std::to_string(2 * static_cast<long>(k) + half_powers) + "/2";
}

int expand(const SceneOptions& o) {
    scene::Scene scene = asked_scene(o);
    ask_at_edges(scene, o);
    ask_terms(scene);
    scene.ask.terms = {scene.ask.most_terms()};
    ask_for(scene, o, scene::QuantityGroup::coefficients, {scene::QuantityGroup::contact});
    const scene::SceneResult result = done(scene);
    report::Table table = values_table(scene, result);
    table.notes = {"p = sum of c_k u^(k + 1/2) at the distance u from the edge; |value - exact| <= "
                   "bound",
                   "c_0, c_1, c_2 are the L_I, M_I, N_I of the literature"};
    if (scene.shear && scene.shear->path == contact::LoadingPath::normal_first) {
        table.notes.emplace_back("q = sum of s_k u^(k - 1/2): s_0, s_1, s_2 are K_II, L_II, M_II");
    } else if (scene.shear) {
        table.notes.emplace_back("q = (Q/P) p = sum of s_k u^(k + 1/2)");
    }
    table.notes.push_back(bound_note(result.plan));
    const ValueColumns value(scene);
    table.columns = {{"edge", report::Column::Kind::text},
                     {"coefficient", report::Column::Kind::text},
                     {"k", report::Column::Kind::count},
                     {"power", report::Column::Kind::text}};
    std::vector<report::Column> columns;
    value.add(columns, "value", "route");
    columns[1].name = "bound";
    table.columns.insert(table.columns.end(), columns.begin(), columns.end());
    for (const scene::RowsAt& edge : result.at_edges(scene::QuantityGroup::coefficients)) {
        for (const auto& [quantity, half_powers] :
             {std::pair{scene::Quantity::c, 1},
              std::pair{scene::Quantity::s, scene::shear_half_powers(scene)}}) {
            for (const scene::Row& row : edge) {
                if (row.asked.quantity == quantity) {
                    table.rows.push_back({scene::edge_name(edge.edge()), symbol_of(row.asked),
                                          std::to_string(row.asked.k),
                                          power_text(row.asked.k, half_powers)});
                    value.add(table.rows.back(), *row.value, true);
                }
            }
        }
    }
    emit(table, o);
    return 0;
}

} // namespace

void add_expand(CLI::App& app, int& code) {
    CLI::App* sub =
        app.add_subcommand("expand", "coefficients of the expansion at the edges, with bounds");
    auto o = std::make_shared<SceneOptions>();
    add_scene_options(*sub, *o);
    sub->footer("Of several numbers of --terms the greatest; 3 where none is given. Both edges "
                "unless --edge or the scene says which.");
    sub->callback([o, &code] { code = expand(*o); });
}

} // namespace edgeproof::cli

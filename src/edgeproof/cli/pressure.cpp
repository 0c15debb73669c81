// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"

#include <memory>

namespace edgeproof::cli {
namespace {

std::vector<Column> columns_of(const Scene& scene, const Plan& plan) {
    const ValueColumns value(scene);
    std::vector<Column> columns{{"edge", Column::Kind::text}, {"u"}, {"x"}};
    const auto approximations = [&](const std::string& prefix) {
        for (const std::size_t n : plan.terms > 0 ? scene.ask.terms : std::vector<std::size_t>{}) {
            columns.push_back({prefix + "local_" + std::to_string(n)});
            columns.push_back({prefix + "rel_" + std::to_string(n)});
        }
    };
    value.add(columns, "p", "route");
    approximations("");
    if (plan.shear) {
        value.add(columns, "q", "q_route");
        approximations("q_");
    }
    return columns;
}

/// The value that a route column stands behind, with the names of what else its columns hold that
/// is not proved although the value is.
Vouched marked(const Vouched& value, const std::string& prefix, const Vouched& x,
               const std::vector<Approximation>& approximations) {
    std::string estimates = x.proved ? "" : "x";
    const auto add = [&](const char* name, const Approximation& a, const Vouched& v) {
        if (!v.proved) {
            estimates += (estimates.empty() ? "" : ", ") + prefix + name + std::to_string(a.n);
        }
    };
    for (const Approximation& a : approximations) {
        add("local_", a, a.local);
        add("rel_", a, a.relative_error);
    }
    Vouched all = value;
    if (value.proved && !estimates.empty()) {
        all.route += " (estimate: " + estimates + ")";
    }
    return all;
}

std::vector<std::string> row_of(const Scene& scene, const Plan& plan, const PointRow& point) {
    const ValueColumns value(scene);
    const Digits& digits = scene.ask.digits;
    std::vector<std::string> row{edge_name(point.edge), point.u.text(),
                                 printed(point.values.x, digits).text};
    const auto approximations = [&](const std::vector<Approximation>& list) {
        for (const Approximation& a : list) {
            row.push_back(printed(a.local, digits).text);
            row.push_back(printed(a.relative_error, plan.error_digits()).text);
        }
    };
    value.add(row, marked(*point.values.p, "", point.values.x, point.values.p_local), true);
    approximations(point.values.p_local);
    if (plan.shear) {
        value.add(row, marked(*point.values.q, "q_", point.values.x, point.values.q_local), true);
        approximations(point.values.q_local);
    }
    return row;
}

int pressure(const SceneOptions& o) {
    Scene scene = asked_scene(o);
    const bool contact = scene.ask.wants(Quantity::contact);
    const bool shear = scene.ask.wants(Quantity::shear);
    scene.ask.quantities = {Quantity::pressure};
    if (shear) {
        scene.ask.quantities.insert(Quantity::shear);
    }
    if (contact) {
        scene.ask.quantities.insert(Quantity::contact);
    }
    const SceneResult result = done(scene);
    Table table;
    table.title = scene.title;
    table.facts = facts_of(scene, result);
    table.notes = {"u: distance inwards from the edge; x: place; p: pressure, in the unit of the "
                   "contact modulus; |p - exact| <= p_bound"};
    if (result.plan.terms > 0) {
        table.notes.emplace_back(
            "local_n: the sum of the first n terms at that edge; rel_n: |1 - local_n/p|");
    }
    if (result.plan.shear) {
        table.notes.emplace_back(
            "q: shear traction under full stick, positive towards +x on the body "
            "that Q acts on; the q columns are as those of p");
    }
    table.notes.push_back(bound_note(result.plan));
    table.columns = columns_of(scene, result.plan);
    for (const PointRow& point : result.points) {
        table.rows.push_back(row_of(scene, result.plan, point));
    }
    emit(table, o);
    return 0;
}

} // namespace

void add_pressure(CLI::App& app, int& code) {
    CLI::App* sub = app.add_subcommand("pressure", "pressures of a scene, each with a bound");
    auto o = std::make_shared<SceneOptions>();
    add_scene_options(*sub, *o);
    sub->callback([o, &code] { code = pressure(*o); });
}

} // namespace edgeproof::cli

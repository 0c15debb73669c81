// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"

#include <algorithm>
#include <memory>

namespace edgeproof::cli {
namespace {

/// True if a point is asked for by its name or by x.
bool by_name(const scene::Scene& scene) {
    return std::any_of(scene.ask.u.begin(), scene.ask.u.end(),
                       [](const scene::AskedPoint& point) { return point.place.has_value(); });
}

std::vector<report::Column> columns_of(const scene::Scene& scene, const scene::Plan& plan) {
    const ValueColumns value(scene);
    std::vector<report::Column> columns{{"edge", report::Column::Kind::text}};
    if (by_name(scene)) {
        columns.push_back({"asked", report::Column::Kind::text});
    }
    columns.push_back({"u"});
    columns.push_back({"x"});
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
        if (plan.partial_slip) {
            columns.push_back({"q_over_fp"});
            columns.push_back({"state", report::Column::Kind::text});
        } else {
            approximations("q_");
        }
    }
    return columns;
}

/// Returns the value for a route column. Its route names the other values of the same columns that
/// are not proved although this value is.
scene::BoundedValue marked(const scene::BoundedValue& value, const std::string& prefix,
                           const scene::BoundedValue& x,
                           const std::vector<scene::Approximation>& approximations) {
    std::string estimates = x.proved ? "" : "x";
    const auto add = [&](const char* name, const scene::Approximation& a,
                         const scene::BoundedValue& v) {
        if (!v.proved) {
            estimates += (estimates.empty() ? "" : ", ") + prefix + name + std::to_string(a.n);
        }
    };
    for (const scene::Approximation& a : approximations) {
        add("local_", a, a.local);
        add("rel_", a, a.relative_error);
    }
    scene::BoundedValue all = value;
    if (value.proved && !estimates.empty()) {
        all.route += " (estimate: " + estimates + ")";
    }
    return all;
}

std::string state_name(const std::optional<contact::SlipState>& state) {
    return !state || *state == contact::SlipState::undecided ? "undecided"
           : *state == contact::SlipState::stick             ? "stick"
                                                             : "slip";
}

/// Returns |q|/(f p): 1 where the contact slips.
scene::BoundedValue friction_used(const scene::Scene& scene, const scene::PointValues& at) {
    if (at.state == contact::SlipState::slip) {
        return {Ball(1, 64), at.q->proved, "superposition", Rational(1)};
    }
    const Ball most = formula::ball_of(*scene.shear->friction, at.p->value.bits()) * at.p->value;
    return {abs(at.q->value) / most, at.q->proved && at.p->proved, "superposition"};
}

std::vector<std::string> row_of(const scene::Scene& scene, const scene::Plan& plan,
                                const scene::PointRow& point) {
    const ValueColumns value(scene);
    const scene::Digits& digits = scene.ask.digits;
    std::vector<std::string> row{scene::edge_name(point.edge)};
    if (by_name(scene)) {
        row.push_back(point.asked);
    }
    row.push_back(point.values.u ? printed(*point.values.u, digits).text : point.u.text());
    row.push_back(printed(point.values.x, digits).text);
    const auto approximations = [&](const std::vector<scene::Approximation>& list) {
        for (const scene::Approximation& a : list) {
            row.push_back(printed(a.local, digits).text);
            row.push_back(printed(a.relative_error, plan.error_digits()).text);
        }
    };
    value.add(row, marked(*point.values.p, "", point.values.x, point.values.p_local), true);
    approximations(point.values.p_local);
    if (plan.shear) {
        value.add(row, marked(*point.values.q, "q_", point.values.x, point.values.q_local), true);
        if (plan.partial_slip) {
            row.push_back(printed(friction_used(scene, point.values), plan.error_digits()).text);
            row.push_back(state_name(point.values.state));
        }
        approximations(point.values.q_local);
    }
    return row;
}

int pressure(const SceneOptions& o) {
    scene::Scene scene = asked_scene(o);
    ask_for(
        scene, o, scene::QuantityGroup::pressure,
        {scene::QuantityGroup::shear, scene::QuantityGroup::contact, scene::QuantityGroup::peak});
    if (scene.ask.u.empty() && scene.ask.wants(scene::QuantityGroup::peak)) {
        scene.ask.quantities.erase(scene::QuantityGroup::pressure);
    }
    const scene::SceneResult result = done(scene);
    report::Table table = values_table(scene, result);
    table.notes = {"u: distance inwards from the edge; x: place; p: pressure, in the unit of the "
                   "contact modulus; |p - exact| <= p_bound"};
    if (by_name(scene)) {
        table.notes.emplace_back("asked: the point as the scene writes it; where a or b is solved "
                                 "for, the bounds cover how far u is known");
    }
    if (result.plan.peak) {
        table.notes.emplace_back("p_max: the greatest pressure of the contact");
    }
    if (result.plan.terms > 0) {
        table.notes.emplace_back(
            "local_n: the sum of the first n terms at that edge; rel_n: |1 - local_n/p|");
    }
    if (result.plan.partial_slip) {
        add_slip_facts(table.facts, scene, result);
        table.notes.emplace_back(
            "q: shear traction in partial slip, positive towards +x on the body that Q acts on; "
            "q_over_fp: |q|/(f p); state: slip where that is 1, stick where it is less; the q "
            "columns are as those of p");
        table.notes.push_back("warning: full stick does not hold: the contact slips beyond the "
                              "stick zone, -stick_b < "
                              "x < stick_a (edgeproof slip has the sizes of the slip zones)");
    } else if (result.plan.shear) {
        table.notes.emplace_back(
            "q: shear traction under full stick, positive towards +x on the body "
            "that Q acts on; the q columns are as those of p");
    }
    table.notes.push_back(bound_note(result.plan));
    table.columns = columns_of(scene, result.plan);
    for (const scene::PointRow& point : result.points) {
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

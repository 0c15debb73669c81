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
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name() && scene.ask.wants(row.group)) {
            const std::string name = scene::symbol_of({row.quantity});
            value.add(columns, name, name + "_route");
        }
    }
    return columns;
}

/// Returns the value for a route column. Its route names the other values of the same columns that
/// are not proved although this value is.
scene::BoundedValue marked(const scene::RowsAt& point, scene::Quantity quantity,
                           const std::string& prefix) {
    std::string estimates = point.at(scene::Quantity::x).proved ? "" : "x";
    const scene::QuantityGroup group = row_of(quantity).group;
    for (const scene::Row& row : point) {
        const scene::QuantityRow& def = row_of(row.asked.quantity);
        if (def.index == scene::QuantityRow::Index::terms && def.group == group &&
            !row.value->proved) {
            estimates += (estimates.empty() ? "" : ", ") + prefix +
                         (def.short_error ? "rel_" : "local_") + std::to_string(row.asked.k);
        }
    }
    scene::BoundedValue all = point.at(quantity);
    if (all.proved && !estimates.empty()) {
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
scene::BoundedValue friction_used(const scene::Scene& scene, const scene::RowsAt& point) {
    const scene::BoundedValue& p = point.at(scene::Quantity::p);
    const scene::BoundedValue& q = point.at(scene::Quantity::q);
    if (point.row(scene::Quantity::q).state == contact::SlipState::slip) {
        return {Ball(1, 64), q.proved, "superposition", Rational(1)};
    }
    const Ball most = formula::ball_of(*scene.shear->friction, p.value.bits()) * p.value;
    return {abs(q.value) / most, q.proved && p.proved, "superposition"};
}

std::vector<std::string> row_of_point(const scene::Scene& scene, const scene::Plan& plan,
                                      const scene::RowsAt& point) {
    using scene::Quantity;
    const ValueColumns value(scene);
    const scene::Digits& digits = scene.ask.digits;
    const scene::AskedPoint& asked = scene.ask.u[point.point()];
    std::vector<std::string> row{scene::edge_name(point.edge())};
    if (by_name(scene)) {
        row.push_back(asked.text());
    }
    const scene::Row* const u = point.find(Quantity::u);
    row.push_back(u != nullptr ? printed(*u->value, digits).text
                               : point.row(Quantity::x).asked.u->text());
    row.push_back(printed(point.at(Quantity::x), digits).text);
    const auto approximations = [&](scene::QuantityGroup group) {
        for (const scene::Row& r : point) {
            const scene::QuantityRow& def = row_of(r.asked.quantity);
            if (def.group == group && def.index == scene::QuantityRow::Index::terms) {
                row.push_back(
                    printed(*r.value, def.short_error ? plan.error_digits() : digits).text);
            }
        }
    };
    value.add(row, marked(point, Quantity::p, ""), true);
    approximations(scene::QuantityGroup::pressure);
    if (plan.shear) {
        value.add(row, marked(point, Quantity::q, "q_"), true);
        if (plan.partial_slip) {
            row.push_back(printed(friction_used(scene, point), plan.error_digits()).text);
            row.push_back(state_name(point.row(Quantity::q).state));
        }
        approximations(scene::QuantityGroup::shear);
    }
    for (const scene::Row& other : point) {
        if (row_of(other.asked.quantity).by_its_own_name()) {
            value.add(row, *other.value, true);
        }
    }
    return row;
}

int pressure(const SceneOptions& o) {
    scene::Scene scene = asked_scene(o);
    std::vector<scene::QuantityGroup> others{
        scene::QuantityGroup::shear, scene::QuantityGroup::contact, scene::QuantityGroup::peak};
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name()) {
            others.push_back(row.group);
        }
    }
    ask_for(scene, o, scene::QuantityGroup::pressure, others);
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
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name() && scene.ask.wants(row.group)) {
            table.notes.push_back(scene::symbol_of({row.quantity}) + ": " +
                                  std::string(row.meaning));
        }
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
    for (const scene::RowsAt& point : result.points()) {
        table.rows.push_back(row_of_point(scene, result.plan, point));
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"

#include <algorithm>

namespace edgeproof::cli {
namespace {

/// True if a point is asked for by its name or by x.
bool by_name(const scene::Scene& scene) {
    return std::any_of(scene.ask.u.begin(), scene.ask.u.end(),
                       [](const scene::AskedPoint& point) { return point.place.has_value(); });
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

/// True for a place outside the contact, where only x, p = 0 and q = 0 have values.
bool is_outside(const scene::RowsAt& point) {
    const scene::BoundedValue& p = point.at(scene::Quantity::p);
    return p.exactly && *p.exactly == 0;
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

/// Returns the values of the whole contact as rows; a terminal shows them as facts.
report::Table rows_of_facts(const std::vector<report::Fact>& facts) {
    using Kind = report::Column::Kind;
    report::Table table;
    table.columns = {{"quantity", Kind::text}, {"value"}, {"bound"}, {"route", Kind::text}};
    for (report::Column& column : table.columns) {
        column.shown = report::Column::Shown::not_on_terminal;
    }
    for (const report::Fact& fact : facts) {
        if (!fact.bound.empty()) {
            table.rows.push_back({fact.key, fact.value, fact.bound, fact.route});
        }
    }
    return table;
}

/// `no_shear`: the shear is asked for after a step of a history before there is any.
Columns<scene::RowsAt> columns_of(const scene::Scene& scene, const scene::Plan& plan,
                                  bool no_shear) {
    using scene::Quantity;
    using scene::RowsAt;
    using Kind = report::Column::Kind;
    const auto cell = [](const RowsAt& at, Quantity quantity, std::size_t n,
                         const scene::Digits& digits) {
        const scene::Row* const row = at.find(quantity, n); // null outside the contact
        return row != nullptr ? printed(*row->value, digits).text : std::string();
    };
    const auto text = [digits = scene.ask.digits, cell](const RowsAt& at, Quantity quantity,
                                                        std::size_t n = 0) {
        return cell(at, quantity, n, digits);
    };
    Columns<RowsAt> columns(scene);
    columns.add("edge", Kind::text, [](const RowsAt& at) { return scene::edge_name(at.edge()); })
        .phrase = "{} edge";
    if (by_name(scene)) {
        columns
            .add("asked", Kind::text,
                 [&](const RowsAt& at) { return scene.ask.u[at.point()].text(scene.ask.digits); })
            .shown = report::Column::Shown::not_on_terminal;
    }
    const std::string length = unit_of(scene, Quantity::x);
    columns
        .add("u", Kind::number,
             [&, text](const RowsAt& at) {
                 const std::optional<formula::Exact>& u = at.row(Quantity::x).asked.u;
                 return u ? decimal_text(*u, scene.ask.digits) : text(at, Quantity::u);
             })
        .unit = length;
    columns.add("x", Kind::number, [text](const RowsAt& at) { return text(at, Quantity::x); })
        .unit = length;
    const auto approximations = [&](const std::string& prefix, Quantity sum, Quantity error) {
        for (const std::size_t n : plan.terms > 0 ? scene.ask.terms : std::vector<std::size_t>{}) {
            columns
                .add(prefix + "local_" + std::to_string(n), Kind::number,
                     [=](const RowsAt& at) { return text(at, sum, n); })
                .unit = unit_of(scene, sum);
            columns.add(prefix + "rel_" + std::to_string(n), Kind::number,
                        [=, digits = plan.error_digits()](const RowsAt& at) {
                            return cell(at, error, n, digits);
                        });
        }
    };
    columns.add_value("p", "route", [](const RowsAt& at) { return marked(at, Quantity::p, ""); })
        .unit = unit_of(scene, Quantity::p);
    approximations("", Quantity::local, Quantity::rel);
    if (plan.shear) {
        columns
            .add_value("q", "q_route",
                       [](const RowsAt& at) { return marked(at, Quantity::q, "q_"); })
            .unit = unit_of(scene, Quantity::q);
        if (plan.partial_slip) {
            columns.add("q_over_fp", Kind::number, [&](const RowsAt& at) {
                return is_outside(at) ? ""
                                      : printed(friction_used(scene, at), plan.error_digits()).text;
            });
            columns
                .add("state", Kind::text,
                     [](const RowsAt& at) {
                         return is_outside(at) ? "" : state_name(at.row(Quantity::q).state);
                     })
                .phrase = "{}";
        } else {
            approximations("q_", Quantity::q_local, Quantity::q_rel);
        }
    }
    if (no_shear) {
        columns.add_value("q", "q_route", [](const RowsAt&) {
            return scene::BoundedValue{Ball(0, 64), true, "no shear load", Rational(0)};
        });
    }
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name() && scene.ask.wants(row.group)) {
            const std::string name = scene::symbol_of({row.quantity});
            columns
                .add_value(name, name + "_route",
                           [&row](const RowsAt& at) {
                               const scene::Row* const found = at.find(row.quantity);
                               return found != nullptr ? found->value : std::nullopt;
                           })
                .unit = unit_of(scene, row.quantity);
        }
    }
    return columns;
}

int pressure(const SceneOptions& o) {
    check_figure_option(o);
    scene::Scene scene = asked_scene(o);
    std::vector<scene::QuantityGroup> others{
        scene::QuantityGroup::shear, scene::QuantityGroup::contact, scene::QuantityGroup::peak};
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name()) {
            others.push_back(row.group);
        }
    }
    const bool no_shear = !scene.shear && !scene.steps.empty() &&
                          scene.ask.quantities.erase(scene::QuantityGroup::shear) > 0;
    // Values of the whole contact are given alone if no pressures are requested with them.
    const bool of_contact = (scene.ask.wants(scene::QuantityGroup::contact) ||
                             scene.ask.wants(scene::QuantityGroup::peak)) &&
                            !scene.ask.wants(scene::QuantityGroup::pressure);
    ask_for(scene, o, scene::QuantityGroup::pressure, others);
    const bool alone = of_contact && std::ranges::none_of(others, [&](scene::QuantityGroup group) {
                           return group != scene::QuantityGroup::contact &&
                                  group != scene::QuantityGroup::peak && scene.ask.wants(group);
                       });
    if (alone || (scene.ask.u.empty() && scene.ask.wants(scene::QuantityGroup::peak))) {
        scene.ask.quantities.erase(scene::QuantityGroup::pressure);
        scene.ask.u.clear();
    }
    const scene::SceneResult result = done(scene, o);
    report::Table table = values_table(scene, result);
    const report::Table values = rows_of_facts(table.facts);
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
        table.notes.push_back(
            std::string("q: shear traction in partial slip, positive towards +x on the body that Q "
                        "acts on; q_over_fp: |q|/(f p); state: ") +
            (scene.history ? "slip where the place slipped in the last step"
                           : "slip where that is 1, stick where it is less") +
            "; the q columns are as those of p");
        if (!scene.history || scene.history->stick) {
            table.remarks.push_back("the contact slips outside -stick_b < x < stick_a (edgeproof "
                                    "slip has the sizes of the slip zones)");
        }
    } else if (result.plan.shear) {
        table.notes.emplace_back(
            "q: shear traction under full stick, positive towards +x on the body "
            "that Q acts on; the q columns are as those of p");
    }
    table.asked = result.plan.print_pressure
                      ? "pressure p at the distance u from an edge (at the place x)"
                  : result.plan.peak ? "the greatest pressure"
                                     : "the edges and the load";
    table.remarks.push_back(bound_note());
    if (result.plan.print_pressure) {
        columns_of(scene, result.plan, no_shear).write(table, result.points());
    } else {
        table.columns = values.columns;
        table.rows = values.rows;
    }
    draw_figure_option(scene, o);
    emit(table, o);
    return 0;
}

} // namespace

void add_pressure(CLI::App& app, int& code) {
    auto [sub, o] = add_command<SceneOptions>(app, code, "pressure",
                                              "pressures of a scene, each with a bound", pressure);
    add_scene_options(sub, o);
    add_figure_option(sub, o);
}

} // namespace edgeproof::cli

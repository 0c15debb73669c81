// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/commands/compute.hpp"

#include <algorithm>

namespace edgeproof::cli {
namespace {

using scene::Quantity;
using scene::QuantityGroup;

std::string state_name(const std::optional<contact::SlipState>& state) {
    return !state || *state == contact::SlipState::undecided ? "undecided"
           : *state == contact::SlipState::stick             ? "stick"
                                                             : "slip";
}

/// True for a place outside the contact, where only x, p = 0 and q = 0 have values.
bool is_outside(const scene::RowsAt& point) {
    const scene::BoundedValue& p = point.at(Quantity::p);
    return p.exactly && *p.exactly == 0;
}

/// Returns |q|/(f p): 1 where the contact slips.
scene::BoundedValue friction_used(const scene::Scene& scene, const scene::RowsAt& point) {
    const scene::BoundedValue& p = point.at(Quantity::p);
    const scene::BoundedValue& q = point.at(Quantity::q);
    if (point.row(Quantity::q).state == contact::SlipState::slip) {
        return {Ball(1, 64), q.proved, "superposition", Rational(1)};
    }
    const Ball most = formula::ball_of(*scene.shear->friction, p.value.bits()) * p.value;
    return {abs(q.value) / most, q.proved && p.proved, "superposition"};
}

/// Makes the values of the whole contact the rows; a terminal shows them as facts.
void write_facts(report::Table& table, const std::vector<report::Fact>& facts) {
    using Kind = report::Column::Kind;
    table.columns = {{"quantity", Kind::text}, {"value"}, {"bound"}, {"route", Kind::text}};
    for (report::Column& column : table.columns) {
        column.shown = report::Column::Shown::not_on_terminal;
    }
    for (const report::Fact& fact : facts) {
        if (!fact.bound.empty()) {
            table.rows.push_back({fact.key, fact.value, fact.bound, fact.route});
        }
    }
}

/// `by_name`: places are given by names; `no_shear`: the shear is asked for after a step of a
/// history before there is any.
void fill(Row& row, const Line& line, const Computing& c, bool by_name, bool no_shear) {
    const scene::Scene& scene = c.scene;
    const scene::Plan& plan = c.result.plan;
    const scene::Digits& digits = scene.ask.digits;
    row.text("edge", edge_of(line), "{} edge");
    if (by_name) {
        row.text("asked", scene.ask.u[line.at.point()].text(digits)).shown =
            report::Column::Shown::not_on_terminal;
    }
    const std::optional<formula::Exact>& u = line.at.row(Quantity::x).asked.u;
    const scene::Row* const distance = line.at.find(Quantity::u); // null outside
    row.add("u", report::Column::Kind::number,
            u                     ? decimal_text(*u, digits)
            : distance != nullptr ? printed(*distance->value, digits).text
                                  : std::string())
        .unit = unit_of(scene, Quantity::x);
    row.number("x", Quantity::x);
    const auto traction = [&](const std::string& name, const std::string& route, Quantity quantity,
                              const std::string& prefix) {
        row.value(name, route, marked(line.at, quantity, prefix)).unit = unit_of(scene, quantity);
    };
    const auto approximations = [&](const std::string& prefix, Quantity sum, Quantity error) {
        for (const std::size_t n : plan.terms > 0 ? scene.ask.terms : std::vector<std::size_t>{}) {
            row.number(prefix + "local_" + std::to_string(n), sum, n);
            row.number(prefix + "rel_" + std::to_string(n), error, n);
        }
    };
    traction("p", "route", Quantity::p, "");
    approximations("", Quantity::local, Quantity::rel);
    const bool shear = scene.ask.wants(QuantityGroup::shear);
    if (shear) {
        traction("q", "q_route", Quantity::q, "q_");
    }
    if (shear && plan.partial_slip) {
        const bool outside = is_outside(line.at);
        row.add(
            "q_over_fp", report::Column::Kind::number,
            outside
                ? ""
                : printed(friction_used(scene, line.at), digits_of(Quantity::rel, digits)).text);
        row.text("state", outside ? "" : state_name(line.at.row(Quantity::q).state), "{}");
    } else if (shear) {
        approximations("q_", Quantity::q_local, Quantity::q_rel);
    }
    if (no_shear) {
        row.value("q", "q_route",
                  scene::BoundedValue{Ball(0, 64), true, "no shear load", Rational(0)});
    }
}

void note_shear(Computing& c) {
    const std::string q = std::string("q: shear traction ") + c.scene.shear_state() +
                          ", positive towards +x on the body that Q acts on; ";
    if (c.result.plan.partial_slip) {
        c.note(q + "q_over_fp: |q|/(f p); state: " +
               (c.scene.history ? "slip where the place slipped in the last step"
                                : "slip where that is 1, stick where it is less") +
               "; the q columns are as those of p");
        if (!c.scene.history || c.scene.history->stick) {
            c.table.remarks.emplace_back(
                "the contact slips outside -stick_b < x < stick_a (edgeproof slip has the sizes "
                "of the slip zones)");
        }
    } else if (c.scene.ask.wants(QuantityGroup::shear)) {
        c.note(q + "the q columns are as those of p");
    }
}

} // namespace

int pressure(Options& o) {
    check_figure_option(o["--figure"]);
    Computing c(o);
    scene::Ask& ask = c.scene.ask;
    const bool no_shear = !c.scene.shear && !c.scene.steps.empty() &&
                          word_of(o, "quantities").find("shear") != std::string::npos;
    if (ask.u.empty() && word_of(o, "quantities").empty() && !ask.wants(QuantityGroup::pressure)) {
        ask.quantities.insert({QuantityGroup::contact, QuantityGroup::peak});
    }
    // Values of the whole contact are given alone if no pressures are requested with them.
    const bool alone = (ask.wants(QuantityGroup::contact) || ask.wants(QuantityGroup::peak)) &&
                       !ask.wants(QuantityGroup::pressure) && !ask.wants(QuantityGroup::shear);
    ask_for(c.scene, o, QuantityGroup::pressure,
            {QuantityGroup::shear, QuantityGroup::contact, QuantityGroup::peak});
    if (alone || (ask.u.empty() && ask.wants(QuantityGroup::peak))) {
        ask.quantities.erase(QuantityGroup::pressure);
        ask.u.clear();
    }
    c.run();
    const bool pressures = ask.wants(QuantityGroup::pressure);
    const bool by_name = std::ranges::any_of(
        ask.u, [](const scene::AskedPoint& point) { return point.place.has_value(); });
    c.note("u: distance inwards from the edge; x: place; p: pressure, in the unit of the "
           "contact modulus; |p - exact| <= p_bound");
    if (by_name) {
        c.note("asked: the point as the scene writes it; where a or b is solved for, the bounds "
               "cover how far u is known");
    }
    if (ask.wants(QuantityGroup::peak)) {
        c.note("p_max: the greatest pressure of the contact");
    }
    if (c.result.plan.terms > 0) {
        c.note("local_n: the sum of the first n terms at that edge; rel_n: |1 - local_n/p|");
    }
    const std::vector<report::Fact> facts = c.table.facts;
    c.add_slip_facts();
    note_shear(c);
    c.table.asked = pressures ? "pressure p at the distance u from an edge (at the place x)"
                    : ask.wants(QuantityGroup::peak) ? "the greatest pressure"
                                                     : "the edges and the load";
    if (pressures) {
        c.add_rows(lines_of(c.result.points()),
                   [&](Row& row, const Line& line) { fill(row, line, c, by_name, no_shear); });
        return c.write();
    }
    write_facts(c.table, facts);
    return c.write();
}

} // namespace edgeproof::cli

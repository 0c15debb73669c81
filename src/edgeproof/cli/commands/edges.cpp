// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/compute.hpp"

#include "edgeproof/report/text/percent.hpp"

#include <algorithm>

/// The commands whose rows are those of the edges.
namespace edgeproof::cli {

using scene::Quantity;
using scene::QuantityGroup;

int expand(const ComputeOptions& o) {
    if (!o.angle.empty()) {
        return expand_stresses(o);
    }
    require(o.body.empty(),
            "--body " + o.body + " has no effect: without --angle no stress is computed",
            "leave --body out");
    check_figure_option(o.figure);
    Computing c(o);
    ask_at_edges(c.scene);
    ask_terms(c.scene);
    c.scene.ask.terms = {c.scene.ask.most_terms()};
    c.run(QuantityGroup::coefficients);
    c.note("p = sum of c_k u^(k + 1/2) at the distance u from the edge; |value - exact| <= bound");
    c.note("c_0, c_1, c_2 are the L_I, M_I, N_I of the literature");
    if (c.result.plan.expand_shear) {
        c.note(c.scene.together()
                   ? "q = (Q/P) p = sum of s_k u^(k + 1/2)"
                   : "q = sum of s_k u^(k - 1/2): s_0, s_1, s_2 are K_II, L_II, M_II");
    }
    c.table.asked = "coefficients of p = sum of c_k u^(k + 1/2) at the distance u from the edge";
    std::vector<Line> lines;
    for (const scene::RowsAt& edge : c.result.at_edges(QuantityGroup::coefficients)) {
        for (const Quantity quantity : {Quantity::c, Quantity::s}) {
            for (const scene::Row& row : edge) {
                if (row.asked.quantity == quantity) {
                    lines.push_back({scene::RowsAt({&row, 1})});
                }
            }
        }
    }
    const auto asked = [](const Line& line) { return line.at.begin()->asked; };
    Columns columns(c.scene);
    using Shown = report::Column::Shown;
    columns.text("edge", edge_of, "{} edge");
    columns.text(
        "coefficient", [=](const Line& l) { return symbol_of(asked(l)); }, "{} =");
    columns
        .add("k", Columns::Kind::count, [=](const Line& l) { return std::to_string(asked(l).k); })
        .shown = Shown::not_on_terminal;
    columns
        .text("power",
              [&, asked](const Line& l) {
                  const int half_powers =
                      asked(l).quantity == Quantity::c ? 1 : scene::shear_half_powers(c.scene);
                  return std::to_string(2 * static_cast<long>(asked(l).k) + half_powers) + "/2";
              })
        .shown = Shown::not_on_terminal;
    columns.value("value", "route", [](const Line& l) { return l.at.begin()->value; }).phrase =
        "{}";
    columns
        .text(
            "unit",
            [&, asked](const Line& l) { return unit_of(c.scene, asked(l).quantity, asked(l).k); },
            "{}")
        .shown = Shown::on_terminal_only;
    columns.column(5).name = "bound"; // not value_bound
    return c.write(columns, lines);
}

int extent(const ComputeOptions& o) {
    check_figure_option(o.figure);
    Computing c(o);
    const scene::Ask& ask = c.scene.ask;
    c.bounds.clear(); // the notes have the exceptions
    ask_at_edges(c.scene);
    if (!ask.tolerance) {
        c.reject("no tolerance is given", "add tolerance=1%, or tolerance = \"1%\" to [ask]",
                 c.scene.ask_line);
    }
    ask_terms(c.scene);
    c.run(QuantityGroup::extent);
    const std::string tolerance = o.word("tolerance");
    c.table.facts.push_back({"tolerance", tolerance.empty() ? ask.tolerance->text() : tolerance});
    if (ask.process_zone) {
        c.table.facts.push_back({"process_zone", ask.process_zone->text()});
    }
    c.note("first_exit: the first distance from the edge at which n terms are off by the "
           "tolerance; measure: the length of all places where they are not; the fractions are of "
           "a + b");
    c.note("crossings: every distance at which the error passes the tolerance; that there are no "
           "more is proved, unless the route says scan: then it is sampled, and the bounds are "
           "estimates");
    if (std::ranges::any_of(c.result.rows, [](const scene::Row& row) { return !row.reached; })) {
        c.note("no first_exit: n terms stay within the tolerance all over the part of the contact "
               "that is looked at");
    }
    if (ask.process_zone) {
        c.note("covers_zone: yes where n terms stay within the tolerance all through the process "
               "zone");
    }
    c.table.asked = "how far from the edge the first n terms are within " +
                    report::in_percent(*ask.tolerance) + " of the pressure";
    std::vector<Line> lines;
    for (const scene::RowsAt& edge : c.result.at_edges(QuantityGroup::extent)) {
        for (const std::size_t n : ask.terms) {
            lines.push_back({edge, n});
        }
    }
    const auto exit = [](const Line& l) -> const scene::Row& {
        return l.at.row(Quantity::extent, l.n);
    };
    Columns columns(c.scene);
    using Shown = report::Column::Shown;
    columns.text("edge", edge_of, "{} edge");
    columns.add("n", Columns::Kind::count, [](const Line& l) { return std::to_string(l.n); });
    report::Column& first = columns.value("first_exit", "", [=](const Line& l) {
        return exit(l).reached ? exit(l).value : std::nullopt;
    });
    first.phrase = "up to u = {}";
    first.unit = unit_of(c.scene, Quantity::extent);
    columns
        .add("first_exit_fraction", Columns::Kind::number,
             [&, exit](const Line& l) {
                 return exit(l).reached
                            ? printed(l.at.at(Quantity::extent_fraction, l.n), ask.digits).text
                            : "";
             })
        .phrase = "{} of a + b";
    columns
        .text("everywhere",
              [=](const Line& l) {
                  return exit(l).reached ? "" : "in the whole part that is looked at";
              })
        .shown = Shown::on_terminal_only;
    columns.value("measure", "", Quantity::measure).shown = Shown::not_on_terminal;
    columns.number("measure_fraction", Quantity::measure_fraction).shown = Shown::not_on_terminal;
    if (ask.process_zone) {
        columns.text(
            "covers_zone",
            [&, exit](const Line& l) {
                return covers_zone(c.scene, *exit(l).value) ? "yes" : "no";
            },
            "covers the process zone: {}");
    }
    columns
        .text("crossings",
              [&](const Line& l) {
                  std::string all;
                  for (std::size_t j = 0; const auto* u = l.at.find(Quantity::crossing, l.n, j);
                       ++j) {
                      all += (all.empty() ? "" : " ") + printed(*u->value, ask.digits).text;
                  }
                  return all.empty() ? "none" : all;
              })
        .shown = Shown::not_on_terminal;
    columns.route([=](const Line& l) { return exit(l).value->how(); });
    return c.write(columns, lines);
}

void note_slip(Computing& c, bool series) {
    const scene::Scene& scene = c.scene;
    c.note("d: size of the slip zone at the edge, |d - exact| <= d_bound; the rest of the "
           "contact, -stick_b < x < stick_a, sticks");
    if (series) {
        c.note(scene.round
                   ? "d_n: the first n terms of d in powers of Q/f, P held; rel_n: |1 - d_n/d|"
                   : "d_n: the first n terms of d in powers of Q/f, P and bulk_tension/Q "
                     "held; d_1 = 2 s_0/(f c_0); rel_n: |1 - d_n/d|");
    }
    if (series && scene.ask.tolerance) {
        c.note("slip_load_n: the Q/(f P) up to which |1 - d_n/d| stays within " +
               scene.ask.tolerance->text() + ", P and bulk_tension/Q held; 1: up to full sliding");
    }
    if (c.result.find(Quantity::step_energy) != nullptr) {
        c.note("step_energy: what friction takes, per unit length, in the last step");
    }
    if (c.result.find(Quantity::cycle_energy) != nullptr) {
        c.note(std::string("cycle_energy: what friction takes") +
               (scene.round ? "" : ", per unit length,") +
               (!scene.history          ? " in a cycle from -Q to Q and back, P held"
                : scene.history->steady ? " in the last pass of the repeated steps; it ends in the "
                                          "state in which it began, so that all later passes are "
                                          "alike"
                                        : " in the last pass of the repeated steps; the state is "
                                          "not steady yet"));
    }
}

int slip(const ComputeOptions& o) {
    Computing c(o);
    scene::Ask& ask = c.scene.ask;
    if (!c.scene.slips()) {
        c.reject("the scene has no friction, so that nothing slips",
                 "add friction = \"0.6\" to [shear], in addition to Q", c.scene.load_line);
    }
    ask_at_edges(c.scene);
    const bool series = !c.scene.history; // the series is that of one step of Q
    if (series) {
        ask_terms(c.scene);
    } else {
        refuse_words(o, {"terms", "tolerance"}, "the slip zones of a load history have no series");
        ask.terms.clear();
        ask.tolerance.reset();
    }
    c.run(QuantityGroup::slip);
    c.add_slip_facts();
    note_slip(c, series);
    c.table.asked =
        "size d of the slip zone at each edge, and d_n by the first n terms of its series";
    Columns columns(c.scene);
    columns.text("edge", edge_of, "{} edge");
    columns.value("d", "route", [](const Line& l) { return marked(l.at, Quantity::slip, ""); })
        .unit = unit_of(c.scene, Quantity::slip);
    for (const std::size_t n : ask.terms) {
        columns.number("d_" + std::to_string(n), Quantity::slip_terms, n);
        columns.number("rel_" + std::to_string(n), Quantity::slip_rel, n);
    }
    for (const std::size_t n : ask.tolerance ? ask.terms : std::vector<std::size_t>{}) {
        const std::string name = "slip_load_" + std::to_string(n);
        const auto load = [n](const Line& l) -> const scene::Row& {
            return l.at.row(Quantity::slip_load, n);
        };
        columns.value(name, "", [=](const Line& l) { return load(l).value; });
        columns
            .text(name + "_route",
                  [=](const Line& l) -> std::string {
                      return !load(l).value    ? "undecided"
                             : load(l).reached ? load(l).value->how()
                                               : "full sliding";
                  })
            .role = report::Column::Role::route;
    }
    const std::vector<Line> edges = lines_of(c.result.at_edges(QuantityGroup::slip));
    std::vector<std::string> negative;
    for (const Line& edge : edges) {
        for (const std::size_t n : ask.terms) {
            if (certainly_negative(edge.at.at(Quantity::slip_terms, n).value)) {
                negative.push_back("d_" + std::to_string(n) + " is negative at the " +
                                   edge_of(edge) +
                                   " edge: with this number of terms the series gives no slip "
                                   "zone; use d, or more terms");
            }
        }
    }
    return c.write(columns, edges, negative);
}

} // namespace edgeproof::cli

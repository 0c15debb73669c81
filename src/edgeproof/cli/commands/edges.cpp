// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/commands/compute.hpp"

#include <algorithm>

/// The commands whose rows are those of the edges.
namespace edgeproof::cli {

using scene::Quantity;
using scene::QuantityGroup;

int expand(Options& o) {
    if (!o["--angle"].empty()) {
        return expand_stresses(o);
    }
    require(o["--body"].empty(),
            "--body " + o["--body"] + " has no effect: without --angle no stress is computed",
            "leave --body out");
    check_figure_option(o["--figure"]);
    Computing c(o);
    ask_at_edges(c.scene);
    ask_terms(c.scene);
    c.scene.ask.terms = {c.scene.ask.most_terms()};
    c.run(QuantityGroup::coefficients);
    c.note("p = sum of c_k u^(k + 1/2) at the distance u from the edge; |value - exact| <= bound");
    c.note("c_0, c_1, c_2 are the L_I, M_I, N_I of the literature");
    if (c.result.plan.expand_shear) {
        c.note(c.scene.proportional()
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
    using Shown = report::Column::Shown;
    c.add_rows(lines, [&](Row& row, const Line& line) {
        const scene::AskedValue& asked = line.at.begin()->asked;
        const int half_powers =
            asked.quantity == Quantity::c ? 1 : scene::shear_half_powers(c.scene);
        const long halves = 2 * static_cast<long>(asked.k) + half_powers;
        row.text("edge", edge_of(line), "{} edge");
        row.text("coefficient", symbol_of(asked), "{} =");
        row.add("k", report::Column::Kind::count, std::to_string(asked.k)).shown =
            Shown::not_on_terminal;
        row.text("power", std::to_string(halves) + "/2").shown = Shown::not_on_terminal;
        row.value("value", "route", line.at.begin()->value).phrase = "{}";
        row.text("unit", unit_of(c.scene, asked.quantity, asked.k), "{}").shown =
            Shown::on_terminal_only;
    });
    c.table.columns.at(5).name = "bound"; // not value_bound
    return c.write();
}

int extent(Options& o) {
    check_figure_option(o["--figure"]);
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
    const std::string tolerance = word_of(o, "tolerance");
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
    using Shown = report::Column::Shown;
    c.add_rows(lines, [&](Row& row, const Line& line) {
        const scene::Row& exit = line.at.row(Quantity::extent, line.n);
        row.text("edge", edge_of(line), "{} edge");
        row.add("n", report::Column::Kind::count, std::to_string(line.n));
        report::Column& first =
            row.value("first_exit", "", exit.reached ? exit.value : std::nullopt);
        first.phrase = "up to u = {}";
        first.unit = unit_of(c.scene, Quantity::extent);
        const std::string fraction =
            exit.reached ? printed(line.at.at(Quantity::extent_fraction, line.n), ask.digits).text
                         : "";
        row.add("first_exit_fraction", report::Column::Kind::number, fraction).phrase =
            "{} of a + b";
        row.text("everywhere", exit.reached ? "" : "in the whole part that is looked at").shown =
            Shown::on_terminal_only;
        row.value("measure", "", Quantity::measure).shown = Shown::not_on_terminal;
        row.number("measure_fraction", Quantity::measure_fraction).shown = Shown::not_on_terminal;
        if (ask.process_zone) {
            row.text("covers_zone", covers_zone(c.scene, *exit.value) ? "yes" : "no",
                     "covers the process zone: {}");
        }
        std::string all;
        for (std::size_t j = 0; const auto* u = line.at.find(Quantity::crossing, line.n, j); ++j) {
            all += (all.empty() ? "" : " ") + printed(*u->value, ask.digits).text;
        }
        row.text("crossings", all.empty() ? "none" : all).shown = Shown::not_on_terminal;
        row.route(exit.value->how());
    });
    return c.write();
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

int slip(Options& o) {
    Computing c(o);
    scene::Ask& ask = c.scene.ask;
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
    std::vector<std::string> negative;
    c.add_rows(lines_of(c.result.at_edges(QuantityGroup::slip)), [&](Row& row, const Line& line) {
        row.text("edge", edge_of(line), "{} edge");
        row.value("d", "route", marked(line.at, Quantity::slip, "")).unit =
            unit_of(c.scene, Quantity::slip);
        for (const std::size_t n : ask.terms) {
            row.number("d_" + std::to_string(n), Quantity::slip_terms, n);
            row.number("rel_" + std::to_string(n), Quantity::slip_rel, n);
            if (certainly_negative(line.at.at(Quantity::slip_terms, n).value)) {
                negative.push_back("d_" + std::to_string(n) + " is negative at the " +
                                   edge_of(line) +
                                   " edge: with this number of terms the series gives no slip "
                                   "zone; use d, or more terms");
            }
        }
        for (const std::size_t n : ask.tolerance ? ask.terms : std::vector<std::size_t>{}) {
            const std::string name = "slip_load_" + std::to_string(n);
            const scene::Row& load = line.at.row(Quantity::slip_load, n);
            row.value(name, "", load.value);
            row.text(name + "_route", !load.value    ? "undecided"
                                      : load.reached ? load.value->how()
                                                     : "full sliding")
                .role = report::Column::Role::route;
        }
    });
    return c.write(negative);
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/compute.hpp"

#include "edgeproof/formula/exact/enclosure.hpp"
#include "edgeproof/report/text/percent.hpp"

#include <algorithm>

namespace edgeproof::cli {

using scene::Quantity;
using scene::QuantityGroup;

void Computing::run(QuantityGroup own, const std::vector<QuantityGroup>& others) {
    ask_for(scene, o, own, others);
    result = done(scene, o);
    table = values_table(scene, result);
}

void Computing::add_slip_facts() {
    if (!result.plan.partial_slip) {
        return;
    }
    std::vector<report::Fact>& facts = table.facts;
    facts.push_back({"friction", scene.shear->friction->text()});
    for (const auto& [key, quantity] :
         {std::pair{"Q/(f P)", Quantity::load_ratio}, std::pair{"stick_a", Quantity::stick_a},
          std::pair{"stick_b", Quantity::stick_b},
          std::pair{"least_bulk_tension", Quantity::least_tension},
          std::pair{"most_bulk_tension", Quantity::most_tension},
          std::pair{"step_energy", Quantity::step_energy},
          std::pair{"cycle_energy", Quantity::cycle_energy}}) {
        add_fact(facts, key, scene, result, quantity);
    }
    if (scene.round) {
        facts.push_back({"assumption",
                         "q acts in the direction of Q everywhere and does not change p: exact "
                         "for Poisson's ratio 0 and equal bodies (Cattaneo, Mindlin)"});
    }
    if (!result.in_proportion) {
        facts.push_back({"path", "Q first: with Q and bulk_tension in proportion one edge would "
                                 "slip against Q at first, as |sigma_0 (a + b)/Q| is not below "
                                 "8/pi"});
    }
}

int Computing::write(const Columns& columns, const std::vector<Line>& lines,
                     const std::vector<std::string>& remarks) {
    columns.write(table, lines);
    return write(remarks);
}

int Computing::write(const std::vector<std::string>& remarks) {
    if (!bounds.empty()) {
        table.remarks.push_back(bounds);
    }
    table.remarks.insert(table.remarks.end(), remarks.begin(), remarks.end());
    draw_figure_option(scene, o);
    emit(table, o);
    return 0;
}

void Computing::reject(const std::string& problem, const std::string& instead,
                       std::size_t line) const {
    throw InputError(problem, instead).at(scene.file, line);
}

namespace {

std::string edge_of(const Line& line) { return scene::edge_name(line.at.edge()); }

/// Returns the value for a route column. Its route names the other values of the same columns that
/// are not proved although this value is.
scene::BoundedValue marked(const scene::RowsAt& at, Quantity quantity, const std::string& prefix) {
    scene::BoundedValue all = at.at(quantity);
    std::string estimates;
    const auto add = [&](const std::string& name) {
        estimates += (estimates.empty() ? "" : ", ") + name;
    };
    if (const scene::Row* x = at.find(Quantity::x); x != nullptr && !x->value->proved) {
        add("x");
    }
    for (const scene::Row& row : at) {
        const scene::QuantityRow& def = row_of(row.asked.quantity);
        const bool slips = def.group == QuantityGroup::slip;
        if (def.index == scene::QuantityRow::Index::terms && def.group == row_of(quantity).group &&
            row.asked.quantity != Quantity::slip_load && !row.value->proved) {
            add(prefix +
                (def.short_error ? "rel_"
                 : slips         ? "d_"
                                 : "local_") +
                std::to_string(row.asked.k));
        }
    }
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

/// `no_shear`: the shear is asked for after a step of a history before there is any.
Columns columns_at_points(const Computing& c, bool by_name, bool no_shear) {
    const scene::Scene& scene = c.scene;
    const scene::Plan& plan = c.result.plan;
    Columns columns(scene);
    columns.text("edge", edge_of, "{} edge");
    if (by_name) {
        columns
            .text("asked",
                  [&](const Line& line) {
                      return scene.ask.u[line.at.point()].text(scene.ask.digits);
                  })
            .shown = report::Column::Shown::not_on_terminal;
    }
    columns
        .add("u", Columns::Kind::number,
             [&](const Line& line) {
                 const std::optional<formula::Exact>& u = line.at.row(Quantity::x).asked.u;
                 const scene::Row* const row = line.at.find(Quantity::u); // null outside
                 return u                ? decimal_text(*u, scene.ask.digits)
                        : row != nullptr ? printed(*row->value, scene.ask.digits).text
                                         : std::string();
             })
        .unit = unit_of(scene, Quantity::x);
    columns.number("x", Quantity::x);
    const auto approximations = [&](const std::string& prefix, Quantity sum, Quantity error) {
        for (const std::size_t n : plan.terms > 0 ? scene.ask.terms : std::vector<std::size_t>{}) {
            columns.number(prefix + "local_" + std::to_string(n), sum, n);
            columns.number(prefix + "rel_" + std::to_string(n), error, n);
        }
    };
    const auto traction = [&](const std::string& name, const std::string& route, Quantity quantity,
                              const std::string& prefix) {
        columns.value(name, route, [=](const Line& l) { return marked(l.at, quantity, prefix); })
            .unit = unit_of(scene, quantity);
    };
    traction("p", "route", Quantity::p, "");
    approximations("", Quantity::local, Quantity::rel);
    if (plan.shear) {
        traction("q", "q_route", Quantity::q, "q_");
    }
    if (plan.shear && plan.partial_slip) {
        columns.add("q_over_fp", Columns::Kind::number, [&](const Line& line) {
            return is_outside(line.at)
                       ? ""
                       : printed(friction_used(scene, line.at), error_digits(scene)).text;
        });
        columns.text(
            "state",
            [](const Line& line) {
                return is_outside(line.at) ? "" : state_name(line.at.row(Quantity::q).state);
            },
            "{}");
    } else if (plan.shear) {
        approximations("q_", Quantity::q_local, Quantity::q_rel);
    }
    if (no_shear) {
        columns.value("q", "q_route", [](const Line&) {
            return scene::BoundedValue{Ball(0, 64), true, "no shear load", Rational(0)};
        });
    }
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name() && scene.ask.wants(row.group)) {
            const std::string name = scene::symbol_of({row.quantity});
            columns.value(name, name + "_route", row.quantity);
        }
    }
    return columns;
}

void note_shear(Computing& c) {
    if (c.result.plan.partial_slip) {
        c.note(std::string("q: shear traction in partial slip, positive towards +x on the body "
                           "that Q acts on; q_over_fp: |q|/(f p); state: ") +
               (c.scene.history ? "slip where the place slipped in the last step"
                                : "slip where that is 1, stick where it is less") +
               "; the q columns are as those of p");
        if (!c.scene.history || c.scene.history->stick) {
            c.table.remarks.emplace_back(
                "the contact slips outside -stick_b < x < stick_a (edgeproof slip has the sizes "
                "of the slip zones)");
        }
    } else if (c.result.plan.shear) {
        c.note("q: shear traction under full stick, positive towards +x on the body that Q acts "
               "on; the q columns are as those of p");
    }
}

int pressure(const ComputeOptions& o) {
    check_figure_option(o);
    Computing c(o);
    scene::Ask& ask = c.scene.ask;
    std::vector<QuantityGroup> others{QuantityGroup::shear, QuantityGroup::contact,
                                      QuantityGroup::peak};
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name()) {
            others.push_back(row.group);
        }
    }
    const bool no_shear = !c.scene.shear && !c.scene.steps.empty() &&
                          o.word("quantities").find("shear") != std::string::npos;
    // Values of the whole contact are given alone if no pressures are requested with them.
    const auto of_contact = [](QuantityGroup group) {
        return group == QuantityGroup::contact || group == QuantityGroup::peak;
    };
    const bool alone = std::ranges::any_of(ask.quantities, of_contact) &&
                       !ask.wants(QuantityGroup::pressure) &&
                       std::ranges::none_of(others, [&](QuantityGroup group) {
                           return !of_contact(group) && ask.wants(group);
                       });
    ask_for(c.scene, o, QuantityGroup::pressure, others);
    if (alone || (ask.u.empty() && ask.wants(QuantityGroup::peak))) {
        ask.quantities.erase(QuantityGroup::pressure);
        ask.u.clear();
    }
    c.result = done(c.scene, o);
    c.table = values_table(c.scene, c.result);
    const scene::Plan& plan = c.result.plan;
    const bool by_name = std::ranges::any_of(
        ask.u, [](const scene::AskedPoint& point) { return point.place.has_value(); });
    c.note("u: distance inwards from the edge; x: place; p: pressure, in the unit of the "
           "contact modulus; |p - exact| <= p_bound");
    if (by_name) {
        c.note("asked: the point as the scene writes it; where a or b is solved for, the bounds "
               "cover how far u is known");
    }
    if (plan.peak) {
        c.note("p_max: the greatest pressure of the contact");
    }
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.by_its_own_name() && ask.wants(row.group)) {
            c.note(scene::symbol_of({row.quantity}) + ": " + std::string(row.meaning));
        }
    }
    if (plan.terms > 0) {
        c.note("local_n: the sum of the first n terms at that edge; rel_n: |1 - local_n/p|");
    }
    const std::vector<report::Fact> facts = c.table.facts;
    c.add_slip_facts();
    note_shear(c);
    c.table.asked = plan.print_pressure
                        ? "pressure p at the distance u from an edge (at the place x)"
                    : plan.peak ? "the greatest pressure"
                                : "the edges and the load";
    if (plan.print_pressure) {
        return c.write(columns_at_points(c, by_name, no_shear), lines_of(c.result.points()));
    }
    write_facts(c.table, facts);
    return c.write();
}

int expand(const ComputeOptions& o) {
    if (!o.angle.empty()) {
        return expand_stresses(o);
    }
    if (!o.body.empty()) {
        throw InputError("--body " + o.body +
                             " has no effect: without --angle no stress is computed",
                         "leave --body out");
    }
    check_figure_option(o);
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
    check_figure_option(o);
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

struct Set {
    const char* name;
    int (*compute)(const ComputeOptions&);
    const char* help;
    const char* footer;
};
constexpr Set sets[] = {
    {"pressure", pressure, "pressures of a scene, each with a bound", ""},
    {"expand", expand, "coefficients of the expansion at the edges, with bounds",
     "Of several numbers of terms the greatest; 3 where none is given. Both edges unless the scene "
     "has edges."},
    {"extent", extent, "how far from each edge n terms stay within a tolerance of the pressure",
     "1, 2 and 3 terms at both edges unless the scene has terms and edges."},
    {"slip", slip, "the slip zones of a scene with friction, exact and by n terms of their series",
     "P is held, then Q (and bulk_tension) are applied. What slips has |q| = f p in the\n"
     "direction of Q; what sticks is strained alike in both bodies. With a tolerance, the Q/(f P)\n"
     "up to which n terms stay within it is found, too. See docs/partial-slip.md."},
    {"stress", stress, "stresses at points of a body, each with a bound",
     "z is the depth into the body. [shear] bulk_A is the bulk stress of body A, and B has\n"
     "bulk_A + bulk_tension. See docs/stress.md."},
    {"displacement", displacement,
     "the gap outside the contact and the slip inside, each with a bound", "See docs/stress.md."}};

void add_set(CLI::App& app, int& code, const Set& set) {
    auto [sub, o] = add_command<ComputeOptions>(app, code, set.name, set.help, set.compute);
    add_scene_options(sub, o);
    if (*set.footer != '\0') {
        sub.footer(set.footer);
    }
    const std::string_view name = set.name;
    if (name == "pressure" || name == "expand" || name == "extent") {
        sub.add_option("--figure", o.figure,
                       "also draw the pressure and the first terms (edgeproof plot) into this "
                       "file: .svg, .png or .pdf");
    }
    if (name == "expand" || name == "stress" || name == "displacement") {
        sub.add_option("--body", o.body,
                       "the body, A (default; Q acts on it) or B: of the stresses, of --angle, of "
                       "the surface")
            ->type_name("A|B");
    }
    if (name == "expand") {
        sub.add_option("--angle", o.angle,
                       "stresses instead of the pressure, along a ray into the body at this "
                       "angle: 0 degrees is along the contact, 90 downwards, 180 along the free "
                       "surface");
    } else if (name == "stress") {
        sub.add_option("--point", o.points,
                       "X,Z: place and depth (default: points of [ask]); repeatable")
            ->allow_extra_args(false);
        sub.add_option("--greatest", o.greatest,
                       "mises, tau_max (for z >= 0) or sxx (at z = 0): one row, the greatest value "
                       "and its place, proved; of an axisymmetric contact tau_max on the axis");
    } else if (name == "displacement") {
        sub.add_option("--reference", o.reference,
                       "the place x whose displacement is 0: adds ux, uz, slope and dissipation of "
                       "the surface of a body (default: the scene's)");
    }
}

} // namespace

void add_sets(CLI::App& app, int& code) {
    for (const Set& set : sets) {
        add_set(app, code, set);
    }
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/commands/compute.hpp"

namespace edgeproof::cli {

using scene::Quantity;
using scene::QuantityGroup;

void Computing::run(QuantityGroup own, const std::vector<QuantityGroup>& others) {
    ask_for(scene, o, own, others);
    run();
}

void Computing::run() {
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

std::string edge_of(const Line& line) { return scene::edge_name(line.at.edge()); }

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

namespace {

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
        sub.add_option(
            "--greatest", o.greatest,
            "mises, tau_max (for z >= 0) or sxx (at z = 0): one row, the greatest value "
            "and its place, proved; of an axisymmetric contact tau_max or mises, on the axis");
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

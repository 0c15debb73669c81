// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/commands/compute.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace edgeproof::cli {

using scene::Quantity;
using scene::QuantityGroup;

namespace {

/// The values of each quantity with their routes and bits: a line each.
std::string values_by_quantity(const scene::SceneResult& result) {
    struct Values {
        std::size_t count = 0;
        std::size_t proved = 0;
        long bits = 0;
        std::set<std::string> routes;
    };
    std::map<scene::Quantity, Values> by_quantity;
    for (const scene::Row& row : result.rows) {
        if (row.value) {
            Values& values = by_quantity[row.asked.quantity];
            ++values.count;
            values.proved += row.value->proved ? 1 : 0;
            values.bits = std::max(values.bits, row.value->value.bits());
            values.routes.insert(row.value->route);
        }
    }
    std::string text;
    for (const auto& [quantity, values] : by_quantity) {
        const scene::QuantityRow& row = row_of(quantity);
        text += fmt::format("{}: {} value{}, {} proved, at most {} bits, {}\n",
                            row.symbol.empty() ? row.name : row.symbol, values.count,
                            values.count == 1 ? "" : "s", values.proved, values.bits,
                            fmt::join(values.routes, "; "));
    }
    return text;
}

} // namespace

void Computing::run(QuantityGroup own, const std::vector<QuantityGroup>& others) {
    ask_for(scene, o, own, others);
    run();
}

void Computing::run() {
    scene::RunProgress progress;
    result = with_progress("values", progress, [&] {
        return io::at_place(scene.file, scene.load_line,
                            [&] { return run_scene(scene, progress); });
    });
    if (o.has("--verbose")) {
        std::fputs(values_by_quantity(result).c_str(), stderr);
    }
    table.title = scene.title;
    table.facts = {{"scene", scene.file},
                   {"digits", std::to_string(scene.ask.digits.count)},
                   {"rounding", std::string(rounding_name(scene.ask.digits.rounding))}};
    if (scene.units) {
        table.facts.push_back({"units", scene.units->text(scene.round.has_value())});
    }
    add_fact(scene::symbol_of({Quantity::alpha}), Quantity::alpha);
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.quantity != Quantity::alpha &&
            (row.group == QuantityGroup::contact || row.group == QuantityGroup::peak)) {
            add_fact(scene::symbol_of({row.quantity}), row.quantity);
        }
    }
    if (const scene::Row* const P = result.find(Quantity::P); P != nullptr && scene.slides()) {
        const auto number = [&](const formula::Exact& x) {
            return formula::ball_of(x, P->value->value.bits());
        };
        add_fact("Q", Quantity::P,
                 {scene.shear->force(number, [&] { return P->value->value; }), true, "f P"});
    }
}

void Computing::add_fact(const std::string& key, Quantity quantity) {
    if (const scene::Row* row = result.find(quantity)) {
        add_fact(key, quantity, *row->value);
    }
}

void Computing::add_fact(const std::string& key, Quantity quantity,
                         const scene::BoundedValue& value) {
    const scene::PrintedValue p = printed(value, scene.ask.digits);
    table.facts.push_back({key, p.text, p.bound, how(value, p), unit_of(scene, quantity)});
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
        add_fact(key, quantity);
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

int Computing::write(const std::vector<std::string>& remarks) {
    if (!bounds.empty()) {
        table.remarks.push_back(bounds);
    }
    table.remarks.insert(table.remarks.end(), remarks.begin(), remarks.end());
    if (!o["--figure"].empty()) {
        io::write_whole(o["--figure"], report::picture_file(picture_of(scene), o["--figure"]));
    }
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

} // namespace edgeproof::cli

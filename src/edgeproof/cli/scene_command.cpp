// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include "edgeproof/io/error_place.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace edgeproof::cli {
namespace {

/// Adds the value of a quantity of the contact, if it was computed.
void add_fact(std::vector<report::Fact>& facts, const std::string& key, const scene::Scene& scene,
              const scene::SceneResult& result, scene::Quantity quantity) {
    if (const scene::Row* row = result.find(quantity)) {
        const scene::PrintedValue p = printed(*row->value, scene.ask.digits);
        facts.push_back({key, p.text, p.bound, how(*row->value, p), unit_of(scene, quantity)});
    }
}

/// Returns a unit to a power of n/2: "mm", "mm^2", "mm^(-1/2)".
std::string power_of(const std::string& unit, int halves) {
    return halves == 2       ? unit
           : halves % 2 == 0 ? fmt::format("{}^{}", unit, halves / 2)
                             : fmt::format("{}^({}/2)", unit, halves);
}

/// The values of each quantity with their routes and bits, and the work done: a line each.
std::string facts_of_work(const scene::SceneResult& result) {
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
    const scene::Counts& counts = result.work.counts;
    for (const auto& [count, what] :
         {std::pair{counts.tilts, "tilts solved for"},
          {counts.load_inversions, "contacts whose size was solved for"},
          {counts.consistency, "contacts whose other edge was solved for"},
          {counts.closed_forms, "pressures in closed form"},
          {counts.quadratures, "pressures by quadrature"},
          {counts.expansions + counts.shear_expansions, "expansions"},
          {counts.stick_zones, "stick zones solved"},
          {counts.extents, "searches for extents"},
          {result.work.raised, "contacts solved again with more bits"}}) {
        text += count > 0 ? fmt::format("{}: {}\n", what, count) : "";
    }
    return text;
}

} // namespace

scene::SceneResult done(const scene::Scene& scene, const SceneOptions& o) {
    scene::RunOptions options;
    scene::SceneResult result = with_progress("values", options.progress, [&] {
        return io::at_place(scene.file, scene.load_line, [&] { return run_scene(scene, options); });
    });
    if (o.verbose) {
        std::fputs(facts_of_work(result).c_str(), stderr);
    }
    return result;
}

report::ScenePicture picture_of(scene::Scene scene) {
    ask_terms(scene);
    if (!scene.ask.tolerance) {
        scene.ask.tolerance = tolerance_of("1%");
    }
    Progress progress("values");
    return io::at_place(scene.file, scene.load_line,
                        [&] { return report::scene_picture(scene, std::ref(progress)); });
}

void add_figure_option(CLI::App& sub, SceneOptions& o) {
    sub.add_option("--figure", o.figure,
                   "also draw the pressure and these terms (edgeproof plot) into this file: "
                   ".svg, .png, .pdf or .html");
}

void check_figure_option(const SceneOptions& o) {
    if (!o.figure.empty()) {
        report::check_picture_name(o.figure);
        io::check_output(o.figure);
    }
}

void draw_figure_option(const scene::Scene& scene, const SceneOptions& o) {
    if (!o.figure.empty()) {
        io::write_whole(o.figure,
                        report::picture_file(picture_of(scene), title_of(scene), o.figure));
    }
}

std::string title_of(const scene::Scene& scene) {
    return scene.title.empty() ? scene.file : scene.title;
}

std::vector<report::Fact> facts_of(const scene::Scene& scene, const scene::SceneResult& result) {
    const scene::Digits& digits = scene.ask.digits;
    std::vector<report::Fact> facts{{"scene", scene.file}};
    facts.push_back({"digits", std::to_string(digits.count)});
    facts.push_back({"rounding", std::string(rounding_name(digits.rounding))});
    if (scene.units) {
        facts.push_back({"units", scene.units->text(scene.round.has_value())});
    }
    using scene::Quantity;
    const auto add = [&](Quantity quantity) {
        add_fact(facts, scene::symbol_of({quantity}), scene, result, quantity);
    };
    add(Quantity::alpha);
    for (const scene::QuantityRow& row : scene::quantity_rows()) {
        if (row.quantity != Quantity::alpha && (row.group == scene::QuantityGroup::contact ||
                                                row.group == scene::QuantityGroup::peak)) {
            add(row.quantity);
        }
    }
    return facts;
}

report::Table values_table(const scene::Scene& scene, const scene::SceneResult& result) {
    report::Table table;
    table.title = scene.title;
    table.facts = facts_of(scene, result);
    return table;
}

void add_slip_facts(std::vector<report::Fact>& facts, const scene::Scene& scene,
                    const scene::SceneResult& result) {
    using scene::Quantity;
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

std::string bound_note() {
    return "bounds are proved, and every digit printed is right, unless the route says estimate";
}

std::string unit_of(const scene::Scene& scene, scene::Quantity quantity, std::size_t k) {
    const scene::QuantityRow& row = row_of(quantity);
    if (!scene.units) {
        return "";
    }
    const auto& [length, force, pressure] = *scene.units;
    const bool whole_force = scene.round && (quantity == scene::Quantity::P ||
                                             quantity == scene::Quantity::cycle_energy);
    const double order =
        row.index == scene::QuantityRow::Index::order ? static_cast<double>(k) : 0.0;
    const int halves =
        static_cast<int>(std::lround(2 * (row.length_power - order))) + (whole_force ? 2 : 0);
    if (row.force_power == 0) {
        return halves != 0 && length ? power_of(length->name, halves) : "";
    }
    if (halves == 2 && force) {
        return force->name;
    }
    if (halves == 4 && force && length) {
        return force->name + " " + length->name;
    }
    if (halves == 0 && force && length) {
        return force->name + "/" + length->name;
    }
    if (halves == -2) { // force per square of a length
        return pressure          ? pressure->name
               : force && length ? force->name + "/" + length->name + "^2"
                                 : "";
    }
    return pressure && length ? pressure->name + " " + power_of(length->name, halves + 2) : "";
}

void append_value(std::vector<std::string>& row, const std::optional<scene::BoundedValue>& value,
                  bool route, const scene::Digits& digits) {
    if (!value) {
        row.resize(row.size() + 2 + (route ? 1 : 0) + (digits.binary64 ? 1 : 0));
        return;
    }
    const scene::PrintedValue p = printed(*value, digits);
    row.push_back(p.text);
    row.push_back(p.bound);
    if (route) {
        row.push_back(how(*value, p));
    }
    if (digits.binary64) {
        row.push_back(p.binary64 ? fmt::format("{}", *p.binary64) : "");
    }
}

void show_as_file(const OutputOptions& o) {
    if (o.show_scene && !o.as_file.empty()) {
        std::fputs(("# the scene that these quantities stand for\n" + o.as_file).c_str(), stderr);
        std::fflush(stderr);
    }
}

void emit(const report::Table& given, const OutputOptions& o) {
    const report::Table table =
        o.columns.empty() ? given : with_columns(given, parts_of(o.columns));
    const bool shown = o.out.empty() || o.out == "-";
    const std::string text =
        o.is_short() ? short_answer(table, terminal_width()) +
                           "(more digits: --digits N; all columns: --format csv)\n"
                     : write_table(table, format_of(o.format),
                                   {.width = shown ? width_to_wrap_at() : 0, .notes = !o.no_notes});
    if (!shown) {
        io::write_output(o.out, text); // if this fails, its message is the only one
    }
    show_as_file(o);
    if (shown) {
        io::write_output("-", text);
    }
}

} // namespace edgeproof::cli

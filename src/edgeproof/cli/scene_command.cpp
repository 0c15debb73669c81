// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include "edgeproof/io/text_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace edgeproof::cli {
namespace {

/// Returns a unit to a power of n/2: "mm", "mm^2", "mm^(-1/2)".
std::string power_of(const std::string& unit, int halves) {
    return halves == 2       ? unit
           : halves % 2 == 0 ? fmt::format("{}^{}", unit, halves / 2)
                             : fmt::format("{}^({}/2)", unit, halves);
}

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

scene::SceneResult done(const scene::Scene& scene, const SceneOptions& o) {
    scene::RunProgress progress;
    scene::SceneResult result = with_progress("values", progress, [&] {
        return io::at_place(scene.file, scene.load_line,
                            [&] { return run_scene(scene, progress); });
    });
    if (o.verbose) {
        std::fputs(values_by_quantity(result).c_str(), stderr);
    }
    return result;
}

std::vector<report::Plot> picture_of(const scene::Scene& scene) {
    Progress progress("values");
    return io::at_place(scene.file, scene.load_line,
                        [&] { return report::scene_picture(scene, std::ref(progress)); });
}

void check_figure_option(const std::string& figure) {
    if (!figure.empty()) {
        report::check_picture_name(figure);
        io::check_output(figure);
    }
}

void draw_figure_option(const scene::Scene& scene, const SceneOptions& o) {
    if (!o.figure.empty()) {
        io::write_whole(o.figure, report::picture_file(picture_of(scene), o.figure));
    }
}

void add_fact(std::vector<report::Fact>& facts, const std::string& key, const scene::Scene& scene,
              const scene::SceneResult& result, scene::Quantity quantity) {
    if (const scene::Row* row = result.find(quantity)) {
        const scene::PrintedValue p = printed(*row->value, scene.ask.digits);
        facts.push_back({key, p.text, p.bound, how(*row->value, p), unit_of(scene, quantity)});
    }
}

report::Table values_table(const scene::Scene& scene, const scene::SceneResult& result) {
    const scene::Digits& digits = scene.ask.digits;
    report::Table table;
    table.title = scene.title;
    std::vector<report::Fact>& facts = table.facts;
    facts = {{"scene", scene.file},
             {"digits", std::to_string(digits.count)},
             {"rounding", std::string(rounding_name(digits.rounding))}};
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
    return table;
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

std::vector<Line> lines_of(const std::vector<scene::RowsAt>& places) {
    std::vector<Line> lines;
    for (const scene::RowsAt& place : places) {
        lines.push_back({place});
    }
    return lines;
}

report::Column& Columns::add(const std::string& name, Kind kind, Text cell) {
    columns_.push_back({name, kind});
    cells_.emplace_back(
        [cell = std::move(cell)](const Line& line, auto& row) { row.push_back(cell(line)); });
    return columns_.back();
}

report::Column& Columns::text(const std::string& name, Text cell, std::string phrase) {
    report::Column& column = add(name, Kind::text, std::move(cell));
    column.phrase = std::move(phrase);
    return column;
}

report::Column& Columns::number(const std::string& name, scene::Quantity quantity, std::size_t n) {
    const scene::Digits digits = digits_of(quantity, scene_.ask.digits);
    report::Column& column = add(name, Kind::number, [=](const Line& line) {
        const scene::Row* const row = line.at.find(quantity, n == 0 ? line.n : n);
        return row != nullptr && row->value ? printed(*row->value, digits).text : std::string();
    });
    column.unit = unit_of(scene_, quantity);
    return column;
}

report::Column& Columns::value(const std::string& name, const std::string& route, Value value) {
    const std::size_t first = columns_.size();
    const scene::Digits digits = scene_.ask.digits;
    columns_.push_back({name});
    columns_.push_back({name + "_bound"});
    columns_.back().role = report::Column::Role::bound;
    if (!route.empty()) {
        columns_.push_back({route, Kind::text});
        columns_.back().role = report::Column::Role::route;
    }
    if (digits.binary64) {
        columns_.push_back({name + "_binary64"});
    }
    cells_.emplace_back([value = std::move(value), with_route = !route.empty(),
                         digits](const Line& line, std::vector<std::string>& row) {
        const std::optional<scene::BoundedValue> x = value(line);
        const scene::PrintedValue p = x ? printed(*x, digits) : scene::PrintedValue{};
        row.push_back(p.text);
        row.push_back(p.bound);
        if (with_route) {
            row.push_back(x ? how(*x, p) : "");
        }
        if (digits.binary64) {
            row.push_back(p.binary64 ? fmt::format("{}", *p.binary64) : "");
        }
    });
    return columns_[first];
}

report::Column& Columns::value(const std::string& name, const std::string& route,
                               scene::Quantity quantity) {
    report::Column& column = value(name, route, [=](const Line& line) {
        const scene::Row* const row = line.at.find(quantity, line.n);
        return row != nullptr ? row->value : std::nullopt;
    });
    column.unit = unit_of(scene_, quantity);
    return column;
}

void Columns::write(report::Table& table, const std::vector<Line>& lines) const {
    table.columns = columns_;
    for (const Line& line : lines) {
        table.rows.emplace_back().reserve(columns_.size());
        for (const auto& cell : cells_) {
            cell(line, table.rows.back());
        }
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
                     : write_table(table, o.table_format(),
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

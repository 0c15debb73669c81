// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace edgeproof::cli {
namespace {

/// Returns a unit to a power of n/2: "mm", "mm^2", "mm^(-1/2)".
std::string power_of(const std::string& unit, int halves) {
    return halves == 2       ? unit
           : halves % 2 == 0 ? fmt::format("{}^{}", unit, halves / 2)
                             : fmt::format("{}^({}/2)", unit, halves);
}

} // namespace

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

report::Column& Row::add(const std::string& name, Column::Kind kind, std::string cell,
                         Column::Role role) {
    std::vector<std::string>& cells = table_.rows.back();
    if (cells.size() == table_.columns.size()) {
        table_.columns.push_back({name, kind});
        table_.columns.back().role = role;
    }
    cells.push_back(std::move(cell));
    return table_.columns[cells.size() - 1];
}

report::Column& Row::text(const std::string& name, std::string cell, std::string phrase) {
    Column& column = add(name, Column::Kind::text, std::move(cell));
    column.phrase = std::move(phrase);
    return column;
}

report::Column& Row::number(const std::string& name, scene::Quantity quantity, std::size_t n) {
    const scene::Row* const row = line_.at.find(quantity, n == 0 ? line_.n : n);
    Column& column = add(name, Column::Kind::number,
                         row != nullptr && row->value
                             ? printed(*row->value, digits_of(quantity, scene_.ask.digits)).text
                             : std::string());
    column.unit = unit_of(scene_, quantity);
    return column;
}

report::Column& Row::value(const std::string& name, const std::string& route,
                           const std::optional<scene::BoundedValue>& value) {
    using Kind = Column::Kind;
    const scene::Digits& digits = scene_.ask.digits;
    const scene::PrintedValue p = value ? printed(*value, digits) : scene::PrintedValue{};
    const std::size_t first = table_.rows.back().size();
    add(name, Kind::number, p.text);
    add(name + "_bound", Kind::number, p.bound, Column::Role::bound);
    if (!route.empty()) {
        add(route, Kind::text, value ? how(*value, p) : "", Column::Role::route);
    }
    if (digits.binary64) {
        add(name + "_binary64", Kind::number, p.binary64 ? fmt::format("{}", *p.binary64) : "");
    }
    return table_.columns[first];
}

report::Column& Row::value(const std::string& name, const std::string& route,
                           scene::Quantity quantity) {
    const scene::Row* const row = line_.at.find(quantity, line_.n);
    Column& column = value(name, route, row != nullptr ? row->value : std::nullopt);
    column.unit = unit_of(scene_, quantity);
    return column;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/cli/scene_command.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <set>
#include <utility>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_scene = 100'000;

Rounding rounding_of(const std::string& name) {
    if (const auto mode = rounding_named(name.empty() ? "nearest" : name)) {
        return *mode;
    }
    throw InputError("--round " + name + " is no way to round", "write nearest, down or up");
}

/// Returns a unit to a power of n/2: "mm", "mm^2", "mm^(-1/2)".
std::string power_of(const std::string& unit, int halves) {
    return halves == 2       ? unit
           : halves % 2 == 0 ? fmt::format("{}^{}", unit, halves / 2)
                             : fmt::format("{}^({}/2)", unit, halves);
}

} // namespace

bool is_short(const Options& o) {
    return o.values.contains("scene") && o.values.contains("--columns") &&
           (o["--format"] == "text" ||
            (o["--format"].empty() && o["--out"].empty() && ::isatty(STDOUT_FILENO) == 1));
}

report::TableFormat table_format(const Options& o) {
    return format_of(is_short(o) ? "" : o["--format"]);
}

std::string word_of(const Options& o, std::string_view key) {
    return scene::value_of(o.list("scene"), key);
}

void choose_step(scene::Scene& scene, const std::string& step) {
    if (step.empty()) {
        return;
    }
    require(!scene.steps.empty(), "--step " + step + ": the scene has no steps",
            "add [[step]] sections, or leave --step out");
    set_step(scene, whole_number("--step", step, 1, scene.steps.size()));
}

void refuse_words(const Options& o, const std::vector<std::string_view>& keys,
                  const std::string& why) {
    for (const std::string_view key : keys) {
        if (const std::string value = word_of(o, key); !value.empty()) {
            throw InputError(std::string(key) + "=" + value + " has no effect: " + why,
                             "leave " + std::string(key) + " out");
        }
    }
}

scene::Scene read_scene(const GivenScene& given) {
    return given.file.empty() ? scene::parse_scene("", "command line", given.instead)
                              : scene::read_scene(given.file, given.instead);
}

scene::Scene asked_scene(const Options& o) {
    (void)table_format(o); // checked before any work
    const Rounding rounding = rounding_of(o["--round"]);
    const GivenScene given = given_scene(o.list("scene"), shipped_scenes);
    if (given.file.empty()) {
        std::vector<std::string> shown = o.list("scene");
        if (!o["--digits"].empty()) {
            shown.push_back("digits=" + o["--digits"]);
        }
        o.as_file = scene::scene_text(given_scene(shown, shipped_scenes).instead);
    }
    scene::Scene scene = read_scene(given);
    choose_step(scene, o["--step"]);
    if (!o["--digits"].empty()) {
        scene.ask.digits.count = digits_of(o["--digits"], most_digits_of_a_scene);
    } else if (is_short(o) && word_of(o, "digits").empty()) {
        scene.ask.digits.count = digits_of_short_answer;
    }
    scene.ask.digits.exact = o.has("--exact");
    scene.ask.digits.rounding = rounding;
    scene.ask.digits.binary64 = o.has("--binary64");
    io::check_output(o["--out"]);
    return scene;
}

void ask_at_edges(scene::Scene& scene) {
    if (!scene.ask.edges_given) {
        scene.ask.edges = {contact::Edge::right, contact::Edge::left};
    }
}

void ask_terms(scene::Scene& scene) {
    if (scene.ask.terms.empty()) {
        scene.ask.terms = {1, 2, 3};
    }
}

void ask_for(scene::Scene& scene, const Options& o, scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& other_groups) {
    std::set<scene::QuantityGroup> all{own};
    std::ranges::copy_if(other_groups, std::inserter(all, all.end()),
                         [&](scene::QuantityGroup group) { return scene.ask.wants(group); });
    for (const scene::QuantityGroup group : scene.ask.quantities) {
        if (!word_of(o, "quantities").empty() && !all.contains(group)) {
            std::string given = group_name(own);
            for (const scene::QuantityGroup& other : other_groups) {
                given += (&other == &other_groups.back() ? " or " : ", ") + group_name(other);
            }
            throw InputError("quantities=" + word_of(o, "quantities") +
                                 ": this command does not give the " + group_name(group),
                             "write " + given);
        }
    }
    scene.ask.quantities = std::move(all);
}

std::size_t whole_number(const std::string& option, const std::string& text, std::size_t least,
                         std::size_t most) {
    const auto value = io::read_whole<std::size_t>(text);
    require(value && *value >= least && *value <= most, option + " " + text + " is out of range",
            fmt::format("give a whole number from {} to {}", least, most));
    return *value;
}

unsigned digits_of(const std::string& text, std::size_t most) {
    return static_cast<unsigned>(whole_number("--digits", text, 2, most));
}

unsigned threads_of(const std::string& text) {
    return text.empty() ? 0
                        : static_cast<unsigned>(whole_number("--threads", text, 0, most_threads));
}

report::TableFormat format_of(const std::string& name) {
    const auto format = report::table_format(name.empty() ? "csv" : name);
    if (!format) {
        throw InputError("--format " + name + " is no format", "write csv, json, md, tex or text");
    }
    return *format;
}

bool text_or_json(const std::string& format) {
    require(format.empty() || format == "text" || format == "json",
            "--format " + format + " is no format", "write text or json");
    return format == "json";
}

std::vector<report::Plot> picture_of(const scene::Scene& scene, report::Panels panels) {
    Progress progress("values");
    return io::at_place(scene.file, scene.load_line,
                        [&] { return report::scene_picture(scene, std::ref(progress), panels); });
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

void show_as_file(const Options& o) {
    if (o.has("--show-scene") && !o.as_file.empty()) {
        std::fputs(("# the scene that these quantities stand for\n" + o.as_file).c_str(), stderr);
        std::fflush(stderr);
    }
}

void emit(const report::Table& given, const Options& o) {
    const report::Table table =
        o["--columns"].empty() ? given : with_columns(given, parts_of(o["--columns"]));
    const bool shown = o["--out"].empty() || o["--out"] == "-";
    const std::string text =
        is_short(o)
            ? short_answer(table, terminal_width()) +
                  "(more digits: --digits N; all columns: --format csv)\n"
            : write_table(table, table_format(o),
                          {.width = shown ? width_to_wrap_at() : 0, .notes = !o.has("--no-notes")});
    if (!shown) {
        io::write_output(o["--out"], text); // if this fails, its message is the only one
    }
    show_as_file(o);
    if (shown) {
        io::write_output("-", text);
    }
}

} // namespace edgeproof::cli

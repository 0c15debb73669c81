// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/shipped_file.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <filesystem>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_scene = 100'000;
constexpr std::size_t most_terms = 400;
constexpr std::size_t most_threads = 1024;

Rounding rounding_of(const std::string& name) {
    if (const auto mode = rounding_named(name)) {
        return *mode;
    }
    throw InputError("--round " + name + " is no way to round",
                     "write nearest, down, up or enclosure");
}

report::TableFormat format_of(const std::string& name) {
    const auto format = report::table_format(name);
    if (!format) {
        throw InputError("--format " + name + " is no format", "write csv, json, md or tex");
    }
    return *format;
}

report::Fact fact(const std::string& key, const scene::BoundedValue& value,
                  const scene::Digits& digits) {
    const scene::PrintedValue p = printed(value, digits);
    return {key, p.text, p.bound, how(value, p)};
}

void add_fact(std::vector<report::Fact>& facts, const std::string& key,
              const std::optional<scene::BoundedValue>& value, const scene::Digits& digits) {
    if (value) {
        facts.push_back(fact(key, *value, digits));
    }
}

} // namespace

void add_scene_options(CLI::App& sub, SceneOptions& o) {
    sub.add_option("scene", o.scene, "the scene (TOML)")->required();
    sub.add_option("--digits", o.digits, "significant digits (default: the scene's, else 50)");
    sub.add_option("--format", o.format, "csv, json, md or tex")->capture_default_str();
    sub.add_option("--out", o.out, "write to this file, whole or not at all (-: standard output)");
    sub.add_option("--round", o.rounding, "nearest, down, up or enclosure")->capture_default_str();
    sub.add_flag("--binary64", o.binary64, "add the binary64 nearest to each value");
}

void add_edge_option(CLI::App& sub, SceneOptions& o) {
    sub.add_option("--edge", o.edges, "right, left or both (default: both)");
}

std::size_t whole_number(const std::string& option, const std::string& text, std::size_t least,
                         std::size_t most) {
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value < least || value > most) {
        throw InputError(option + " " + text + " is out of range",
                         fmt::format("give a whole number from {} to {}", least, most));
    }
    return value;
}

unsigned threads_of(const std::string& text) {
    return text.empty() ? 0
                        : static_cast<unsigned>(whole_number("--threads", text, 1, most_threads));
}

std::vector<std::size_t> numbers_of_terms(const std::string& option, const std::string& text) {
    std::vector<std::size_t> numbers;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        numbers.push_back(whole_number(option, text.substr(at, comma - at), 1, most_terms));
        at = comma + 1;
    }
    return numbers;
}

void check_state(const std::string& file) {
    if (file.empty()) {
        return;
    }
    io::check_output(file);
    if (file == "-" || io::OutputTarget::of(file).special) {
        throw InputError("--state " + file + ": a state is read again, which that cannot be",
                         "name a file");
    }
}

scene::Scene asked_scene(const SceneOptions& o) {
    (void)format_of(o.format); // before any work
    const Rounding rounding = rounding_of(o.rounding);
    scene::Scene scene = scene::read_scene(file_or_shipped(o.scene, shipped_scenes));
    if (!o.digits.empty()) {
        scene.ask.digits.count =
            static_cast<unsigned>(whole_number("--digits", o.digits, 2, most_digits_of_a_scene));
    }
    scene.ask.digits.rounding = rounding;
    scene.ask.digits.binary64 = o.binary64;
    io::check_output(o.out);
    return scene;
}

std::vector<contact::Edge> asked_edges(const SceneOptions& o) {
    if (o.edges.empty() || o.edges == "both") {
        return {contact::Edge::right, contact::Edge::left};
    }
    if (const auto edge = scene::edge_named(o.edges)) {
        return {*edge};
    }
    throw InputError("--edge " + o.edges + ": there is no such edge", "write right, left or both");
}

scene::SceneResult done(const scene::Scene& scene) {
    Progress progress("values");
    scene::RunOptions options;
    options.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
    return io::at_place(scene.file, scene.load_line, [&] { return run_scene(scene, options); });
}

std::vector<report::Fact> facts_of(const scene::Scene& scene, const scene::SceneResult& result) {
    const scene::Digits& digits = scene.ask.digits;
    std::vector<report::Fact> facts{{"scene", scene.file}};
    facts.push_back({"digits", std::to_string(digits.count)});
    facts.push_back({"rounding", std::string(rounding_name(digits.rounding))});
    if (scene.units) {
        facts.push_back({"units", scene.units->text()});
    }
    const scene::ContactValues& contact = result.contact;
    add_fact(facts, "alpha", contact.alpha, digits);
    facts.push_back(fact("a", contact.a, digits));
    facts.push_back(fact("b", contact.b, digits));
    add_fact(facts, "P", contact.force, digits);
    add_fact(facts, "M", contact.moment, digits);
    for (const auto& [quantity, value] : contact.others) {
        facts.push_back(fact(scene::symbol_of({quantity}), value, digits));
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
    const scene::Digits& digits = scene.ask.digits;
    const scene::StickValues& stick = *result.stick;
    facts.push_back({"friction", scene.shear->friction->text()});
    facts.push_back(fact("Q/(f P)", stick.load_ratio, digits));
    facts.push_back(fact("stick_a", stick.a, digits));
    facts.push_back(fact("stick_b", stick.b, digits));
    add_fact(facts, "least_bulk_tension", stick.least_tension, digits);
    add_fact(facts, "most_bulk_tension", stick.most_tension, digits);
    if (!stick.in_proportion) {
        facts.push_back({"path", "Q first: with Q and bulk_tension in proportion one edge would "
                                 "slip against Q at first, as |sigma_0 (a + b)/Q| is not below "
                                 "8/pi"});
    }
}

std::string bound_note(const scene::Plan& plan) {
    return plan.proved ? "bounds are proved, and every digit printed is right, unless the route "
                         "says estimate"
                       : "bounds are estimated (" + plan.proved_why +
                             "), and so is that every digit printed is right";
}

void ValueColumns::add(std::vector<report::Column>& columns, const std::string& name,
                       const std::string& route) const {
    columns.push_back({name});
    columns.push_back({name + "_bound"});
    if (!route.empty()) {
        columns.push_back({route, report::Column::Kind::text});
    }
    if (digits_.binary64) {
        columns.push_back({name + "_binary64"});
    }
}

void ValueColumns::add(std::vector<std::string>& row, const scene::BoundedValue& value,
                       bool route) const {
    const scene::PrintedValue p = printed(value, digits_);
    row.push_back(p.text);
    row.push_back(p.bound);
    if (route) {
        row.push_back(how(value, p));
    }
    if (digits_.binary64) {
        row.push_back(p.binary64
                          ? fmt::format("{}", *p.binary64)
                          : fmt::format("[{}, {}]", p.binary64_between[0], p.binary64_between[1]));
    }
}

void ValueColumns::add_none(std::vector<std::string>& row, bool route) const {
    row.resize(row.size() + 2 + (route ? 1 : 0) + (digits_.binary64 ? 1 : 0));
}

void emit(const report::Table& table, const SceneOptions& o) {
    const std::string text = write_table(table, format_of(o.format));
    io::write_output(o.out.empty() ? "-" : o.out, text);
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_command.hpp"

#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/shipped_file.hpp"
#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
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

/// Returns the scene for the quantities on the command line.
scene::Scene stated_scene(const SceneOptions& o) {
    scene::SceneEntries entries = o.stated.entries();
    if (!o.edges.empty()) {
        entries.ask.push_back({"edges", o.edges == "both"
                                            ? std::vector<std::string>{"right", "left"}
                                            : std::vector<std::string>{o.edges}});
    }
    if (!o.terms.empty()) {
        entries.ask.push_back({"terms", parts_of(o.terms)});
    }
    for (const auto& [key, text] :
         {std::pair{"tolerance", &o.tolerance}, std::pair{"digits", &o.digits}}) {
        if (!text->empty()) {
            entries.ask.push_back({key, *text});
        }
    }
    if (!o.quantities.empty()) {
        entries.ask.push_back({"quantities", parts_of(o.quantities)});
    }
    scene::Scene scene = scene::make_scene(entries);
    scene.file = "command line";
    o.as_file = scene_text(entries);
    return scene;
}

scene::Scene given_scene(const SceneOptions& o) {
    if (o.scene.empty() && !o.stated.given()) {
        throw InputError("no scene is given", "name its file, - for standard input, or give its "
                                              "quantities: --hertz --R 100 --P 120 ...");
    }
    if (!o.scene.empty() && o.stated.given()) {
        throw InputError("a scene is given by its file and by quantities", "give one of the two");
    }
    if (o.scene.empty()) {
        return stated_scene(o);
    }
    return scene::read_scene(file_or_shipped(o.scene, shipped_scenes), o.stated.asked());
}

void ask_quantities(scene::Scene& scene, const std::string& list) {
    if (list.empty()) {
        return;
    }
    scene.ask.quantities.clear();
    for (const std::string& name : parts_of(list)) {
        std::vector<std::string_view> names;
        for (const scene::GroupRow& row : scene::group_rows()) {
            names.push_back(row.name);
            if (row.name == name) {
                scene.ask.quantities.insert(row.group);
            }
        }
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throw InputError(fmt::format("--quantity {}: unknown quantity '{}'", list, name),
                             one_of(name, names));
        }
    }
}

report::Fact fact(const std::string& key, const scene::BoundedValue& value,
                  const scene::Digits& digits) {
    const scene::PrintedValue p = printed(value, digits);
    return {key, p.text, p.bound, how(value, p)};
}

/// Adds the value of a quantity of the contact, if it was computed.
void add_fact(std::vector<report::Fact>& facts, const std::string& key,
              const scene::SceneResult& result, scene::Quantity quantity,
              const scene::Digits& digits) {
    if (const scene::Row* row = result.find(quantity)) {
        facts.push_back(fact(key, *row->value, digits));
    }
}

} // namespace

report::TableFormat format_of(const std::string& name) {
    const auto format = report::table_format(name);
    if (!format) {
        throw InputError("--format " + name + " is no format", "write csv, json, md or tex");
    }
    return *format;
}

void add_given_scene(CLI::App& sub, SceneOptions& o) {
    sub.add_option("scene", o.scene, "the scene (TOML); -: standard input");
    sub.add_option("--edge", o.edges, "right, left or both (default: the scene's)");
    sub.add_option("--terms", o.terms, "numbers of terms, such as 1,2,3 (default: the scene's)");
    sub.add_option("--quantity", o.quantities,
                   "what is asked, such as pressure,shear, as far as the command gives it "
                   "(default: the scene's)");
    o.stated.add_options(sub);
}

void add_scene_options(CLI::App& sub, SceneOptions& o) {
    add_given_scene(sub, o);
    sub.add_option("--digits", o.digits, "significant digits (default: the scene's, else 50)");
    sub.add_option("--format", o.format, "csv, json, md or tex")->capture_default_str();
    sub.add_option("--out", o.out, "write to this file, whole or not at all (-: standard output)");
    sub.add_option("--round", o.rounding, "nearest, down, up or enclosure")->capture_default_str();
    sub.add_flag("--binary64", o.binary64, "add the binary64 nearest to each value");
}

void add_tolerance_option(CLI::App& sub, SceneOptions& o, const std::string& help) {
    sub.add_option("--tolerance", o.tolerance, "1%, 0.01 or 1/100" + help);
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

std::vector<std::size_t> whole_numbers(const std::string& option, const std::string& text,
                                       std::size_t least, std::size_t most) {
    std::vector<std::size_t> numbers;
    for (const std::string& part : parts_of(text)) {
        numbers.push_back(whole_number(option, part, least, most));
    }
    return numbers;
}

std::vector<std::size_t> numbers_of_terms(const std::string& option, const std::string& text) {
    return whole_numbers(option, text, 1, most_terms);
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
    (void)format_of(o.format); // checked before any work
    const Rounding rounding = rounding_of(o.rounding);
    scene::Scene scene = given_scene(o);
    if (!o.digits.empty()) {
        scene.ask.digits.count =
            static_cast<unsigned>(whole_number("--digits", o.digits, 2, most_digits_of_a_scene));
    }
    scene.ask.digits.rounding = rounding;
    scene.ask.digits.binary64 = o.binary64;
    if (o.edges == "both") {
        scene.ask.edges = {contact::Edge::right, contact::Edge::left};
    } else if (!o.edges.empty()) {
        const auto edge = scene::edge_named(o.edges);
        if (!edge) {
            throw InputError("--edge " + o.edges + ": there is no such edge",
                             "write right, left or both");
        }
        scene.ask.edges = {*edge};
    }
    if (!o.terms.empty()) {
        scene.ask.terms = numbers_of_terms("--terms", o.terms);
    }
    if (!o.tolerance.empty()) {
        scene.ask.tolerance = tolerance_of(o.tolerance);
    }
    ask_quantities(scene, o.quantities);
    io::check_output(o.out);
    return scene;
}

void ask_at_edges(scene::Scene& scene, const SceneOptions& o) {
    if (o.edges.empty() && !scene.ask.edges_given) {
        scene.ask.edges = {contact::Edge::right, contact::Edge::left};
    }
}

void ask_terms(scene::Scene& scene) {
    if (scene.ask.terms.empty()) {
        scene.ask.terms = {1, 2, 3};
    }
}

void ask_for(scene::Scene& scene, const SceneOptions& o, scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& other_groups) {
    std::set<scene::QuantityGroup> all{own};
    for (const scene::QuantityGroup group : other_groups) {
        if (scene.ask.wants(group)) {
            all.insert(group);
        }
    }
    for (const scene::QuantityGroup group : scene.ask.quantities) {
        if (!o.quantities.empty() && !all.contains(group)) {
            std::string given = group_name(own);
            for (std::size_t i = 0; i < other_groups.size(); ++i) {
                given +=
                    (i + 1 == other_groups.size() ? " or " : ", ") + group_name(other_groups[i]);
            }
            throw InputError("--quantity " + o.quantities + ": this command does not give the " +
                                 group_name(group),
                             "write " + given);
        }
    }
    scene.ask.quantities = std::move(all);
}

formula::Exact tolerance_of(const std::string& text) {
    try {
        return scene::parse_tolerance(text);
    } catch (const InputError& error) {
        throw InputError("--tolerance " + text + ": " + error.problem(), error.instead());
    }
}

scene::SceneResult done(const scene::Scene& scene) {
    Progress progress("values");
    scene::RunOptions options;
    options.progress = [&](std::size_t done, std::size_t total) { progress(done, total); };
    return io::at_place(scene.file, scene.load_line, [&] { return run_scene(scene, options); });
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

std::string title_of(const scene::Scene& scene) {
    return scene.title.empty() ? scene.file : scene.title;
}

std::vector<report::Fact> facts_of(const scene::Scene& scene, const scene::SceneResult& result) {
    const scene::Digits& digits = scene.ask.digits;
    std::vector<report::Fact> facts{{"scene", scene.file}};
    facts.push_back({"digits", std::to_string(digits.count)});
    facts.push_back({"rounding", std::string(rounding_name(digits.rounding))});
    if (scene.units) {
        facts.push_back({"units", scene.units->text()});
    }
    using scene::Quantity;
    const auto add = [&](Quantity quantity) {
        add_fact(facts, scene::symbol_of({quantity}), result, quantity, digits);
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
    const scene::Digits& digits = scene.ask.digits;
    using scene::Quantity;
    facts.push_back({"friction", scene.shear->friction->text()});
    for (const auto& [key, quantity] :
         {std::pair{"Q/(f P)", Quantity::load_ratio}, std::pair{"stick_a", Quantity::stick_a},
          std::pair{"stick_b", Quantity::stick_b},
          std::pair{"least_bulk_tension", Quantity::least_tension},
          std::pair{"most_bulk_tension", Quantity::most_tension},
          std::pair{"cycle_energy", Quantity::cycle_energy}}) {
        add_fact(facts, key, result, quantity, digits);
    }
    if (!result.in_proportion) {
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

void show_as_file(const SceneOptions& o) {
    if (!o.as_file.empty()) {
        std::fputs(("# the scene that these quantities stand for\n" + o.as_file).c_str(), stderr);
        std::fflush(stderr);
    }
}

void emit(const report::Table& table, const SceneOptions& o) {
    const bool shown = o.out.empty() || o.out == "-";
    const std::string text =
        write_table(table, format_of(o.format), shown ? width_to_wrap_at() : 0);
    if (!shown) {
        io::write_output(o.out, text); // if this fails, its message is the only one
    }
    show_as_file(o);
    if (shown) {
        io::write_output("-", text);
    }
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_options.hpp"

#include "edgeproof/cli/cli.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>
#include <utility>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_scene = 100'000;

Rounding rounding_of(const std::string& name) {
    if (const auto mode = rounding_named(name)) {
        return *mode;
    }
    throw InputError("--round " + name + " is no way to round", "write nearest, down or up");
}

} // namespace

bool OutputOptions::is_short() const {
    return has_table &&
           (format == "text" || (format.empty() && out.empty() && ::isatty(STDOUT_FILENO) == 1));
}

report::TableFormat OutputOptions::table_format() const {
    return format_of(is_short() ? "" : format);
}

void add_table_options(CLI::App& sub, OutputOptions& o) {
    o.has_table = true;
    option(sub, "--format", o.format);
    option(sub, "--out", o.out);
    option(sub, "--columns", o.columns);
    option(sub, "--no-notes", o.no_notes);
}

void add_given_scene(CLI::App& sub, SceneOptions& o) {
    option(sub, "scene", o.words);
    option(sub, "--step", o.step);
    option(sub, "--show-scene", o.show_scene);
}

void add_scene_options(CLI::App& sub, SceneOptions& o) {
    add_given_scene(sub, o);
    option(sub, "--digits", o.digits);
    add_table_options(sub, o);
    option(sub, "--round", o.rounding);
    option(sub, "--verbose", o.verbose);
    option(sub, "--binary64", o.binary64);
    option(sub, "--exact", o.exact);
}

void choose_step(scene::Scene& scene, const std::string& step) {
    if (step.empty()) {
        return;
    }
    require(!scene.steps.empty(), "--step " + step + ": the scene has no steps",
            "add [[step]] sections, or leave --step out");
    set_step(scene, whole_number("--step", step, 1, scene.steps.size()));
}

void refuse_words(const SceneOptions& o, const std::vector<std::string_view>& keys,
                  const std::string& why) {
    for (const std::string_view key : keys) {
        if (const std::string value = o.word(key); !value.empty()) {
            throw InputError(std::string(key) + "=" + value + " has no effect: " + why,
                             "leave " + std::string(key) + " out");
        }
    }
}

scene::Scene asked_scene(const SceneOptions& o) {
    (void)o.table_format(); // checked before any work
    const Rounding rounding = rounding_of(o.rounding);
    const GivenScene given = given_scene(o.words, shipped_scenes);
    if (given.file.empty()) {
        std::vector<std::string> shown = o.words;
        if (!o.digits.empty()) {
            shown.push_back("digits=" + o.digits);
        }
        o.as_file = scene::scene_text(given_scene(shown, shipped_scenes).instead);
    }
    scene::Scene scene = given.file.empty() ? scene::parse_scene("", "command line", given.instead)
                                            : scene::read_scene(given.file, given.instead);
    choose_step(scene, o.step);
    if (!o.digits.empty()) {
        scene.ask.digits.count = digits_of(o.digits, most_digits_of_a_scene);
    } else if (o.is_short() && o.word("digits").empty()) {
        scene.ask.digits.count = digits_of_short_answer;
    }
    scene.ask.digits.exact = o.exact;
    scene.ask.digits.rounding = rounding;
    scene.ask.digits.binary64 = o.binary64;
    io::check_output(o.out);
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

void ask_for(scene::Scene& scene, const SceneOptions& o, scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& other_groups) {
    std::set<scene::QuantityGroup> all{own};
    std::ranges::copy_if(other_groups, std::inserter(all, all.end()),
                         [&](scene::QuantityGroup group) { return scene.ask.wants(group); });
    for (const scene::QuantityGroup group : scene.ask.quantities) {
        if (!o.word("quantities").empty() && !all.contains(group)) {
            std::string given = group_name(own);
            for (const scene::QuantityGroup& other : other_groups) {
                given += (&other == &other_groups.back() ? " or " : ", ") + group_name(other);
            }
            throw InputError("quantities=" + o.word("quantities") +
                                 ": this command does not give the " + group_name(group),
                             "write " + given);
        }
    }
    scene.ask.quantities = std::move(all);
}

std::size_t whole_number(const std::string& option, const std::string& text, std::size_t least,
                         std::size_t most) {
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    require(error == std::errc{} && stop == end && value >= least && value <= most,
            option + " " + text + " is out of range",
            fmt::format("give a whole number from {} to {}", least, most));
    return value;
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

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/scene_options.hpp"

#include "edgeproof/cli/cli.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

namespace edgeproof::cli {
namespace {

constexpr std::size_t most_digits_of_a_scene = 100'000;

struct StatedProfile {
    const char* kind;
    const char* help;
};
constexpr StatedProfile stated_profiles[] = {
    {"power-law", "g' = C x^m: --m, --C"},
    {"hertz", "two cylinders, or one on a flat: --R, or --R1 and --R2"},
    {"cylinder-on-flat", "--R"},
    {"sphere", "two spheres, or one on a flat: --R, or --R1 and --R2"},
    {"wedge", "--phi"},
    {"cone", "--phi"},
    {"flat-and-rounded", "--t (or --flat-width), --R"},
    {"tilted-wedge", "--phi, --alpha"},
    {"tilted-flat-and-rounded", "--alpha, --t, --R"},
};

using scene::SceneEntries;

struct StatedQuantity {
    const char* key; ///< in a scene's file; an underscore is a hyphen on the command line
    SceneEntries::Section SceneEntries::*section;
    const char* help;
    bool list = false;
};
constexpr StatedQuantity stated_quantities[] = {
    {"geometry", &SceneEntries::profile, "plane, or axisymmetric: x is then the radius"},
    {"m", &SceneEntries::profile, "exponent of g'"},
    {"C", &SceneEntries::profile, "factor of g'"},
    {"R", &SceneEntries::profile, "radius"},
    {"R1", &SceneEntries::profile, "radius of the one body"},
    {"R2", &SceneEntries::profile, "radius of the other, negative for a hollow"},
    {"t", &SceneEntries::profile, "half the length of the flat"},
    {"flat_width", &SceneEntries::profile, "length of the flat"},
    {"phi", &SceneEntries::profile, "slope of a wedge's or a cone's flanks"},
    {"alpha", &SceneEntries::profile, "tilt"},
    {"a", &SceneEntries::load, "the right edge"},
    {"width", &SceneEntries::load, "the contact's width, where it is symmetric"},
    {"P", &SceneEntries::load, "normal force per length"},
    {"M", &SceneEntries::load, "moment per length, with P, of an unknown tilt"},
    {"delta", &SceneEntries::load, "approach of an axisymmetric contact"},
    {"contact_modulus", &SceneEntries::load, "E*"},
    {"nu", &SceneEntries::load, "Poisson's ratio of both bodies, with --E or --contact-modulus"},
    {"E1", &SceneEntries::load, "Young's modulus of the one body"},
    {"nu1", &SceneEntries::load, "its Poisson's ratio"},
    {"E2", &SceneEntries::load, "Young's modulus of the other"},
    {"nu2", &SceneEntries::load, "its Poisson's ratio"},
    {"Q", &SceneEntries::shear, "shear force per length"},
    {"bulk_tension", &SceneEntries::shear, "difference of the bulk tensions"},
    {"bulk_A", &SceneEntries::shear, "bulk stress of body A"},
    {"friction", &SceneEntries::shear, "coefficient of friction"},
    {"path", &SceneEntries::shear, "normal-first or together"},
    {"u", &SceneEntries::ask, "points by their distances from the edge: 1e-3,a/2", true},
    {"x", &SceneEntries::ask, "points by their places: 0,a/2", true},
    {"process_zone", &SceneEntries::ask, "a length from the edge"},
};

void add_stated_options(CLI::App& sub, SceneOptions& o) {
    const char* const group = "A scene by its quantities, in place of a file";
    const char* const ask_group = "What is asked, in place of what the scene's file asks";
    for (const StatedProfile& p : stated_profiles) {
        sub.add_flag(std::string("--") + p.kind, o.profiles[p.kind], p.help)->group(group);
    }
    for (const StatedQuantity& q : stated_quantities) {
        std::string name = std::string("--") + q.key;
        std::ranges::replace(name, '_', '-');
        const char* const of = q.section == &SceneEntries::ask ? ask_group : group;
        if (q.list) {
            add_list_option(sub, name, o.stated[q.key], &o.scene, q.help);
            sub.get_option(name)->group(of);
        } else {
            sub.add_option(name, o.stated[q.key], q.help)->group(of);
        }
    }
    sub.get_option("--path")->type_name("normal-first|together");
    sub.get_option("--geometry")->type_name("plane|axisymmetric");
    sub.add_option("--E", o.E, "Young's modulus of both bodies, with --nu")->group(group);
    sub.add_option("--q-ratio", o.q_ratio, "Q/(f P), in place of --Q; with --P and --friction")
        ->group(group);
}

/// Adds the moduli of two equal bodies.
void add_equal_bodies(const SceneOptions& o, SceneEntries& entries) {
    if (o.E.empty()) {
        return;
    }
    const std::string& nu = o.stated.at("nu");
    if (nu.empty()) {
        throw InputError("--E is given without --nu", "add --nu 0.3, Poisson's ratio");
    }
    for (const char* const key : {"contact_modulus", "E1", "nu1", "E2", "nu2"}) {
        if (!o.stated.at(key).empty()) {
            throw InputError(fmt::format("--E and --{} are both given", key),
                             "give --E and --nu for two equal bodies, or --E1, --nu1, --E2 and "
                             "--nu2, or --contact-modulus");
        }
    }
    std::erase_if(entries.load, [](const io::TomlEntry& entry) { return entry.key == "nu"; });
    for (const auto& [key, value] : {std::pair{"E1", &o.E}, std::pair{"nu1", &nu},
                                     std::pair{"E2", &o.E}, std::pair{"nu2", &nu}}) {
        entries.load.push_back({key, *value});
    }
}

/// Adds Q = (Q/(f P)) f P.
void add_load_ratio(const SceneOptions& o, SceneEntries& entries) {
    if (o.q_ratio.empty()) {
        return;
    }
    if (!o.stated.at("Q").empty()) {
        throw InputError("--q-ratio and --Q are both given", "give one of the two");
    }
    for (const char* const key : {"friction", "P"}) {
        if (o.stated.at(key).empty()) {
            throw InputError(fmt::format("--q-ratio is given without --{}", key),
                             "add --friction and --P: Q is the ratio times f P");
        }
    }
    entries.shear.insert(
        entries.shear.begin(),
        {"Q", fmt::format("({})*({})*({})", o.q_ratio, o.stated.at("friction"), o.stated.at("P"))});
}

std::string stated_kind(const SceneOptions& o);

/// True for a word that stands for a scene, and not for a number.
bool names_scene(const std::string& word) {
    std::error_code failed;
    return word == "-" || word.ends_with(".toml") ||
           (word.find('/') != std::string::npos &&
            std::filesystem::is_regular_file(word, failed)) ||
           file_or_shipped(word, shipped_scenes) != word;
}

/// Returns the entries for the options that are given, without the kind of the profile.
SceneEntries stated_entries(const SceneOptions& o) {
    SceneEntries entries;
    for (const StatedQuantity& q : stated_quantities) {
        const std::string& text = o.stated.at(q.key);
        if (!text.empty() && q.list) {
            (entries.*q.section).push_back({q.key, parts_of(text)});
        } else if (!text.empty()) {
            (entries.*q.section).push_back({q.key, text});
        }
    }
    return entries;
}

} // namespace

scene::SceneEntries entries_of(const SceneOptions& o) {
    SceneEntries entries = stated_entries(o);
    add_equal_bodies(o, entries);
    add_load_ratio(o, entries);
    entries.profile.insert(entries.profile.begin(), {"kind", stated_kind(o)});
    return entries;
}

bool is_by_quantities(const SceneOptions& o) {
    const SceneEntries entries = stated_entries(o);
    o.by_quantities =
        !entries.profile.empty() || !entries.load.empty() || !entries.shear.empty() ||
        !o.E.empty() || !o.q_ratio.empty() ||
        std::ranges::any_of(o.profiles, [](const auto& profile) { return profile.second; });
    if (o.scene.empty() && !o.by_quantities) {
        throw InputError("no scene is given", "name its file, - for standard input, or give its "
                                              "quantities: --hertz --R 100 --P 120 ...");
    }
    if (!o.scene.empty() && o.by_quantities) {
        throw InputError("a scene is given by its file and by quantities", "give one of the two");
    }
    return o.by_quantities;
}

namespace {

std::string stated_kind(const SceneOptions& o) {
    std::string kind;
    for (const auto& [name, given] : o.profiles) {
        if (given && !kind.empty()) {
            throw InputError(fmt::format("both --{} and --{} are given", kind, name),
                             "give one profile");
        }
        kind = given ? name : kind;
    }
    if (kind.empty()) {
        std::string all;
        for (const StatedProfile& p : stated_profiles) {
            all += (all.empty() ? "--" : ", --") + std::string(p.kind);
        }
        throw InputError("no profile is given", "add one of " + all + ", or name a scene's file");
    }
    return kind;
}

std::vector<std::string> edges_of(const std::string& text) {
    return text == "both" ? std::vector<std::string>{"right", "left"} : std::vector{text};
}

/// Returns the scene for the quantities on the command line.
scene::Scene stated_scene(const SceneOptions& o) {
    SceneEntries entries = entries_of(o);
    const auto add = [&](const char* key, const std::string& text, auto value) {
        if (!text.empty()) {
            entries.ask.push_back({key, std::move(value)});
        }
    };
    add("edges", o.edges, edges_of(o.edges));
    add("terms", o.terms, parts_of(o.terms));
    add("tolerance", o.tolerance, o.tolerance);
    add("digits", o.digits, o.digits);
    add("quantities", o.quantities, parts_of(o.quantities));
    scene::Scene scene = scene::make_scene(entries);
    scene.file = "command line";
    o.as_file = scene_text(entries);
    return scene;
}

scene::Scene given_scene(const SceneOptions& o) {
    return is_by_quantities(o)
               ? stated_scene(o)
               : scene::read_scene(file_or_shipped(o.scene, shipped_scenes), stated_entries(o).ask);
}

Rounding rounding_of(const std::string& name) {
    if (const auto mode = rounding_named(name)) {
        return *mode;
    }
    throw InputError("--round " + name + " is no way to round", "write nearest, down or up");
}

void ask_quantities(scene::Scene& scene, const std::string& list) {
    scene.ask.quantities.clear();
    for (const std::string& name : parts_of(list)) {
        const auto rows = scene::group_rows();
        const auto row = std::ranges::find(rows, name, &scene::GroupRow::name);
        if (row == rows.end()) {
            std::vector<std::string_view> names;
            std::ranges::transform(rows, std::back_inserter(names), &scene::GroupRow::name);
            throw InputError(fmt::format("--quantity {}: unknown quantity '{}'", list, name),
                             one_of(name, names));
        }
        scene.ask.quantities.insert(row->group);
    }
}

} // namespace

bool OutputOptions::is_short() const {
    return has_table && format.empty() && out.empty() && ::isatty(STDOUT_FILENO) == 1;
}

void add_table_options(CLI::App& sub, OutputOptions& o) {
    o.has_table = true;
    sub.add_option("--format", o.format, "default: csv; on a terminal a short answer")
        ->type_name("csv|json|md|tex");
    sub.add_option("--out", o.out, "write to this file, whole or not at all (-: standard output)");
    add_list_option(sub, "--columns", o.columns, nullptr,
                    "these columns only, such as u,p (default: all)");
    sub.add_flag("--no-notes", o.no_notes, "leave out the facts and notes around the rows");
}

void add_list_option(CLI::App& sub, const std::string& name, std::string& target,
                     std::string* scene, const std::string& help) {
    sub.add_option_function<std::vector<std::string>>(
        name,
        [&target, scene](std::vector<std::string> words) {
            if (scene != nullptr && scene->empty() && words.size() > 1 &&
                names_scene(words.back())) {
                *scene = words.back();
                words.pop_back();
            }
            target = fmt::format("{}", fmt::join(words, ","));
        },
        help);
}

void add_threads_option(CLI::App& sub, std::string& threads) {
    sub.add_option("--threads", threads, "threads (default: one a processor)");
}

void add_threads_option(CLI::App& sub, int& threads) {
    sub.add_option("--threads", threads, "threads (0: as many as the machine has)")
        ->check(CLI::Range(0, static_cast<int>(most_threads)));
}

void add_given_scene(CLI::App& sub, SceneOptions& o) {
    sub.add_option("scene", o.scene, "the scene (TOML); -: standard input");
    sub.add_option("--edge", o.edges, "default: the scene's")->type_name("right|left|both");
    add_list_option(sub, "--terms", o.terms, &o.scene,
                    "numbers of terms, such as 1,2,3 (default: the scene's)");
    add_list_option(sub, "--quantity", o.quantities, &o.scene,
                    "what is asked, such as pressure,shear, as far as the command gives it "
                    "(default: the scene's)");
    add_step_option(sub, o.step);
    add_stated_options(sub, o);
    sub.add_flag("--show-scene", o.show_scene,
                 "print the file of a scene that is given by its quantities (standard error)");
}

void add_scene_options(CLI::App& sub, SceneOptions& o) {
    add_given_scene(sub, o);
    sub.add_option("--digits", o.digits,
                   "significant digits (default: the scene's, else 50; 6 on a terminal)");
    add_table_options(sub, o);
    sub.add_option("--round", o.rounding, "how values are rounded")
        ->capture_default_str()
        ->type_name("nearest|down|up");
    sub.add_flag("--verbose", o.verbose,
                 "show on stderr what was computed: routes, bits, and whether it is proved");
    sub.add_flag("--binary64", o.binary64, "add the binary64 nearest to each value");
    sub.add_flag("--exact", o.exact,
                 "print the points of a range as exact fractions, not as decimals");
}

void add_tolerance_option(CLI::App& sub, SceneOptions& o, const std::string& help) {
    sub.add_option("--tolerance", o.tolerance, "1%, 0.01 or 1/100" + help);
}

void add_step_option(CLI::App& sub, std::string& step) {
    sub.add_option("--step", step,
                   "the state after this step of a load history (default: the last)");
}

void choose_step(scene::Scene& scene, const std::string& step) {
    if (step.empty()) {
        return;
    }
    if (scene.steps.empty()) {
        throw InputError("--step " + step + ": the scene has no steps",
                         "add [[step]] sections, or leave --step out");
    }
    set_step(scene, whole_number("--step", step, 1, scene.steps.size()));
}

scene::Scene asked_scene(const SceneOptions& o) {
    (void)format_of(o.format); // checked before any work
    const Rounding rounding = rounding_of(o.rounding);
    scene::Scene scene = given_scene(o);
    choose_step(scene, o.step);
    if (!o.digits.empty()) {
        scene.ask.digits.count = digits_of(o.digits, most_digits_of_a_scene);
    } else if (o.is_short()) {
        scene.ask.digits.count = digits_of_short_answer;
    }
    scene.ask.digits.exact = o.exact;
    scene.ask.digits.rounding = rounding;
    scene.ask.digits.binary64 = o.binary64;
    if (!o.edges.empty()) {
        scene.ask.edges.clear();
        for (const std::string& name : edges_of(o.edges)) {
            const auto edge = scene::edge_named(name);
            if (!edge) {
                throw InputError("--edge " + name + ": there is no such edge",
                                 "write right, left or both");
            }
            scene.ask.edges.push_back(*edge);
        }
    }
    if (!o.terms.empty()) {
        scene.ask.terms = numbers_of_terms(o.terms);
    }
    if (!o.tolerance.empty()) {
        scene.ask.tolerance = tolerance_of(o.tolerance);
    }
    if (!o.quantities.empty()) {
        ask_quantities(scene, o.quantities);
    }
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
    std::ranges::copy_if(other_groups, std::inserter(all, all.end()),
                         [&](scene::QuantityGroup group) { return scene.ask.wants(group); });
    for (const scene::QuantityGroup group : scene.ask.quantities) {
        if (!o.quantities.empty() && !all.contains(group)) {
            std::string given = group_name(own);
            for (const scene::QuantityGroup& other : other_groups) {
                given += (&other == &other_groups.back() ? " or " : ", ") + group_name(other);
            }
            throw InputError("--quantity " + o.quantities + ": this command does not give the " +
                                 group_name(group),
                             "write " + given);
        }
    }
    scene.ask.quantities = std::move(all);
}

} // namespace edgeproof::cli

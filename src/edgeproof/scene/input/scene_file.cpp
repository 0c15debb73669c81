// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/scene_file.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::scene {

namespace {

/// The rows are in the order of FileKind.
struct KindOfFile {
    std::array<std::string_view, 3> marks; ///< sections that no other kind has; the rest is empty
    std::string_view name;
    std::string_view wanted;
    std::string_view commands;
};

constexpr std::array file_kinds{
    KindOfFile{{"profile", "load", "ask"},
               "a scene",
               "a scene (TOML with [profile] and [load])",
               "edgeproof pressure, expand or extent"},
    KindOfFile{{"scenes"},
               "a recipe",
               "a recipe (TOML with [scenes.NAME])",
               "edgeproof table, points or check --exec"},
    KindOfFile{{"ledger", "claim", "family"},
               "a ledger",
               "a ledger (TOML with [ledger], [[family]] and [[claim]])",
               "edgeproof verify or check --ledger"},
};
static_assert(file_kinds.size() == static_cast<std::size_t>(FileKind::ledger) + 1);

/// The first section of a file that only this kind has; empty if there is none.
std::string_view mark_in(const io::TomlSection& top, const KindOfFile& kind) {
    const auto mark = std::ranges::find_if(
        kind.marks, [&](std::string_view m) { return !m.empty() && top.has(m); });
    return mark == kind.marks.end() ? std::string_view() : *mark;
}

constexpr int shown_digits = 8;

void read_sections(const io::TomlSection& top, Scene& scene, bool within_limits = true) {
    read_steps(top, scene);
    if (top.has("units")) {
        scene.units = read_units(top.section("units"));
    }
    const io::TomlSection load = top.section("load");
    const auto reading = [&](const io::TomlSection& section, const auto& read) {
        io::at_place(section.file(), section.line(), [&] { read(section, scene); });
    };
    reading(load, read_load);
    reading(top.section("profile"), [](const io::TomlSection& profile, Scene& s) {
        read_profile(profile, s.moment.has_value(), s);
    });
    const io::TomlSection profile = top.section("profile");
    if (within_limits) {
        check_exponent(profile);
    }
    if (is_axisymmetric(profile)) {
        reading(profile, [](const io::TomlSection& section, Scene& s) {
            require_axisymmetric(section, s);
            revolve(s);
        });
    } else if (load.has("delta")) {
        load.reject("delta", "the approach delta of a plane contact is undetermined",
                    "give a or P, or write geometry = \"axisymmetric\" in [profile]");
    }
    if (within_limits) {
        reading(load, check_reach);
    }
    if (!scene.steps.empty()) {
        read_shear_of_steps(top, scene);
        set_step(scene, scene.steps.size());
    } else if (top.has("shear")) {
        reading(top.section("shear"), read_shear);
    }
}

/// Returns f(); an error in keys that are in no file names none.
template <class F> auto without_line_0(const F& f) {
    try {
        return f();
    } catch (const InputError& error) {
        throw error.line() != 0 ? error : InputError(error.problem(), error.instead());
    }
}

std::string toml_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
    return out + "\"";
}

std::vector<std::string> texts_of(const io::TomlEntry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) {
        return {*text};
    }
    const auto* list = std::get_if<std::vector<std::string>>(&entry.value);
    return list != nullptr ? *list : std::vector<std::string>();
}

/// Refuses control characters, tab and newline included.
void check_characters(const std::string& key, const std::string& text) {
    if (std::any_of(text.begin(), text.end(),
                    [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; })) {
        throw InputError(key + " holds a control character", "write a number or a word");
    }
}

std::string toml_entry(const io::TomlEntry& entry) {
    if (const auto* yes = std::get_if<bool>(&entry.value)) {
        return *yes ? "true" : "false";
    }
    if (const auto* range = std::get_if<io::TomlRange>(&entry.value)) {
        return "{ from = " + toml_string(range->from) + ", to = " + toml_string(range->to) +
               (range->points > 0 ? ", points = " + std::to_string(range->points) : "") + " }";
    }
    std::string list;
    for (const std::string& text : texts_of(entry)) {
        list += (list.empty() ? "" : ", ") + toml_string(text);
    }
    return std::holds_alternative<std::string>(entry.value) ? list : "[" + list + "]";
}

} // namespace

std::optional<FileKind> file_kind(const io::TomlSection& top) {
    for (std::size_t i = 0; i < file_kinds.size(); ++i) {
        if (!mark_in(top, file_kinds[i]).empty()) {
            return static_cast<FileKind>(i);
        }
    }
    return std::nullopt;
}

void expect_file_kind(const io::TomlSection& top, FileKind expected) {
    const KindOfFile& right = file_kinds.at(static_cast<std::size_t>(expected));
    const auto found = file_kind(top);
    if (!found || !mark_in(top, right).empty()) {
        return;
    }
    const KindOfFile& other = file_kinds.at(static_cast<std::size_t>(*found));
    top.reject(mark_in(top, other),
               "this is " + std::string(other.name) + ", not " + std::string(right.name),
               "give " + std::string(right.wanted) + ", or give this file to " +
                   std::string(other.commands));
}

Scene read_contact(const io::TomlSection& top) {
    Scene scene;
    scene.file = top.file();
    read_sections(top, scene);
    return scene;
}

Scene contact_with_keys(const std::vector<io::TomlTable>& tables) {
    Scene scene;
    without_line_0([&] { read_sections(io::TomlSection::made(tables, ""), scene, false); });
    return scene;
}

Scene scene_of(const io::TomlSection& top) {
    expect_file_kind(top, FileKind::scene);
    top.allow({"title", "units", "profile", "load", "shear", "step", "ask"});
    Scene scene;
    scene.file = top.file();
    if (top.has("title")) {
        scene.title = top.text("title");
    }
    read_sections(top, scene);
    if (top.has("ask")) {
        const io::TomlSection ask = top.section("ask");
        const io::TomlSection profile = top.section("profile");
        io::at_place(ask.file(), ask.line(), [&] { read_ask(ask, profile, scene); });
    }
    default_quantities(scene.ask, scene.shear.has_value(), scene.slips());
    return scene;
}

Scene parse_scene(std::string_view text, const std::string& file,
                  const std::vector<io::TomlTable>& instead) {
    if (!instead.empty() && !text.empty()) { // keys of [ask] would hide another kind of file
        expect_file_kind(io::TomlSection::parse(text, file), FileKind::scene);
    }
    const auto read = [&] { return scene_of(io::TomlSection::parse(text, file, instead)); };
    return instead.empty() ? read() : without_line_0(read);
}

Scene read_scene(const std::filesystem::path& file, const std::vector<io::TomlTable>& instead) {
    return parse_scene(io::read_text(file, "scene (TOML)", io::most_toml_bytes),
                       io::input_name(file), instead);
}

void refuse_sliding(const Scene& scene, const Real& force) {
    const ShearSpec& shear = *scene.shear;
    const Real most = force * shear.friction->to<Real>();
    throw InputError("the contact slides: Q = " + shear.Q.text() +
                         ", but f P = " + most.str(shown_digits),
                     "give a smaller Q, or a greater friction, so that |Q| < f P")
        .at(scene.file, scene.friction_line);
}

void refuse_tension(const Scene& scene, Edge edge, bool reached, const Real& least,
                    const Real& most) {
    throw InputError("bulk_tension = " + scene.shear->bulk_tension.text() +
                         " moves the stick zone " + (reached ? "to the " : "beyond the ") +
                         edge_name(edge) +
                         (reached ? " edge to within all digits, so that nothing slips there"
                                  : " edge, which would slip in the direction opposite to Q"),
                     "give a bulk_tension between " + least.str(shown_digits) + " and " +
                         most.str(shown_digits) + ", the bounds for this Q")
        .at(scene.file, scene.tension_line);
}

std::string scene_text(const std::vector<io::TomlTable>& tables, const std::string& title) {
    std::string text = title.empty() ? "" : "title = " + toml_string(title) + "\n";
    for (const io::TomlTable& table : tables) {
        if (table.entries.empty()) {
            continue;
        }
        const bool listed = table.name.starts_with("[[");
        text += (text.empty() ? "" : "\n") + (listed ? table.name : "[" + table.name + "]") + "\n";
        for (const io::TomlEntry& entry : table.entries) {
            text += entry.key + " = " + toml_entry(entry) + "\n";
        }
    }
    return text;
}

Scene make_scene(const std::vector<io::TomlTable>& tables, const std::string& title) {
    check_characters("title", title);
    std::vector<io::TomlTable> given;
    for (const io::TomlTable& table : tables) {
        for (const io::TomlEntry& entry : table.entries) {
            for (const std::string& text : texts_of(entry)) {
                check_characters(entry.key, text);
            }
        }
        if (!table.entries.empty()) {
            given.push_back(table);
        }
    }
    Scene scene = without_line_0([&] { return scene_of(io::TomlSection::made(given, "")); });
    scene.title = title;
    return scene;
}

} // namespace edgeproof::scene

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/validation/hard_cases.hpp"

#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/toml_section.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/file_kind.hpp"

namespace edgeproof::validation {
namespace {

using Kind = AskedValue::Kind;

constexpr long most_asked_terms = 1000;

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
    return out + "\"";
}

std::string list_of(const std::vector<std::string>& items) {
    std::string out = "[";
    for (const std::string& item : items) {
        out += (out.size() > 1 ? ", " : "") + quoted(item);
    }
    return out + "]";
}

/// The section as a scene has it.
std::string scene_section(const io::TomlSection& section, const std::string& name) {
    std::string text = "[" + name + "]\n";
    for (const std::string& key : section.keys()) {
        text += key + " = ";
        if (key == "symmetric") {
            text += section.flag(key) ? "true" : "false";
        } else if (key == "slopes") {
            text += list_of(section.texts(key));
        } else if (section.is_list(key)) {
            std::vector<std::string> items;
            for (const auto& item : section.exacts(key)) {
                items.push_back(item.value.text());
            }
            text += list_of(items);
        } else {
            text += quoted(section.written(key));
        }
        text += "\n";
    }
    return text;
}

scene::Scene read_case_scene(const io::TomlSection& section) {
    std::string text = scene_section(section.section("profile"), "profile") +
                       scene_section(section.section("load"), "load");
    if (section.has("shear")) {
        text += scene_section(section.section("shear"), "shear");
    }
    try {
        return scene::parse_scene(text, section.file());
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()).at(section.file(), section.line());
    }
}

AskedValue read_asked(const io::TomlSection& section, const scene::Scene& scene) {
    AskedValue asked;
    const std::string quantity = section.text("quantity");
    const auto kind = asked_kind(quantity);
    if (!kind) {
        section.reject("quantity", "unknown quantity '" + quantity + "'",
                       "write pressure, coefficient, residual, shear, shear-coefficient, load, "
                       "left-edge, tilt-difference or extent");
    }
    asked.kind = *kind;
    if (section.has("edge")) {
        const std::string edge = section.text("edge");
        if (edge != "right" && edge != "left") {
            section.reject("edge", "there is no edge '" + edge + "'", "write right or left");
        }
        asked.edge = edge == "right" ? contact::Edge::right : contact::Edge::left;
    }
    if (asked.at_point()) {
        asked.u = section.exact("u");
    }
    if (asked.kind == Kind::extent) {
        asked.tolerance = scene::parse_tolerance(section.text("tolerance"));
    }
    if (asked.kind == Kind::coefficient || asked.kind == Kind::shear_coefficient) {
        asked.n = section.count("n", 0, most_asked_terms);
    } else if (asked.kind == Kind::residual || asked.kind == Kind::extent) {
        asked.n = section.count("n", 1, most_asked_terms);
    }
    if ((asked.kind == Kind::shear || asked.kind == Kind::shear_coefficient) && !scene.shear) {
        section.reject(section.line(), "a shear is asked for and there is none",
                       "add shear = { Q = \"...\" }");
    }
    if (!scene.profile) {
        section.reject("load", "the tilt is not given",
                       "give alpha: what is solved for by an estimate proves nothing");
    }
    return asked;
}

} // namespace

std::vector<HardCase> parse_hard_cases(std::string_view text, const std::string& file) {
    const io::TomlSection top = io::TomlSection::parse(text, file);
    expect_file_kind(top, scene::FileKind::hard_cases);
    top.allow({"cases"});
    std::vector<HardCase> cases;
    const io::TomlSection all = top.section("cases");
    for (const std::string& name : all.keys()) {
        const io::TomlSection section = all.section(name);
        section.allow({"class", "reason", "undecided", "quantity", "edge", "u", "n", "tolerance",
                       "profile", "load", "shear"});
        HardCase c;
        c.line = section.line();
        c.family = section.text("class");
        c.reason = section.text("reason");
        c.undecided = section.has("undecided") ? section.text("undecided") : "";
        c.name = name;
        c.scene = read_case_scene(section);
        c.asked = io::at_place(file, c.line, [&] { return read_asked(section, c.scene); });
        cases.push_back(std::move(c));
    }
    return cases;
}

} // namespace edgeproof::validation

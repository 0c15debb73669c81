// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that are not read from a file.
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::scene {
namespace {

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
    std::string list;
    for (const std::string& text : texts_of(entry)) {
        list += (list.empty() ? "" : ", ") + toml_string(text);
    }
    return std::holds_alternative<std::string>(entry.value) ? list : "[" + list + "]";
}

/// Returns the tables that are not empty, with their headers.
std::vector<io::TomlTable> tables_of(const SceneEntries& entries) {
    std::vector<io::TomlTable> tables{
        {"profile", 0, entries.profile}, {"load", 0, entries.load}, {"shear", 0, entries.shear}};
    for (const SceneEntries::Section& step : entries.steps) {
        tables.push_back({"[[step]]", 0, step});
    }
    tables.push_back({"ask", 0, entries.ask});
    std::erase_if(tables, [](const io::TomlTable& table) { return table.entries.empty(); });
    return tables;
}

} // namespace

std::string scene_text(const SceneEntries& entries) {
    std::string text;
    if (!entries.title.empty()) {
        text += "title = " + toml_string(entries.title) + "\n";
    }
    for (const io::TomlTable& table : tables_of(entries)) {
        const bool listed = table.name.starts_with("[[");
        text += (text.empty() ? "" : "\n") + (listed ? table.name : "[" + table.name + "]") + "\n";
        for (const io::TomlEntry& entry : table.entries) {
            text += entry.key + " = " + toml_entry(entry) + "\n";
        }
    }
    return text;
}

Scene make_scene(const SceneEntries& entries) {
    check_characters("title", entries.title);
    const std::vector<io::TomlTable> tables = tables_of(entries);
    for (const io::TomlTable& table : tables) {
        for (const io::TomlEntry& entry : table.entries) {
            for (const std::string& text : texts_of(entry)) {
                check_characters(entry.key, text);
            }
        }
    }
    try {
        Scene scene = scene_of(io::TomlSection::made(tables, ""));
        scene.title = entries.title;
        return scene;
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()); // without the line 0
    }
}

} // namespace edgeproof::scene

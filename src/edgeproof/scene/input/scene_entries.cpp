// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/scene_entries.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::scene {
namespace {

std::string toml_string(const std::string& key, const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            throw InputError(key + " holds a control character", "write a number or a word");
        }
        out += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
    return out + "\"";
}

std::string toml_entry(const SceneEntry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) {
        return toml_string(entry.key, *text);
    }
    if (const auto* yes = std::get_if<bool>(&entry.value)) {
        return *yes ? "true" : "false";
    }
    std::string list;
    for (const std::string& item : std::get<std::vector<std::string>>(entry.value)) {
        list += (list.empty() ? "" : ", ") + toml_string(entry.key, item);
    }
    return "[" + list + "]";
}

} // namespace

std::string scene_text(const SceneEntries& entries) {
    std::string text;
    if (!entries.title.empty()) {
        text += "title = " + toml_string("title", entries.title) + "\n";
    }
    const auto section = [&](const char* name, const std::vector<SceneEntry>& list) {
        if (list.empty()) {
            return;
        }
        text += std::string(text.empty() ? "" : "\n") + "[" + name + "]\n";
        for (const SceneEntry& entry : list) {
            text += entry.key + " = " + toml_entry(entry) + "\n";
        }
    };
    section("profile", entries.profile);
    section("load", entries.load);
    section("shear", entries.shear);
    section("ask", entries.ask);
    return text;
}

Scene make_scene(const SceneEntries& entries) {
    try {
        return parse_scene(scene_text(entries), "");
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.instead()); // the user did not write the lines
    }
}

} // namespace edgeproof::scene

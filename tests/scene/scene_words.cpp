// SPDX-License-Identifier: BSD-3-Clause
#include "tests/scene/scene_words.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/scene/input/scene_words.hpp"
#include "tests/support/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

namespace edgeproof::scenes {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

std::string section_of(const std::string& key) {
    const Key* const known = key_named(key);
    return known != nullptr ? std::string(known->section) : key == "points" ? "ask" : "profile";
}

std::string list_of(const std::string& text, const std::string& by, const auto& element) {
    std::string list;
    for (const std::string& part : test::parts(text, by)) {
        list += (list.empty() ? "" : ", ") + element(part);
    }
    return "[" + list + "]";
}

std::string toml_value(const std::string& key, const std::string& text) {
    const auto quoted = [](const std::string& x) { return '"' + x + '"'; };
    const auto plain = [](const std::string& x) { return x; };
    const bool number = key == "terms" || key == "digits" || key == "cycles" || key == "symmetric";
    if (text.starts_with('=')) {
        return text.substr(1);
    }
    if (key == "points") {
        return list_of(text, ";", [&](const auto& pair) { return list_of(pair, ",", quoted); });
    }
    const Key* const known = key_named(key);
    if ((known != nullptr && known->list) || text.find(';') != std::string::npos) {
        return number ? list_of(text, ";", plain) : list_of(text, ";", quoted);
    }
    return number ? text : quoted(text);
}

void set(Keys& keys, const std::string& key, const std::string& value) {
    const auto known = std::ranges::find(keys, key, &Keys::value_type::first);
    if (known == keys.end()) {
        keys.emplace_back(key, value);
    } else {
        known->second = value;
    }
}

std::string written(const std::string& head, const Keys& keys) {
    std::string text;
    for (const auto& [key, value] : keys) {
        text += value.empty() ? "" : key + " = " + toml_value(key, value) + "\n";
    }
    return text.empty() ? "" : head + "\n" + text;
}

} // namespace

std::vector<std::string> words_of(const std::string& text) {
    const std::vector<std::string_view> words = io::split_words(text);
    return {words.begin(), words.end()};
}

std::string toml_of(const std::string& words) {
    std::map<std::string, Keys> of;
    std::string steps;
    bool moduli = false;
    bool shear = false;
    for (const std::string& word : words_of(words)) {
        const std::size_t equals = word.find('=');
        if (word == "[shear]") {
            shear = true;
        } else if (word.starts_with('[')) {
            Keys step;
            for (const std::string& pair : test::parts(word.substr(1, word.size() - 2), ",")) {
                step.emplace_back(pair.substr(0, pair.find('=')), pair.substr(pair.find('=') + 1));
            }
            steps += written("[[step]]", step);
        } else if (equals == std::string::npos) {
            const std::string key = word == "axisymmetric" ? "geometry"
                                    : word == "symmetric"  ? word
                                                           : "kind";
            set(of["profile"], key, key == "symmetric" ? "true" : word);
        } else {
            std::string key = word.substr(0, equals);
            const std::size_t dot = key.find('.');
            key = dot == std::string::npos ? key : key.substr(dot + 1);
            key = key == "E" ? "contact_modulus" : key;
            moduli = moduli || key == "contact_modulus" || key == "E1" || key == "E2";
            set(of[dot == std::string::npos ? section_of(key) : word.substr(0, dot)], key,
                word.substr(equals + 1));
        }
    }
    if (!moduli) {
        set(of["load"], "contact_modulus", "1");
    }
    return written("[units]", of["units"]) + written("[profile]", of["profile"]) +
           written("[load]", of["load"]) + (shear ? "[shear]\n" : "") +
           written("[shear]", of["shear"]) + steps + written("[ask]", of["ask"]) +
           written("[parameters]", of["parameters"]) + written("[design]", of["design"]);
}

Scene made(const std::string& words) {
    return words.starts_with('@') ? read_scene(test::source_dir() / words.substr(1))
                                  : parse_scene(toml_of(words), "scene.toml");
}

std::vector<TableRow> rows_of(const std::string& table) {
    std::map<std::string, std::string> names;
    const auto named = [&](const std::string& words) {
        const std::size_t end = std::min(words.find(' '), words.size());
        const auto known = names.find(words.substr(0, end));
        return known == names.end() ? words : known->second + words.substr(end);
    };
    std::vector<TableRow> rows;
    bool slow = false;
    for (const auto& [at, line] : test::table_lines(table)) {
        const std::size_t naming = line.find(" := ");
        if (line == "slow") {
            slow = true;
        } else if (naming != std::string::npos) {
            names[line.substr(0, naming)] = named(line.substr(naming + 4));
        } else {
            std::vector<std::string> cells = test::parts(" " + line, " | ");
            for (std::string& cell : cells) {
                for (std::size_t i = 0; (i = cell.find('{', i)) != std::string::npos; ++i) {
                    cell = cell.substr(0, i + 1) + named(cell.substr(i + 1));
                }
            }
            const std::string words = cells.front().empty() ? "" : cells.front().substr(1);
            cells.erase(cells.begin());
            const bool continues = words.empty();
            rows.push_back(
                {at, continues ? rows.back().scene : named(words), cells, slow, continues});
        }
    }
    REQUIRE(!rows.empty());
    return rows;
}

} // namespace edgeproof::scenes

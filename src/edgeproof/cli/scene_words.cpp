// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_options.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace edgeproof::cli {
namespace {

/// The keys of each section that have one value, or a list (with a star).
constexpr std::pair<const char*, const char*> keys_of_sections[] = {
    {"profile", "kind geometry m C R R1 R2 t flat_width phi alpha knots* slopes* symmetric"},
    {"load", "a width P M delta contact_modulus E nu E1 nu1 E2 nu2"},
    {"shear", "Q q_ratio bulk_tension bulk_A friction path"},
    {"ask", "edges* u* x* terms* tolerance process_zone quantities* reference part* route digits"},
    {"units", "length force pressure"}};
constexpr std::string_view kinds[] = {
    "power-law",        "hertz",        "cylinder-on-flat",       "sphere", "wedge", "cone",
    "flat-and-rounded", "tilted-wedge", "tilted-flat-and-rounded"};

struct Key {
    std::string name;
    std::size_t section;
    bool list;
};
const std::vector<Key>& keys() {
    static const std::vector<Key> all = [] {
        std::vector<Key> made;
        for (std::size_t i = 0; i < std::size(keys_of_sections); ++i) {
            std::istringstream names(keys_of_sections[i].second);
            for (std::string name; names >> name;) {
                const bool list = name.back() == '*';
                made.push_back({list ? name.substr(0, name.size() - 1) : name, i, list});
            }
        }
        return made;
    }();
    return all;
}
const Key* key_named(std::string_view name) {
    const auto found = std::ranges::find(keys(), name, &Key::name);
    return found == keys().end() ? nullptr : &*found;
}

/// The length of the key of KEY=VALUE; npos for the name of a file.
std::size_t key_length(const std::string& word) {
    const std::size_t equals = word.find('=');
    std::error_code failed;
    const bool is_key =
        equals != std::string::npos && equals > 0 &&
        std::all_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals),
                    [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }) &&
        !std::filesystem::is_regular_file(word, failed);
    return is_key ? equals : std::string::npos;
}

io::TomlEntry entry_of(const Key& key, const std::string& value) {
    if (key.name == "edges" && value == "both") {
        return {key.name, std::vector<std::string>{"right", "left"}};
    }
    if (key.name == "symmetric") {
        return {key.name, value != "false"};
    }
    if (key.list && !value.empty()) {
        return {key.name, parts_of(value)};
    }
    const std::size_t dots = value.find("..");
    if (dots != std::string::npos && dots > 0 && dots + 2 < value.size()) {
        return {key.name, io::TomlRange{value.substr(0, dots), value.substr(dots + 2)}};
    }
    if (key.name == "tolerance") {
        refuse_whole_tolerance("tolerance =", value);
    }
    return {key.name, value};
}

/// True for a word that stands for a scene, and not for a number.
bool names_scene(const std::string& word) {
    std::error_code failed;
    return word == "-" || word.ends_with(".toml") ||
           (word.find('/') != std::string::npos &&
            std::filesystem::is_regular_file(word, failed)) ||
           file_or_shipped(word, shipped_scenes) != word;
}

bool is_option(const std::string& word) {
    return word.size() > 1 && word[0] == '-' &&
           std::isdigit(static_cast<unsigned char>(word[1])) == 0 && word[1] != '.';
}

} // namespace

bool takes_words(const CLI::App& sub) {
    const CLI::Option* const scene = sub.get_option_no_throw("scene");
    return scene != nullptr && scene->get_expected_max() > 1;
}

std::vector<std::string> keys_of_scene() {
    std::vector<std::string> all;
    for (const Key& key : keys()) {
        all.push_back(key.name + "=");
    }
    return all;
}

GivenScene given_scene(const std::vector<std::string>& words, std::string_view folder) {
    GivenScene given;
    std::vector<std::vector<io::TomlEntry>> entries(std::size(keys_of_sections));
    for (const std::string& word : words) {
        const std::size_t length = key_length(word);
        if (length == std::string::npos) {
            if (!given.file.empty()) {
                throw InputError("there are two scenes, " + given.file + " and " + word,
                                 "give one file, and key=value for what differs");
            }
            given.file = word;
            continue;
        }
        const std::string name = word.substr(0, length);
        const Key* const key = key_named(name);
        if (key == nullptr) {
            std::vector<std::string_view> names;
            std::ranges::transform(keys(), std::back_inserter(names), &Key::name);
            throw InputError("there is no key '" + name + "' of a scene", one_of(name, names));
        }
        io::TomlEntry entry = entry_of(*key, word.substr(length + 1));
        auto& of_section = entries[key->section];
        const auto same = std::ranges::find(of_section, name, &io::TomlEntry::key);
        if (same == of_section.end()) {
            of_section.insert(name == "kind" ? of_section.begin() : of_section.end(),
                              std::move(entry));
        } else if (key->list) {
            auto& list = std::get<std::vector<std::string>>(same->value);
            const auto& more = std::get<std::vector<std::string>>(entry.value);
            list.insert(list.end(), more.begin(), more.end());
        } else {
            throw InputError(name + " is given twice", "give one value");
        }
    }
    auto& ask = entries[3];
    for (const auto& [place, other] : {std::pair{"u", "x"}, std::pair{"x", "u"}}) {
        if (!given.file.empty() && std::ranges::count(ask, place, &io::TomlEntry::key) > 0 &&
            std::ranges::count(ask, other, &io::TomlEntry::key) == 0) {
            ask.push_back({other, std::string()}); // the points of the words replace all others
            break;
        }
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (!entries[i].empty() || (given.file.empty() && i < 2 && !words.empty())) {
            given.instead.push_back({keys_of_sections[i].first, 0, std::move(entries[i])});
        }
    }
    if (given.file.empty() && given.instead.empty()) {
        throw InputError("no scene is given", "name its file, - for standard input, or give its "
                                              "keys: kind=hertz R=100 P=120 ...");
    }
    given.file = file_or_shipped(given.file, folder);
    return given;
}

std::string value_of(const std::vector<std::string>& words, std::string_view key) {
    std::string value;
    for (const std::string& word : words) {
        const std::size_t length = key_length(word);
        if (length != std::string::npos && word.substr(0, length) == key) {
            value += (value.empty() ? "" : ",") + word.substr(length + 1);
        }
    }
    return value;
}

std::vector<std::string> with_words(const CLI::App& app,
                                    const std::vector<std::string>& arguments) {
    const auto subs = app.get_subcommands([&](const CLI::App* sub) {
        return arguments.size() > 1 && sub->get_name() == arguments[1];
    });
    const CLI::App* const sub = subs.empty() ? nullptr : subs.front();
    if (sub == nullptr || !takes_words(*sub)) {
        return arguments;
    }
    std::vector<std::string> words{arguments[0], arguments[1]};
    for (std::size_t i = 2; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        const std::size_t equals = std::min(word.find('='), word.size());
        std::string name = word.substr(0, equals);
        const CLI::Option* const option =
            is_option(word) ? sub->get_option_no_throw(name) : nullptr;
        const bool of_scene = word.starts_with("--") && option == nullptr;
        name = of_scene ? name.substr(2) : "";
        if (std::ranges::find(kinds, name) != std::end(kinds) && equals == word.size()) {
            words.push_back("kind=" + name);
            continue;
        }
        std::ranges::replace(name, '-', '_');
        const Key* const key = key_named(name == "edge"       ? "edges"
                                         : name == "quantity" ? "quantities"
                                                              : name);
        if (key == nullptr || name == "digits") {
            words.push_back(word);
            const bool value_follows = option != nullptr && equals == word.size() &&
                                       option->get_expected_min() > 0 && i + 1 < arguments.size();
            if (value_follows) {
                words.push_back(arguments[++i]);
            }
            continue;
        }
        std::string value = equals < word.size() ? word.substr(equals + 1) : "";
        if (equals == word.size()) {
            if (i + 1 == arguments.size()) {
                throw InputError(word + " has no value", fmt::format("write {}=VALUE", key->name));
            }
            value = arguments[++i];
            while (key->list && i + 1 < arguments.size() && !is_option(arguments[i + 1]) &&
                   !names_scene(arguments[i + 1]) &&
                   key_length(arguments[i + 1]) == std::string::npos) {
                value += "," + arguments[++i];
            }
        }
        words.push_back(key->name + "=" + value);
    }
    return words;
}

} // namespace edgeproof::cli

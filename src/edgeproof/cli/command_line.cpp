// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

namespace edgeproof::cli {
namespace {

/// A list of more names than these is not printed: the help has it.
constexpr std::size_t most_listed = 24;

std::string unknown_name(const std::string& what, std::string_view name,
                         const std::vector<std::string>& known, const std::string& help) {
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    const std::string problem = "unknown " + what + " '" + shortened(name, 60) + "'; ";
    if (known.size() <= most_listed) {
        return problem + one_of(name, candidates);
    }
    const std::string near(near_name(name, candidates));
    return problem + (near.empty() ? "" : "did you mean " + near + "? ") + "'" + help +
           "' lists all";
}

std::vector<std::string> options_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

/// True if the word after --NAME is its value.
bool value_follows(const CLI::Option* option, std::string_view word) {
    return option->get_expected_min() > 0 && word.find('=') == std::string_view::npos;
}

constexpr std::string_view kinds[] = {
    "power-law",        "hertz",        "cylinder-on-flat",       "sphere", "wedge", "cone",
    "flat-and-rounded", "tilted-wedge", "tilted-flat-and-rounded"};

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

std::string unknown_on_command_line(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* current = &app;
    std::string help = "edgeproof";
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word == "--") {
            break;
        }
        if (word.size() > 1 && word.front() == '-') {
            const std::string name(word.substr(0, word.find('=')));
            const CLI::Option* option = current->get_option_no_throw(name);
            if (option == nullptr) {
                return unknown_name("option", name, options_of(*current), help + " --help");
            }
            i += value_follows(option, word) ? 1 : 0;
            continue;
        }
        std::vector<std::string> names;
        const CLI::App* chosen = nullptr;
        for (const CLI::App* sub : current->get_subcommands([](const CLI::App*) { return true; })) {
            names.push_back(sub->get_name());
            chosen = sub->get_name() == word ? sub : chosen;
        }
        if (chosen != nullptr) {
            current = chosen;
            help += " " + chosen->get_name();
        } else if (!names.empty()) {
            return unknown_name("subcommand", word, names, help + " --help");
        }
    }
    return {};
}

bool takes_words(const CLI::App& sub) {
    const CLI::Option* const scene = sub.get_option_no_throw("scene");
    return scene != nullptr && scene->get_expected_max() > 1;
}

GivenScene given_scene(const std::vector<std::string>& words, std::string_view folder) {
    GivenScene given = scene::given_scene(words);
    given.file = file_or_shipped(given.file, folder);
    return given;
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
        const scene::Key* const key = scene::key_named(name == "edge"       ? "edges"
                                                       : name == "quantity" ? "quantities"
                                                                            : name);
        if (key == nullptr || name == "digits") {
            words.push_back(word);
            if (option != nullptr && value_follows(option, word) && i + 1 < arguments.size()) {
                words.push_back(arguments[++i]);
            }
            continue;
        }
        std::string value = equals < word.size() ? word.substr(equals + 1) : "";
        if (equals == word.size()) {
            require(i + 1 != arguments.size(), word + " has no value",
                    fmt::format("write {}=VALUE", key->name));
            value = arguments[++i];
            while (key->list && i + 1 < arguments.size() && !is_option(arguments[i + 1]) &&
                   !names_scene(arguments[i + 1]) &&
                   scene::key_length(arguments[i + 1]) == std::string::npos) {
                value += "," + arguments[++i];
            }
        }
        words.push_back(key->name + "=" + value);
    }
    return words;
}

} // namespace edgeproof::cli

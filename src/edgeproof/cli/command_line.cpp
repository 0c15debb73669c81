// SPDX-License-Identifier: BSD-3-Clause
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

InputError unknown_name(const std::string& what, std::string_view name,
                        const std::vector<std::string>& known, const std::string& help) {
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    const std::string near(near_name(name, candidates));
    return {"unknown " + what + " '" + shortened(name, 60) + "'",
            known.size() <= most_listed
                ? one_of(name, candidates)
                : (near.empty() ? "" : "did you mean " + near + "? ") + "'" + help + "' lists all"};
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

GivenScene given_scene(const std::vector<std::string>& words, std::string_view folder) {
    GivenScene given = scene::given_scene(words);
    given.file = file_or_shipped(given.file, folder);
    return given;
}

std::vector<std::string> with_words(const CLI::App& app,
                                    const std::vector<std::string>& arguments) {
    std::vector<std::string> names;
    const CLI::App* current = &app;
    const std::string first = arguments.size() > 1 ? arguments[1] : "";
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(sub->get_name());
        current = sub->get_name() == first ? sub : current;
    }
    bool checked = std::ranges::none_of(arguments, [](const std::string& word) {
        return word == "-h" || word == "--help" || word == "--version";
    });
    const bool chosen = current != &app;
    if (checked && !chosen && !first.empty() && !is_option(first)) {
        throw unknown_name("subcommand", first, names, "edgeproof --help");
    }
    std::vector<std::string> words(arguments.begin(), arguments.begin() + (chosen ? 2 : 1));
    for (std::size_t i = words.size(); i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        const std::size_t equals = std::min(word.find('='), word.size());
        std::string name = word.substr(0, equals);
        const CLI::Option* const option =
            is_option(word) ? current->get_option_no_throw(name) : nullptr;
        const bool of_scene = word.starts_with("--") && option == nullptr && takes_words(*current);
        checked = checked && word != "--";
        name = of_scene ? name.substr(2) : "";
        if (std::ranges::count(scene::profile_kinds(), name) > 0 && equals == word.size()) {
            words.push_back("kind=" + name);
            continue;
        }
        std::ranges::replace(name, '-', '_');
        const scene::Key* const key = scene::key_named(name == "edge"       ? "edges"
                                                       : name == "quantity" ? "quantities"
                                                                            : name);
        if (key == nullptr || name == "digits") {
            if (checked && option == nullptr && is_option(word)) {
                throw unknown_name("option", word.substr(0, equals), options_of(*current),
                                   "edgeproof" + (chosen ? " " + first : "") + " --help");
            }
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
        words.push_back(std::string(key->name) + "=" + value);
    }
    return words;
}

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/report/report.hpp"

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
            const bool value_follows =
                option->get_expected_min() > 0 && option->get_type_size() > 0 && name == word;
            i += value_follows ? 1 : 0;
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

} // namespace edgeproof::cli

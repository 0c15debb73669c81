// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::cli {

/// Writes the documentation of the command line into a folder: man1/edgeproof.1, a page for each
/// subcommand, man1/edgeproof-NAME.1, and completions for three shells: edgeproof.bash, _edgeproof
/// (zsh) and edgeproof.fish.
void write_manual(const CLI::App& app, const std::string& version,
                  const std::filesystem::path& folder);

/// Returns the page of one subcommand, or of the program (`of` is `app`), in roff's man macros.
[[nodiscard]] std::string man_page(const CLI::App& app, const CLI::App& of,
                                   const std::string& version);

[[nodiscard]] std::string bash_completion(const CLI::App& app);
[[nodiscard]] std::string zsh_completion(const CLI::App& app);
[[nodiscard]] std::string fish_completion(const CLI::App& app);

/// Access to the names, commands and options of a CLI11 command line.
[[nodiscard]] inline std::vector<const CLI::App*> subcommands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

/// Returns the names with their hyphens: "-h", "--help".
[[nodiscard]] inline std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    return names;
}

[[nodiscard]] inline bool takes_value(const CLI::Option& option) {
    return option.get_type_size() > 0 && option.get_expected_max() > 0;
}

/// Returns the options of a command, without its arguments and hidden options.
[[nodiscard]] inline std::vector<const CLI::Option*> shown_options(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) {
        return !option->get_positional() && !option->get_group().empty();
    });
}

} // namespace edgeproof::cli

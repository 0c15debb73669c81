// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

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

} // namespace edgeproof::cli

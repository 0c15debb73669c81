// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/scene/scene.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

/// Options that several subcommands have, and their values. Functions that read a value throw
/// InputError, which names the option.
namespace edgeproof::cli {

struct SceneOptions {
    std::string scene;
    std::string digits; ///< empty: the scene's
    std::string format = "csv";
    std::string out;
    std::string rounding = "nearest";
    bool binary64 = false;
    // If empty: the scene's value, else the command's own default.
    std::string edges;      ///< right, left or both
    std::string terms;      ///< "1,2,3"
    std::string quantities; ///< "pressure,shear"
    std::string tolerance;
    std::string step; ///< of a load history; empty: the last one
    // A scene given by its quantities, in place of `scene`: --hertz --R 100 --P 120 ...
    std::map<std::string, bool> profiles;      ///< for each kind
    std::map<std::string, std::string> stated; ///< for each key of a scene's file
    mutable std::string as_file;               ///< the content of an equivalent file, to be shown
};

/// Adds the scene itself, --digits, --format, --out, --round, --binary64, and the options for
/// [ask]: --edge, --terms, --quantity.
void add_scene_options(CLI::App& sub, SceneOptions& options);
/// Adds only the scene itself and the options for [ask].
void add_given_scene(CLI::App& sub, SceneOptions& options);
/// Adds --tolerance; `help` states its purpose.
void add_tolerance_option(CLI::App& sub, SceneOptions& options, const std::string& help);
/// Adds --format, which shows its default, and --out.
void add_table_options(CLI::App& sub, std::string& format, std::string& out);
/// Adds --threads for threads_of().
void add_threads_option(CLI::App& sub, std::string& threads);
/// Adds --threads of a command that judges the claims of a ledger.
void add_threads_option(CLI::App& sub, int& threads);

/// Returns the scene, with the values of the options in place of its own. Throws InputError for
/// options that make no sense.
[[nodiscard]] scene::Scene asked_scene(const SceneOptions& options);
/// Sets the edges: those of --edge, else those of the scene, else both.
void ask_at_edges(scene::Scene& scene, const SceneOptions& options);
/// Sets the numbers of terms: those of --terms, else the scene's, else 1, 2, 3.
void ask_terms(scene::Scene& scene);
/// Restricts the quantities to the command's own, and those of `other_groups` that --quantity or
/// the scene names. Throws InputError if --quantity names another.
void ask_for(scene::Scene& scene, const SceneOptions& options, scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& other_groups);

[[nodiscard]] formula::Exact tolerance_of(const std::string& text);
/// Returns the parts of a list such as "1e-3,a/2".
[[nodiscard]] std::vector<std::string> parts_of(const std::string& text);
/// Reads the whole number of an option, in least ... most.
[[nodiscard]] std::size_t whole_number(const std::string& option, const std::string& text,
                                       std::size_t least, std::size_t most);
/// Reads a list of such numbers: "1", "1,2,3".
[[nodiscard]] std::vector<std::size_t> whole_numbers(const std::string& option,
                                                     const std::string& text, std::size_t least,
                                                     std::size_t most);
/// Reads the numbers of --terms.
[[nodiscard]] std::vector<std::size_t> numbers_of_terms(const std::string& text);
/// Reads the number of --digits, in 2 ... most.
[[nodiscard]] unsigned digits_of(const std::string& text, std::size_t most);
/// Reads the number of --threads; 0, the default number, if it is not given.
[[nodiscard]] unsigned threads_of(const std::string& text);
/// Reads the argument of --format.
[[nodiscard]] report::TableFormat format_of(const std::string& name);
/// Like check_output (io/output_file.hpp), for a file that is read again: neither "-" nor a device.
void check_state(const std::string& file);

} // namespace edgeproof::cli

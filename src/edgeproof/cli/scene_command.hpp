// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/stated_scene.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/scene/scene.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// Common parts of the subcommands that take a scene.
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
    StatedScene stated;          ///< in place of `scene`
    mutable std::string as_file; ///< the content of an equivalent file, to be shown
};

/// Adds the scene itself, --digits, --format, --out, --round, --binary64, and the options for
/// [ask]: --edge, --terms, --quantity.
void add_scene_options(CLI::App& sub, SceneOptions& options);
/// Adds only the scene itself and the options for [ask].
void add_given_scene(CLI::App& sub, SceneOptions& options);
/// Adds --tolerance; `help` states its purpose.
void add_tolerance_option(CLI::App& sub, SceneOptions& options, const std::string& help);

/// Like check_output (io/output_file.hpp), for a file that is read again: neither "-" nor a device.
void check_state(const std::string& file);

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
/// Throws InputError, which names the option.
[[nodiscard]] formula::Exact tolerance_of(const std::string& text);
/// Reads the whole number of an option, in least ... most.
[[nodiscard]] std::size_t whole_number(const std::string& option, const std::string& text,
                                       std::size_t least, std::size_t most);
/// Reads a list of such numbers: "1", "1,2,3".
[[nodiscard]] std::vector<std::size_t> whole_numbers(const std::string& option,
                                                     const std::string& text, std::size_t least,
                                                     std::size_t most);
/// Reads the number of --threads; 0, the default number, if it is not given.
[[nodiscard]] unsigned threads_of(const std::string& text);
/// Reads numbers of terms: "1", "1,2,3".
[[nodiscard]] std::vector<std::size_t> numbers_of_terms(const std::string& option,
                                                        const std::string& text);

/// Runs the scene, with progress on a terminal; SIGINT stops it.
[[nodiscard]] scene::SceneResult done(const scene::Scene& scene);

/// Draws the scene, with tolerance 1% and 1, 2, 3 terms unless the scene has its own.
[[nodiscard]] report::ScenePicture picture_of(scene::Scene scene);
/// Returns the title, else the file.
[[nodiscard]] std::string title_of(const scene::Scene& scene);

/// Returns the scene, the digits, a and b, and P and M if they were asked for.
[[nodiscard]] std::vector<report::Fact> facts_of(const scene::Scene& scene,
                                                 const scene::SceneResult& result);

/// Returns an empty table for such a result, with its title and facts.
[[nodiscard]] report::Table values_table(const scene::Scene& scene,
                                         const scene::SceneResult& result);
/// Adds, for a scene with friction: Q/(f P), the stick zone, and the allowed bulk tensions.
void add_slip_facts(std::vector<report::Fact>& facts, const scene::Scene& scene,
                    const scene::SceneResult& result);

/// Returns a sentence about the reliability of bounds and digits.
[[nodiscard]] std::string bound_note(const scene::Plan& plan);

/// The columns and cells of a value: text and bound (and its binary64).
class ValueColumns {
public:
    explicit ValueColumns(const scene::Scene& scene) : digits_(scene.ask.digits) {}
    /// Adds NAME, NAME_bound, the route column (if `route` is given), then NAME_binary64 if it is
    /// asked for.
    void add(std::vector<report::Column>& columns, const std::string& name,
             const std::string& route = {}) const;
    void add(std::vector<std::string>& row, const scene::BoundedValue& value, bool route) const;
    /// Adds empty cells for a missing value.
    void add_none(std::vector<std::string>& row, bool route) const;

private:
    scene::Digits digits_;
};

/// Reads the argument of --format. Throws InputError for another name: checked before any work.
[[nodiscard]] report::TableFormat format_of(const std::string& name);
/// Shows on stderr the file for a scene that was given by quantities.
void show_as_file(const SceneOptions& options);
/// Writes to --out, whole or not at all, or to stdout; wraps lines on a terminal.
void emit(const report::Table& table, const SceneOptions& options);

} // namespace edgeproof::cli

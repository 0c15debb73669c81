// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/stated_scene.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"
#include "edgeproof/report/tables/table.hpp"
#include "edgeproof/scene/scene.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// What the subcommands that take a scene have in common.
namespace edgeproof::cli {

struct SceneOptions {
    std::string scene;
    std::string digits; ///< empty: as the scene says
    std::string format = "csv";
    std::string out;
    std::string rounding = "nearest";
    bool binary64 = false;
    // Empty: as the scene says, else the command's own choice.
    std::string edges;      ///< right, left or both
    std::string terms;      ///< "1,2,3"
    std::string quantities; ///< "pressure,shear"
    std::string tolerance;
    StatedScene stated;          ///< in place of `scene`
    mutable std::string as_file; ///< what a file of it would hold, to be shown
};

/// The scene itself, --digits, --format, --out, --round, --binary64, and what is asked: --edge,
/// --terms, --quantity.
void add_scene_options(CLI::App& sub, SceneOptions& options);
/// Of these the scene itself and what is asked.
void add_given_scene(CLI::App& sub, SceneOptions& options);
/// --tolerance, of which `help` says what for.
void add_tolerance_option(CLI::App& sub, SceneOptions& options, const std::string& help);

/// As check_output (io/output_file.hpp), of a file that is read again: no "-", no device.
void check_state(const std::string& file);

/// The scene with what the options say in its stead. Throws InputError for options that make no
/// sense.
[[nodiscard]] scene::Scene asked_scene(const SceneOptions& options);
/// Edges: those of --edge, else those that the scene names, else both.
void ask_at_edges(scene::Scene& scene, const SceneOptions& options);
/// Numbers of terms: those of --terms, else the scene's, else 1, 2, 3.
void ask_terms(scene::Scene& scene);
/// Nothing but the command's own quantity, and those of `beside` that --quantity or the scene
/// names. Throws InputError where --quantity names another.
void ask_for(scene::Scene& scene, const SceneOptions& options, scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& beside);
/// Throws InputError that names the option.
[[nodiscard]] formula::Exact tolerance_of(const std::string& text);
/// A whole number of an option, in least ... most.
[[nodiscard]] std::size_t whole_number(const std::string& option, const std::string& text,
                                       std::size_t least, std::size_t most);
/// A list of such numbers: "1", "1,2,3".
[[nodiscard]] std::vector<std::size_t> whole_numbers(const std::string& option,
                                                     const std::string& text, std::size_t least,
                                                     std::size_t most);
/// Of --threads; 0, the usual ones, where it is not given.
[[nodiscard]] unsigned threads_of(const std::string& text);
/// "1", "1,2,3": numbers of terms.
[[nodiscard]] std::vector<std::size_t> numbers_of_terms(const std::string& option,
                                                        const std::string& text);

/// The scene done, with progress on a terminal, stopped by SIGINT.
[[nodiscard]] scene::SceneResult done(const scene::Scene& scene);

/// The scene in pictures, to 1% and of 1, 2, 3 terms unless it says otherwise.
[[nodiscard]] report::ScenePicture picture_of(scene::Scene scene);
/// The title, else the file.
[[nodiscard]] std::string title_of(const scene::Scene& scene);

/// Scene, digits, a and b, and P and M where they were asked for.
[[nodiscard]] std::vector<report::Fact> facts_of(const scene::Scene& scene,
                                                 const scene::SceneResult& result);

/// A table of such a result, with its title and facts.
[[nodiscard]] report::Table values_table(const scene::Scene& scene,
                                         const scene::SceneResult& result);
/// Q/(f P), the stick zone, and the bulk tensions that are allowed, of a scene with friction.
void add_slip_facts(std::vector<report::Fact>& facts, const scene::Scene& scene,
                    const scene::SceneResult& result);

/// How far bounds and digits are to be trusted, in a sentence.
[[nodiscard]] std::string bound_note(const scene::Plan& plan);

/// Columns and cells of a value: text and bound (and its binary64).
class ValueColumns {
public:
    explicit ValueColumns(const scene::Scene& scene) : digits_(scene.ask.digits) {}
    /// NAME, NAME_bound and (with `route`) `route`'s column, then NAME_binary64 where it is asked
    /// for.
    void add(std::vector<report::Column>& columns, const std::string& name,
             const std::string& route = {}) const;
    void add(std::vector<std::string>& row, const scene::BoundedValue& value, bool route) const;
    /// The cells of a value that is not there.
    void add_none(std::vector<std::string>& row, bool route) const;

private:
    scene::Digits digits_;
};

/// The argument of --format. Throws InputError for another name: checked before any work.
[[nodiscard]] report::TableFormat format_of(const std::string& name);
/// Of a scene that was given by quantities: what its file would hold, on stderr.
void show_as_file(const SceneOptions& options);
/// To --out, whole or not at all, or to stdout; wrapped where that is a terminal.
void emit(const report::Table& table, const SceneOptions& options);

} // namespace edgeproof::cli

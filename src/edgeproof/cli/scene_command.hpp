// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
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
    std::string edges; ///< right, left or both; empty: the command's own choice
};

/// --digits, --format, --out, --round, --binary64 and the scene itself.
void add_scene_options(CLI::App& sub, SceneOptions& options);
/// --edge right|left|both.
void add_edge_option(CLI::App& sub, SceneOptions& options);

/// As check_output (io/output_file.hpp), of a file that is read again: no "-", no device.
void check_state(const std::string& file);

/// The scene with what the options say in its stead. Throws InputError for options that make no
/// sense.
[[nodiscard]] scene::Scene asked_scene(const SceneOptions& options);
/// Both edges, or those of --edge.
[[nodiscard]] std::vector<contact::Edge> asked_edges(const SceneOptions& options);
/// A whole number of an option, in least ... most.
[[nodiscard]] std::size_t whole_number(const std::string& option, const std::string& text,
                                       std::size_t least, std::size_t most);
/// Of --threads; 0, the usual ones, where it is not given.
[[nodiscard]] unsigned threads_of(const std::string& text);
/// "1", "1,2,3": numbers of terms.
[[nodiscard]] std::vector<std::size_t> numbers_of_terms(const std::string& option,
                                                        const std::string& text);

/// The scene done, with progress on a terminal, stopped by SIGINT.
[[nodiscard]] scene::SceneResult done(const scene::Scene& scene);

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

/// To --out, whole or not at all, or to stdout.
void emit(const report::Table& table, const SceneOptions& options);

} // namespace edgeproof::cli

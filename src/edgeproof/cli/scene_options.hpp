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

/// The form and the place of a table.
struct OutputOptions {
    std::string format; ///< empty: a short answer on a terminal, else CSV
    std::string out;
    bool no_notes = false;
    std::string columns;         ///< names; empty: all
    bool has_table = false;      ///< the command has these options
    bool show_scene = false;     ///< print as_file on standard error
    mutable std::string as_file; ///< the file equivalent to a scene given by its quantities

    /// True if the table is printed on a terminal, in no format asked for.
    [[nodiscard]] bool is_short() const;
};

struct SceneOptions : OutputOptions {
    std::string scene;
    std::string digits; ///< empty: the scene's
    std::string rounding = "nearest";
    bool binary64 = false;
    bool exact = false;
    bool verbose = false;
    std::string figure; ///< for the commands that draw
    // If empty: the scene's value, else the command's own default.
    std::string edges;      ///< right, left or both
    std::string terms;      ///< "1,2,3"
    std::string quantities; ///< "pressure,shear"
    std::string tolerance;
    std::string step; ///< of a load history; empty: the last one
    // A scene given by its quantities, in place of `scene`: --hertz --R 100 --P 120 ...
    std::map<std::string, bool> profiles;      ///< for each kind
    std::map<std::string, std::string> stated; ///< for each key of a scene's file
    std::string q_ratio;                       ///< Q/(f P), in place of Q
    std::string E;                             ///< of both bodies
    mutable bool by_quantities = false;        ///< the scene is given by these
};

/// The digits of a short answer on a terminal, unless --digits is given.
inline constexpr unsigned digits_of_short_answer = 6;

inline constexpr std::size_t most_threads = 1024;

/// Adds the scene itself, --digits, those of a table, --round, --binary64, --exact, and the options
/// for [ask]: --edge, --terms, --quantity.
void add_scene_options(CLI::App& sub, SceneOptions& options);
/// Adds only the scene itself and the options for [ask].
void add_given_scene(CLI::App& sub, SceneOptions& options);
/// Adds --tolerance; `help` states its purpose.
void add_tolerance_option(CLI::App& sub, SceneOptions& options, const std::string& help);
/// Adds --format, --out, --no-notes.
void add_table_options(CLI::App& sub, OutputOptions& options);
/// Adds an option that takes a list, as "1,2,3" or as separate words, and sets `target` to its
/// parts joined by commas. The last word is the scene if that is not given otherwise.
void add_list_option(CLI::App& sub, const std::string& name, std::string& target,
                     std::string* scene, const std::string& help);
/// Refuses the options that are given although they have no effect: `why` states the reason.
void refuse_options(const std::vector<std::pair<std::string, std::string>>& texts_by_name,
                    const std::string& why);
/// Adds --step for choose_step().
void add_step_option(CLI::App& sub, std::string& step);
/// Sets the state of a scene to that after the step that --step names, if it is given.
void choose_step(scene::Scene& scene, const std::string& step);
/// Adds --threads for threads_of().
void add_threads_option(CLI::App& sub, std::string& threads);
/// Adds --threads of a command that judges the claims of a ledger.
void add_threads_option(CLI::App& sub, int& threads);

/// True if the scene is given by its quantities, and not by a file.
[[nodiscard]] bool is_by_quantities(const SceneOptions& options);
/// Returns the profile, the load and the shear that the options give.
[[nodiscard]] scene::SceneEntries entries_of(const SceneOptions& options);

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
/// Returns the tolerance as a percentage: "1%"; its own text if it is not rational.
[[nodiscard]] std::string percent_text(const formula::Exact& tolerance);
/// Refuses a number of 1 or more without a percent sign, which is a slip for a percentage.
void refuse_whole_tolerance(const std::string& option, const std::string& text);
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
/// Reads the argument of --format; empty: CSV.
[[nodiscard]] report::TableFormat format_of(const std::string& name);
/// Reads text or json of --format; returns true for json. Empty: text.
[[nodiscard]] bool text_or_json(const std::string& format);

} // namespace edgeproof::cli

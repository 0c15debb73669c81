// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edgeproof/report/report.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Options that several subcommands have, and their values. Functions that read a value throw
/// InputError, which names the option.
namespace edgeproof::cli {

using scene::GivenScene;
using scene::parts_of;
using scene::refuse_whole_tolerance;

/// Reads the words of a scene. `folder`: the shipped files that a bare name may mean.
[[nodiscard]] GivenScene given_scene(const std::vector<std::string>& words,
                                     std::string_view folder);

/// Returns the command line with words in place of options for keys of a scene, if its command
/// takes a scene: `--R 100` becomes R=100, `--u 1e-3 0.1` u=1e-3,0.1, and `--hertz` kind=hertz.
[[nodiscard]] std::vector<std::string> with_words(const CLI::App& app,
                                                  const std::vector<std::string>& arguments);

/// True if a command takes the words of a scene.
[[nodiscard]] bool takes_words(const CLI::App& sub);

/// The form and the place of a table.
struct OutputOptions {
    std::string format; ///< empty: text, a short answer, on a terminal, else CSV
    std::string out;
    bool no_notes = false;
    std::string columns;         ///< names; empty: all
    bool has_table = false;      ///< the command has these options
    bool show_scene = false;     ///< print as_file on standard error
    mutable std::string as_file; ///< the file equivalent to a scene given by words

    /// True for a short answer: asked for, or on a terminal without a format.
    [[nodiscard]] bool is_short() const;
    [[nodiscard]] report::TableFormat table_format() const;
};

struct SceneOptions : OutputOptions {
    std::vector<std::string> words; ///< the scene: its file, key=value, or both
    std::string digits;             ///< empty: the scene's
    std::string rounding = "nearest";
    bool binary64 = false;
    bool exact = false;
    bool verbose = false;
    std::string figure; ///< for the commands that draw
    std::string step;   ///< of a load history; empty: the last one

    /// The value of a key among the words; empty: the file's or the command's own.
    [[nodiscard]] std::string word(std::string_view key) const {
        return scene::value_of(words, key);
    }
};

/// The digits of a short answer on a terminal, unless --digits is given.
inline constexpr unsigned digits_of_short_answer = 6;

inline constexpr std::size_t most_threads = 1024;

/// Adds the scene itself, --digits, those of a table, --round, --binary64, --exact.
void add_scene_options(CLI::App& sub, SceneOptions& options);
/// Adds only the scene itself.
void add_given_scene(CLI::App& sub, SceneOptions& options);
/// Adds --format, --out, --no-notes.
void add_table_options(CLI::App& sub, OutputOptions& options);
/// Refuses the keys that are given as words although they have no effect: `why` gives the reason.
void refuse_words(const SceneOptions& options, const std::vector<std::string_view>& keys,
                  const std::string& why);
/// Sets the state of a scene to that after the step that --step names, if it is given.
void choose_step(scene::Scene& scene, const std::string& step);

/// Returns the scene, with the values of the words and options in place of its own. Throws
/// InputError for those that make no sense.
[[nodiscard]] scene::Scene asked_scene(const SceneOptions& options);
/// Sets the edges: those of the scene, else both.
void ask_at_edges(scene::Scene& scene);
/// Sets the numbers of terms: the scene's, else 1, 2, 3.
void ask_terms(scene::Scene& scene);
/// Restricts the quantities to the command's own, and those of `other_groups` that the scene names.
/// Throws InputError if a word names another.
void ask_for(scene::Scene& scene, const SceneOptions& options, scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& other_groups);

/// Reads the whole number of an option, in least ... most.
[[nodiscard]] std::size_t whole_number(const std::string& option, const std::string& text,
                                       std::size_t least, std::size_t most);
/// Reads the number of --digits, in 2 ... most.
[[nodiscard]] unsigned digits_of(const std::string& text, std::size_t most);
/// Reads the number of --threads; 0, as many as the machine has, if it is not given.
[[nodiscard]] unsigned threads_of(const std::string& text);
/// Reads the argument of --format; empty: CSV.
[[nodiscard]] report::TableFormat format_of(const std::string& name);
/// Reads text or json of --format; returns true for json. Empty: text.
[[nodiscard]] bool text_or_json(const std::string& format);

} // namespace edgeproof::cli

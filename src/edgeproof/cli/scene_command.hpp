// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/report/report.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What the commands share: options that several have, and the rows of a scene. Functions that read
/// a value throw InputError, which names the option.
namespace edgeproof::cli {

using scene::GivenScene;
using scene::parts_of;
using scene::refuse_whole_tolerance;

/// Reads the words of a scene. `folder`: the shipped files that a bare name may mean.
[[nodiscard]] GivenScene given_scene(const std::vector<std::string>& words,
                                     std::string_view folder);
[[nodiscard]] scene::Scene read_scene(const GivenScene& given);

/// Returns the command line with words in place of options for keys of a scene, if its command
/// takes a scene: `--R 100` becomes R=100, `--u 1e-3 0.1` u=1e-3,0.1, and `--hertz` kind=hertz.
/// Throws InputError for an unknown subcommand or option ("did you mean --digits?"), unless help is
/// asked for. Where the list of known names is long, the command that prints it is named instead.
[[nodiscard]] std::vector<std::string> with_words(const CLI::App& app,
                                                  const std::vector<std::string>& arguments);

/// True if a command takes the words of a scene.
[[nodiscard]] bool takes_words(const CLI::App& sub);

/// True for a short answer of a command for scenes: asked for, or on a terminal without a format.
[[nodiscard]] bool is_short(const Options& options);
[[nodiscard]] report::TableFormat table_format(const Options& options);
/// The value of a key among the words; empty: the file's or the command's own.
[[nodiscard]] std::string word_of(const Options& options, std::string_view key);

/// The digits of a short answer on a terminal, unless --digits is given.
inline constexpr unsigned digits_of_short_answer = 6;

inline constexpr std::size_t most_threads = 1024;

/// Refuses the keys that are given as words although they have no effect: `why` gives the reason.
void refuse_words(const Options& options, const std::vector<std::string_view>& keys,
                  const std::string& why);
/// Sets the state of a scene to that after the step that --step names, if it is given.
void choose_step(scene::Scene& scene, const std::string& step);

/// Returns the scene, with the values of the words and options in place of its own. Throws
/// InputError for those that make no sense.
[[nodiscard]] scene::Scene asked_scene(const Options& options);
/// Sets the edges: those of the scene, else both.
void ask_at_edges(scene::Scene& scene);
/// Sets the numbers of terms: the scene's, else 1, 2, 3.
void ask_terms(scene::Scene& scene);
/// Restricts the quantities to the command's own, and those of `other_groups` that the scene names.
/// Throws InputError if a word names another.
void ask_for(scene::Scene& scene, const Options& options, scene::QuantityGroup own,
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

/// Draws the scene, with progress on a terminal.
[[nodiscard]] std::vector<report::Plot> picture_of(const scene::Scene& scene,
                                                   report::Panels panels = report::Panels::all);
/// Checks the file of --figure before any work.
void check_figure_option(const std::string& figure);

/// Returns the unit of a quantity in the units of the scene; empty if they are not known.
[[nodiscard]] std::string unit_of(const scene::Scene& scene, scene::Quantity quantity,
                                  std::size_t k = 0);

/// The object of a row of a table: the values of a place, with a number of terms or an index.
struct Line {
    scene::RowsAt at;
    std::size_t n = 0;
};

[[nodiscard]] std::vector<Line> lines_of(const std::vector<scene::RowsAt>& places);

/// A row of a table, which is filled cell by cell; the cells of the first row add the columns.
class Row {
public:
    using Column = report::Column;

    Row(const scene::Scene& scene, report::Table& table, const Line& line)
        : scene_(scene), table_(table), line_(line) {
        table.rows.emplace_back();
    }
    Column& add(const std::string& name, Column::Kind kind, std::string cell,
                Column::Role role = Column::Role::value);
    Column& text(const std::string& name, std::string cell, std::string phrase = {});
    /// The text of a quantity of n terms; empty where it has no value.
    Column& number(const std::string& name, scene::Quantity quantity, std::size_t n = 0);
    /// Adds NAME, NAME_bound, the column `route` (if it has a name), then NAME_binary64 if it is
    /// asked for; empty cells for a missing value. Returns the first of them.
    Column& value(const std::string& name, const std::string& route,
                  const std::optional<scene::BoundedValue>& value);
    Column& value(const std::string& name, const std::string& route, scene::Quantity quantity);
    void route(std::string cell) {
        add("route", Column::Kind::text, std::move(cell), Column::Role::route);
    }

private:
    const scene::Scene& scene_;
    report::Table& table_;
    const Line& line_;
};

/// Checks a user's own formulas: 0 if all of them hold, else 1 (verify.cpp).
[[nodiscard]] int check_ledger(const std::string& ledger, unsigned threads);

/// Shows on stderr the file for a scene that was given by words, if --show-scene asks for it.
void show_as_file(const Options& options);
/// Writes to --out, whole or not at all, or to stdout; a short answer, or wrapped lines, on a
/// terminal.
void emit(const report::Table& table, const Options& options);

} // namespace edgeproof::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_options.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/report/figures/scene_figure.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Common parts of the subcommands that compute a scene.
namespace edgeproof::cli {

/// Runs the scene, with progress on a terminal; SIGINT stops it. --verbose: shows on stderr what
/// was computed.
[[nodiscard]] scene::SceneResult done(const scene::Scene& scene, const SceneOptions& options);

/// Draws the scene, with progress on a terminal.
[[nodiscard]] std::vector<report::Plot> picture_of(const scene::Scene& scene);
/// Checks the file of --figure before any work, and draws the scene into it.
void check_figure_option(const std::string& figure);
void draw_figure_option(const scene::Scene& scene, const SceneOptions& options);

/// Returns an empty table for such a result, with its title and facts: the digits, a and b, P and M
/// if they were asked for, with friction the stick zone and the allowed bulk tensions.
[[nodiscard]] report::Table values_table(const scene::Scene& scene,
                                         const scene::SceneResult& result);

/// Adds the value of a quantity of the contact, if it was computed.
void add_fact(std::vector<report::Fact>& facts, const std::string& key, const scene::Scene& scene,
              const scene::SceneResult& result, scene::Quantity quantity);

/// Returns the unit of a quantity in the units of the scene; empty if they are not known.
[[nodiscard]] std::string unit_of(const scene::Scene& scene, scene::Quantity quantity,
                                  std::size_t k = 0);

/// The object of a row of a table: the values of a place, with a number of terms or an index.
struct Line {
    scene::RowsAt at;
    std::size_t n = 0;
};

[[nodiscard]] std::vector<Line> lines_of(const std::vector<scene::RowsAt>& places);

/// The columns of a table, each with its cell in the row of a line.
class Columns {
public:
    using Kind = report::Column::Kind;
    using Text = std::function<std::string(const Line&)>;
    using Value = std::function<std::optional<scene::BoundedValue>(const Line&)>;

    explicit Columns(const scene::Scene& scene) : scene_(scene) {}
    report::Column& add(const std::string& name, Kind kind, Text cell);
    report::Column& text(const std::string& name, Text cell, std::string phrase = {});
    /// The text of a quantity of n terms; empty where it has no value.
    report::Column& number(const std::string& name, scene::Quantity quantity, std::size_t n = 0);
    /// Adds NAME, NAME_bound, the column `route` (if it has a name), then NAME_binary64 if it is
    /// asked for; empty cells for a missing value. Returns the first of them.
    report::Column& value(const std::string& name, const std::string& route, Value value);
    report::Column& value(const std::string& name, const std::string& route,
                          scene::Quantity quantity);
    void route(Text cell) {
        add("route", Kind::text, std::move(cell)).role = report::Column::Role::route;
    }
    [[nodiscard]] report::Column& column(std::size_t i) { return columns_.at(i); }
    void write(report::Table& table, const std::vector<Line>& lines) const;

private:
    const scene::Scene& scene_;
    std::vector<report::Column> columns_;
    std::vector<std::function<void(const Line&, std::vector<std::string>&)>> cells_;
};

/// Checks a user's own formulas: 0 if all of them hold, else 1 (verify.cpp).
[[nodiscard]] int check_ledger(const std::string& ledger, unsigned threads);

/// Shows on stderr the file for a scene that was given by words, if --show-scene asks for it.
void show_as_file(const OutputOptions& options);
/// Writes to --out, whole or not at all, or to stdout; a short answer, or wrapped lines, on a
/// terminal.
void emit(const report::Table& table, const OutputOptions& options);

} // namespace edgeproof::cli

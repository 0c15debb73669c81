// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/cli/cli.hpp"
#include "edgeproof/cli/scene_options.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Common parts of the subcommands that compute a scene.
namespace edgeproof::cli {

/// Draws the scene, with progress on a terminal.
[[nodiscard]] std::vector<report::Plot> picture_of(const scene::Scene& scene);
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
void show_as_file(const OutputOptions& options);
/// Writes to --out, whole or not at all, or to stdout; a short answer, or wrapped lines, on a
/// terminal.
void emit(const report::Table& table, const OutputOptions& options);

} // namespace edgeproof::cli

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

/// Draws the scene, with tolerance 1% and 1, 2, 3 terms unless the scene has its own.
[[nodiscard]] report::ScenePicture picture_of(scene::Scene scene);
/// Adds --figure, and checks its file before any work, and draws the scene into it.
void add_figure_option(CLI::App& sub, SceneOptions& options);
void check_figure_option(const SceneOptions& options);
void draw_figure_option(const scene::Scene& scene, const SceneOptions& options);
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
[[nodiscard]] std::string bound_note();

/// Reads the option --body.
[[nodiscard]] scene::Body body_of(const std::string& name);
/// Reads a point "X,Z" of an option such as --point, in the names of the scene.
[[nodiscard]] scene::BodyPoint point_of(const std::string& option, const std::string& text,
                                        const scene::Place::Names& names);

/// Returns the unit of a quantity in the units of the scene; empty if they are not known.
[[nodiscard]] std::string unit_of(const scene::Scene& scene, scene::Quantity quantity,
                                  std::size_t k = 0);

/// Appends the cells of a value: its text, its bound, its route (if `route`), and its binary64 (if
/// it is asked for); empty cells for a missing value.
void append_value(std::vector<std::string>& row, const std::optional<scene::BoundedValue>& value,
                  bool route, const scene::Digits& digits);

/// The columns of a table, each with its cell in the row of an object.
template <class Object> class Columns {
public:
    using Kind = report::Column::Kind;

    explicit Columns(const scene::Scene& scene) : digits_(scene.ask.digits) {}
    report::Column& add(const std::string& name, Kind kind,
                        std::function<std::string(const Object&)> cell) {
        columns_.push_back({name, kind});
        cells_.push_back([cell = std::move(cell)](const Object& object, auto& row) {
            row.push_back(cell(object));
        });
        return columns_.back();
    }
    /// Adds NAME, NAME_bound, the column `route` (if it has a name), then NAME_binary64 if it is
    /// asked for. Returns the first of them.
    report::Column&
    add_value(const std::string& name, const std::string& route,
              std::function<std::optional<scene::BoundedValue>(const Object&)> value) {
        const std::size_t first = columns_.size();
        columns_.push_back({name});
        columns_.push_back({name + "_bound"});
        columns_.back().role = report::Column::Role::bound;
        if (!route.empty()) {
            columns_.push_back({route, Kind::text});
            columns_.back().role = report::Column::Role::route;
        }
        if (digits_.binary64) {
            columns_.push_back({name + "_binary64"});
        }
        cells_.push_back([value = std::move(value), with_route = !route.empty(),
                          digits = digits_](const Object& object, auto& row) {
            append_value(row, value(object), with_route, digits);
        });
        return columns_[first];
    }
    void write(report::Table& table, const std::vector<Object>& objects) const {
        table.columns = columns_;
        for (const Object& object : objects) {
            table.rows.emplace_back().reserve(columns_.size());
            for (const auto& cell : cells_) {
                cell(object, table.rows.back());
            }
        }
    }

private:
    scene::Digits digits_;
    std::vector<report::Column> columns_;
    std::vector<std::function<void(const Object&, std::vector<std::string>&)>> cells_;
};

/// Shows on stderr the file for a scene that was given by quantities, if --show-scene asks for it.
void show_as_file(const OutputOptions& options);
/// Writes to --out, whole or not at all, or to stdout; a short answer, or wrapped lines, on a
/// terminal.
void emit(const report::Table& table, const OutputOptions& options);

} // namespace edgeproof::cli

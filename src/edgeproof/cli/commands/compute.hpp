// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/cli/scene_command.hpp"

#include <string>
#include <vector>

/// The commands that compute a table of a scene: sets of quantities.
namespace edgeproof::cli {

/// What is computed for one table. A set asks for its quantities, and makes the columns.
class Computing {
public:
    explicit Computing(const Options& options)
        : o(options), body(options["--body"].empty() ? "A" : options["--body"]),
          scene(asked_scene(options)) {}

    /// Computes the set's own quantities, and those of `others` that the scene names.
    void run(scene::QuantityGroup own,
             const std::vector<scene::QuantityGroup>& others = {scene::QuantityGroup::contact});
    /// Computes the quantities that the scene asks for, with progress on a terminal; SIGINT stops
    /// it. --verbose shows on stderr what was computed. The facts of the table are the digits, and
    /// a and b, P and M if they were asked for.
    void run();
    /// Adds, with friction, Q/(f P), the stick zone, and the allowed bulk tensions.
    void add_slip_facts();
    void note(std::string text) { table.notes.push_back(std::move(text)); }
    /// Adds a row for each line: fill(Row&, line).
    template <class Fill> void add_rows(const std::vector<Line>& lines, const Fill& fill) {
        for (const Line& line : lines) {
            Row row(scene, table, line);
            fill(row, line);
        }
    }
    /// Writes the table, and the picture if there is to be one.
    int write(const std::vector<std::string>& remarks = {});
    /// Throws InputError with a line of the scene.
    [[noreturn]] void reject(const std::string& problem, const std::string& instead,
                             std::size_t line) const;

    const Options& o;
    const std::string body;
    scene::Scene scene;
    scene::SceneResult result;
    report::Table table;
    std::string bounds = "bounds are proved, and every digit printed is right, unless the route "
                         "says estimate"; ///< the remark

private:
    /// Adds the value of a quantity of the contact, if it was computed.
    void add_fact(const std::string& key, scene::Quantity quantity);
    void add_fact(const std::string& key, scene::Quantity quantity,
                  const scene::BoundedValue& value);
};

[[nodiscard]] std::string edge_of(const Line& line);
/// Returns the value for a route column. Its route names the other values of the same columns that
/// are not proved although this value is.
[[nodiscard]] scene::BoundedValue marked(const scene::RowsAt& at, scene::Quantity quantity,
                                         const std::string& prefix);

/// The coefficients of the stresses along a ray: a row for each power of the distance.
int expand_stresses(const Options& options);

} // namespace edgeproof::cli

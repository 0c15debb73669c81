// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/recipe_grid.hpp"
#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/io/csv.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Returns cells as a line of CSV, with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

/// Makes the rows of a reference table one by one, without storing them.
class ReferenceRows {
public:
    explicit ReferenceRows(const conformance::Recipe& recipe);
    explicit ReferenceRows(const conformance::RecipeGrid& recipe)
        : ReferenceRows(recipe.sample()) {}
    [[nodiscard]] std::vector<std::string> row(const conformance::Questions& questions,
                                               std::size_t i,
                                               const conformance::Reference& reference) const;
    /// Appends the row as a line of CSV to `text`.
    void add_line(std::string& text, const conformance::Questions& questions, std::size_t i,
                  const conformance::Reference& reference) const;
    /// The checksum of the header, to be continued line by line (io::fnv1a).
    [[nodiscard]] std::uint64_t header_checksum() const;
    /// The table without its rows: head and columns. `checksum`: of the header and the lines.
    [[nodiscard]] Table table(std::size_t rows, std::size_t estimates,
                              std::uint64_t checksum) const;

private:
    [[nodiscard]] std::vector<Column> columns() const;
    template <class Take>
    void each_cell(const conformance::Questions& questions, std::size_t i,
                   const conformance::Reference& reference, const Take& take) const;

    std::string recipe_; ///< the file's name
    std::string title_;
    scene::Digits digits_;
    std::vector<std::string> keys_;
    bool tolerances_;
    bool bodies_;
    std::set<scene::Quantity> quantities_;
};

/// Returns a recipe's answers as a table, one row per question: id, parameters, edge, u, x,
/// quantity, value, bound, binary64 (17 digits), route. The checksum covers the header and the rows
/// as CSV, so that it is the same in every format.
[[nodiscard]] Table reference_table(const conformance::Recipe& recipe,
                                    const std::vector<conformance::Reference>& values);

/// The same for some of the recipe's questions.
[[nodiscard]] Table reference_table(const conformance::Recipe& recipe,
                                    const conformance::Questions& some,
                                    const std::vector<conformance::Reference>& values);

/// Returns the questions as a table to be answered: id, parameters, quantity, edge, u, x; the other
/// program adds a column `value`. x is left out if it is not rational.
[[nodiscard]] Table question_table(const conformance::Questions& questions,
                                   const std::string& title);

/// Returns the differences between a table on disk and a new one, one line each: rows that differ,
/// are missing, superfluous or out of order, and a head that states other digits, another rounding,
/// or another number of rows or estimates or another checksum than that of its rows. `sample`: the
/// new table has only some of the rows. Empty if all digits agree.
[[nodiscard]] std::vector<std::string> table_differences(const io::Csv& old, const Table& made,
                                                         bool sample);

} // namespace edgeproof::report

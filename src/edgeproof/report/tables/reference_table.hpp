// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/questions/recipe.hpp"
#include "edgeproof/conformance/questions/reference.hpp"
#include "edgeproof/io/csv.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Cells as a line of CSV, with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

/// The rows of a reference table, one by one: none is kept.
class ReferenceRows {
public:
    explicit ReferenceRows(const conformance::Recipe& recipe);
    explicit ReferenceRows(const conformance::RecipeGrid& recipe);
    [[nodiscard]] std::vector<std::string> row(const conformance::Questions& questions,
                                               std::size_t i,
                                               const conformance::Reference& reference) const;
    /// The row as a line of CSV, behind what stands in `text`.
    void add_line(std::string& text, const conformance::Questions& questions, std::size_t i,
                  const conformance::Reference& reference) const;
    /// The checksum of the header, to be gone on with line by line (io::fnv1a).
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
    std::set<scene::Quantity> quantities_;
};

/// A recipe's answers as a table, a row a question: id, parameters, edge, u, x, quantity, value,
/// bound, binary64 (17 digits), route. The checksum is over the
/// header and the rows as CSV, so that it is the same in every format.
[[nodiscard]] Table reference_table(const conformance::Recipe& recipe,
                                    const std::vector<conformance::Reference>& values);

/// The questions as a table to be answered: id, parameters, quantity, edge, u, x; whoever answers
/// adds a column `value`. x is left out where it is not rational.
[[nodiscard]] Table question_table(const conformance::Questions& questions,
                                   const std::string& title);

/// What differs between a table on disk and the same one made anew, a line each: rows that differ,
/// are missing, are too many or out of order, a checksum that does not fit. `sample`: the
/// new table holds some of the rows only. Empty: they agree in every digit.
[[nodiscard]] std::vector<std::string> table_differences(const io::Csv& old, const Table& made,
                                                         bool sample);

} // namespace edgeproof::report

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/report/tables/table.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace edgeproof::report {

/// Returns cells as a line of CSV, with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

/// Returns what the head of a reference table states about its rows: their number, the number of
/// estimates, and the checksum (io::fnv1a) of the header and the rows as CSV.
[[nodiscard]] std::vector<Fact> facts_of_rows(const io::Csv& table);

/// Returns answers to some of a recipe's questions as a table, one row per question: id,
/// parameters, edge, u, x, quantity, value, bound, binary64 (17 digits), route. The checksum covers
/// the header and the rows as CSV, so that it is the same in every format.
[[nodiscard]] Table reference_table(const conformance::Recipe& recipe,
                                    const conformance::Questions& some,
                                    const std::vector<conformance::Reference>& values);

/// Returns the table of all values with one row a contact: its parameters, then a column for each
/// question, such as "c_0", "c_0 left", "p u=1/10". The cells have values without bounds. Throws
/// InputError if a value is an estimate.
[[nodiscard]] Table wide_table(const conformance::Recipe& recipe,
                               const std::vector<conformance::Reference>& values);

/// Returns the questions as a table to be answered: id, parameters, quantity, edge, u, x; the other
/// program adds a column `value`. x is left out if it is not rational.
[[nodiscard]] Table question_table(const conformance::Questions& questions,
                                   const std::string& title);

/// Returns the differences between recorded rows and the same rows made anew, each found by its
/// first cell, a line each: rows that differ, are missing or occur twice, and recorded ones that
/// are not there any more although `is_made` states that their ids are made anew.
[[nodiscard]] std::vector<std::string>
row_differences(const io::Csv& old, const std::vector<std::vector<std::string>>& made,
                const std::function<bool(const std::string&)>& is_made);

/// Returns the differences between a table on disk and a new one, one line each: those of rows, and
/// a head that states other digits, another rounding, or another number of rows or estimates or
/// another checksum than that of its rows (which also tells their order). `sample`: the new table
/// has only some of the rows. Empty if all digits agree.
[[nodiscard]] std::vector<std::string> table_differences(const io::Csv& old, const Table& made,
                                                         bool sample);

/// Every `of`-th row of a table, from the row `number` (1, 2, ...) on.
struct PartOfTable {
    std::size_t number = 1;
    std::size_t of = 1;
    std::string recipe_sha256; ///< of the recipe's file
};

/// Reads "K/N". Throws InputError unless 1 <= K <= N.
[[nodiscard]] PartOfTable part_named(const std::string& text, const std::filesystem::path& recipe);
/// The facts that the head of a part has in addition to those of its table.
[[nodiscard]] std::vector<Fact> facts_of(const PartOfTable& part);

/// Whether the file is this part, made by this program, with all its rows and the right checksum.
[[nodiscard]] bool is_complete_part(const std::filesystem::path& file, const PartOfTable& part);

/// Returns the table (CSV) of which these files are all the parts: the bytes are those of the table
/// made at once. Throws InputError, with the file, for a part that is damaged, missing, given twice
/// or of another table.
[[nodiscard]] std::string merged_parts(const std::vector<std::string>& files);

} // namespace edgeproof::report

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/report/tables/table.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace edgeproof::report {

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/report/tables/table.hpp"

#include <functional>

/// Functions that the formats of a table share.
namespace edgeproof::report {

/// Returns title, facts, notes and remarks, each on a line that begins with `mark`.
[[nodiscard]] std::string heading(const Table& table, const std::string& mark);

inline constexpr std::size_t separator_width = 3; // " | "

/// Distributes the columns over tables no wider than `most` (0: one table). Each repeats the first
/// two columns, which identify a row.
[[nodiscard]] std::vector<std::vector<std::size_t>>
columns_that_fit(const std::vector<std::size_t>& width, std::size_t most);

/// Returns the table without the columns of which `kept` is false.
[[nodiscard]] Table columns_kept(const Table& table,
                                 const std::function<bool(const Column&)>& kept);

/// Returns the table in LaTeX, as one or more tables no wider than the text of a page.
[[nodiscard]] std::string latex_tables(const Table& table, bool notes);

} // namespace edgeproof::report

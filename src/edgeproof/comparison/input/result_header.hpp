// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/comparison/input/result_table.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

/// A column that is read.
struct UsedColumn {
    std::size_t index = 0;
    ColumnName name;
};

/// Which columns of a table are read, and what their numbers are multiplied with.
struct TableHeader {
    UsedColumn x;
    UsedColumn p;
    std::optional<UsedColumn> q;
    Rational x_factor = 1;
    Rational p_factor = 1;
    std::vector<std::string> findings; ///< how that was found
};

/// Where the rows of a table begin and how they are cut.
struct TableShape {
    std::string file;
    Separator separator = Separator::comma;
    std::size_t size = 0;      ///< cells of a row
    std::size_t first_row = 0; ///< index of its line
};

/// Reads the lines before the first row: names, units behind them, in a row of their own or in a
/// comment. Throws InputError where x or p are not found, or twice, and for a unit of the wrong
/// kind.
[[nodiscard]] TableHeader read_header(const std::vector<ResultLine>& lines, const TableShape& shape,
                                      const ResultReading& reading);

} // namespace edgeproof::comparison

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/comparison/input/result_lines.hpp"
#include "edgeproof/comparison/input/result_table.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace edgeproof::comparison {

struct UsedColumn {
    std::size_t index = 0;
    ColumnName name;
};

/// The columns of a table in use, and the factors of their numbers.
struct TableHeader {
    UsedColumn x;
    UsedColumn p;
    std::optional<UsedColumn> q;
    Rational x_factor = 1;
    Rational p_factor = 1;
    std::vector<std::string> findings; ///< notes on how they were found
};

/// Reads the lines before the first row: names, and units after them, in a row of their own or in a
/// comment. Throws InputError if x or p are not found, or are found twice, and for a unit of the
/// wrong kind.
[[nodiscard]] TableHeader read_header(const ResultText& text, const ResultReading& reading);

} // namespace edgeproof::comparison

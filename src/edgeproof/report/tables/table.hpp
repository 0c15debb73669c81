// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::report {

/// How a table is written.
enum class TableFormat { csv, json, markdown, latex };
/// csv, json, md, tex. Nothing for other names.
[[nodiscard]] std::optional<TableFormat> table_format(std::string_view name);

/// A column; what a cell of it holds decides how it is laid out.
struct Column {
    enum class Kind {
        text,
        number, ///< in JSON a string too: no digit is lost
        count   ///< in JSON an integer
    };
    std::string name;
    Kind kind = Kind::number;
    /// Of a text: exact numbers as they were given ("-pi/16"), which are read again.
    bool exact = false;
};

/// What holds for the whole table: `# key: value` in CSV, a key in JSON.
struct Fact {
    std::string key;
    std::string value;
    std::string bound = {}; ///< where it is a value with a bound and its route
    std::string route = {};
};

/// A table as it is printed: every cell is final text, empty where there is none.
struct Table {
    std::string title;
    std::vector<Fact> facts;
    std::vector<std::string> notes; ///< what the columns are, how they are bounded
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
};

/// The same table, the same bytes, by the same program, which is named among the facts. CSV: notes
/// are lines that begin with #. Markdown: aligned, so that it reads as text. LaTeX: booktabs, for
/// `\input`.
///
/// `width`: Markdown no wider than that, as far as one column beside the first two (which say what
/// a row is of) permits: the other columns in tables below each other. 0: all in one.
[[nodiscard]] std::string write_table(const Table& table, TableFormat format,
                                      std::size_t width = 0);

} // namespace edgeproof::report

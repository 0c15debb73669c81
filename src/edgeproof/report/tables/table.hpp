// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::report {

enum class TableFormat { csv, json, markdown, latex };
/// Reads csv, json, md, tex. Returns nothing for other names.
[[nodiscard]] std::optional<TableFormat> table_format(std::string_view name);

/// A column; the kind of its cells determines the layout.
struct Column {
    enum class Kind {
        text,
        number, ///< also a string in JSON, so that no digit is lost
        count,  ///< an integer in JSON
        markup  ///< HTML, for `html_table` only
    };
    std::string name;
    Kind kind = Kind::number;
    /// For a text: exact numbers as given ("-pi/16"), which are read again.
    bool exact = false;
};

/// A property of the whole table: `# key: value` in CSV, a key in JSON.
struct Fact {
    std::string key;
    std::string value;
    std::string bound = {}; ///< for a value with a bound and its route
    std::string route = {};
};

/// A printed table: every cell is final text, possibly empty.
struct Table {
    std::string title;
    std::vector<Fact> facts;
    std::vector<std::string> notes; ///< the meaning and the bounds of the columns
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Writes the table; the same program writes the same bytes. The program is one of the facts. CSV:
/// notes are lines that begin with #. Markdown: aligned, so that it is readable as text. LaTeX:
/// booktabs, for `\input`.
///
/// `width`: the greatest width of Markdown, as far as the first two columns (which identify a row)
/// and one other permit; the other columns are placed in further tables below. 0: one table.
[[nodiscard]] std::string write_table(const Table& table, TableFormat format,
                                      std::size_t width = 0);

/// Returns head and rows in aligned columns, text to the left, numbers to the right, each line
/// after `margin` blanks. `rule`: with a line below the head.
[[nodiscard]] std::string aligned_lines(const Table& table, std::size_t margin, bool rule);

/// Returns head and rows as a table of HTML that scrolls within its page. `grouped`: draws a line
/// above each row with a new text in its first column.
[[nodiscard]] std::string html_table(const Table& table, bool grouped = false);

} // namespace edgeproof::report

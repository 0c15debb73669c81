// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
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
        count   ///< an integer in JSON
    };
    /// The role of a cell: a value, or the limit of the error or the route of the value on its
    /// left.
    enum class Role { value, bound, route };
    enum class Shown { everywhere, not_on_terminal, on_terminal_only };
    std::string name;
    Kind kind = Kind::number;
    /// For a text: exact numbers as given ("-pi/16"), which are read again.
    bool exact = false;
    // For short_answer only:
    Role role = Role::value;
    std::string phrase = {}; ///< "{} edge": the cell in a line; empty: "NAME = {}"
    std::string unit = {};
    Shown shown = Shown::everywhere;
};

/// A property of the whole table: `# key: value` in CSV, a key in JSON.
struct Fact {
    std::string key;
    std::string value;
    std::string bound = {}; ///< for a value with a bound and its route
    std::string route = {};
    std::string unit = {}; ///< for short_answer only
};

/// A printed table: every cell is final text, possibly empty.
struct Table {
    std::string title;
    std::vector<Fact> facts;
    std::vector<std::string> notes; ///< the meaning and the bounds of the columns
    /// Further notes, which short_answer shows, too: warnings, the reliability of the bounds.
    std::vector<std::string> remarks = {};
    std::string asked = {}; ///< for short_answer only: what the rows answer
    /// In CSV: facts and notes precede the header, as in the files of reference tables.
    bool notes_first = false;
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
};

struct TableLayout {
    /// The greatest width of Markdown, as far as the first two columns (which identify a row) and
    /// one other permit; the other columns are placed in further tables below. 0: one table.
    std::size_t width = 0;
    bool notes = true; ///< with title, facts and notes
};

/// Writes the table; the same program writes the same bytes. The program is one of the facts. CSV:
/// facts and notes are lines that begin with # behind the rows, so that readers that take the first
/// line for the header work. Markdown: aligned, so that it is readable as text. LaTeX: booktabs,
/// for `\input`; columns that do not fit the width of A4 follow in further tables below, and a
/// table of more rows than a page has is a longtable.
[[nodiscard]] std::string write_table(const Table& table, TableFormat format,
                                      const TableLayout& layout = {});

/// Returns the table with these columns, in this order. Throws InputError for a name that it does
/// not have.
[[nodiscard]] Table with_columns(const Table& table, const std::vector<std::string>& names);

/// Returns the table for a reader at a terminal of `width` columns: what was asked, the facts, a
/// line for each row with names, bounds and units, and the remarks. Routes are left out unless they
/// are estimates.
[[nodiscard]] std::string short_answer(const Table& table, std::size_t width);

/// Returns head and rows in aligned columns, text to the left, numbers to the right, each line
/// after `margin` blanks. `rule`: with a line below the head.
[[nodiscard]] std::string aligned_lines(const Table& table, std::size_t margin, bool rule);

// Functions that the formats of a table share.

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

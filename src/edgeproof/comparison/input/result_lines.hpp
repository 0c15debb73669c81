// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/comparison/input/result_table.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::comparison {

struct Cell {
    std::string text;
    bool quoted = false;
};

struct ResultLine {
    std::size_t number = 0; ///< from 1
    std::string text;       ///< without its end
    bool comment = false;   ///< begins with #, %, !, //, or **
};

/// The separators of cells: tab, semicolon, bar, comma and blank (then a tab is one, too).
[[nodiscard]] std::string separator_name(char separator);

/// Returns the cells of a row, trimmed, without quotes. Empty cells at the end are left out.
[[nodiscard]] std::vector<Cell> split_row(std::string_view line, char separator);

/// Returns the number in a cell as a plain decimal: a decimal comma becomes a point (unless commas
/// are separators and the cell is not quoted), and `1.5-104` (Fortran), `1.5Q-4` and `1.5*^-4` get
/// the exponent letter E.
/// Returns nothing if the cell is not a number; nan and inf are not numbers.
[[nodiscard]] std::optional<std::string> number_of(const Cell& cell, char separator);
[[nodiscard]] bool is_nan_or_infinite(const Cell& cell);
/// The text of a cell for a message: quoted, printable, not long.
[[nodiscard]] std::string shown_cell(std::string_view text);

/// Returns the column and the index of the first number whose mark may stand between thousands,
/// such as `1,031`: three digits follow the mark, no number of the columns shows that it is the
/// decimal one, and the other mark is, or the column has smaller whole numbers without a mark.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>>
ambiguous_mark(const std::vector<std::vector<std::string>>& columns);

/// The lines of a file that are not blank, and the shape of the rows of numbers.
struct ResultText {
    std::string file;
    std::vector<ResultLine> lines;
    char separator = ',';
    std::size_t size = 0;                   ///< cells of a row
    std::size_t first_row = 0;              ///< index of its line
    std::vector<std::string> findings = {}; ///< notes on how it was read

    [[nodiscard]] std::vector<Cell> cells(const ResultLine& line) const {
        return split_row(line.text, separator);
    }
    [[nodiscard]] bool is_number(const Cell& cell) const {
        return number_of(cell, separator).has_value();
    }
    [[nodiscard]] std::size_t numbers_in(const std::vector<Cell>& cells) const;
    /// Throws InputError, with the file.
    [[noreturn]] void reject(std::size_t line, const std::string& problem,
                             const std::string& instead) const;
};

/// Reads a text in UTF-8, with or without a byte order mark, in UTF-16 with one, or in Latin-1,
/// whose lines end in LF, CR LF or CR, and finds the separator of the rows. The minus sign and the
/// no-break blanks of Unicode become '-' and ' '. Of rows of several lengths, the most frequent
/// length of the first hundred is used. Throws InputError for a text that is empty, with an
/// incomplete character of UTF-16 or a zero byte, and if no row has two numbers or more.
[[nodiscard]] ResultText result_text(std::string_view text, const std::string& file);

/// Returns half a unit of the last digit of each number of a column. Numbers with an exponent have
/// as many digits as the longest of the column, those without as many decimals: "0.5" among
/// "0.333333" is taken to have six. Hexadecimal numbers, and zero with an exponent, are exact: 0.
[[nodiscard]] std::vector<double> column_rounding(const std::vector<std::string_view>& column);

struct UsedColumn {
    std::size_t index = 0;
    ColumnName name;
    Rational factor = 1; ///< of its numbers
};

/// The columns of a table in use. q has the factor of p.
struct TableHeader {
    std::size_t line = 0; ///< of the names of x and p; 0 if there are none
    UsedColumn x;
    UsedColumn p;
    std::optional<UsedColumn> q;
    /// Gap, slip and sxx along the surface, in the order of surface_roles.
    std::array<std::optional<UsedColumn>, surface_roles.size()> surface;
    std::vector<UsedColumn> steps;     ///< numbers of load steps, then of increments, then times
    std::vector<std::string> findings; ///< notes on how they were found
};

/// Reads the lines before the first row: names, and units after them or in a row of their own.
/// Throws InputError if x or p are not found, or are found twice, and for a unit of the wrong kind.
[[nodiscard]] TableHeader read_header(const ResultText& text, const ResultReading& reading);

/// The contact output of a node, in the order of an .frd file.
enum ContactValue : std::size_t { copen, cslip1, cslip2, cpress, cshear1, cshear2, contact_values };

/// A number as it stands in the file; without a text there is none.
struct FrdNumber {
    std::string text;
    double value = 0;
};
struct FrdRow {
    std::vector<FrdNumber> values;
    std::size_t line = 0;
};
using FrdRows = std::map<std::string, FrdRow, std::less<>>; ///< by the number of the node

/// The values of a file at each node; the last step replaces those before.
struct FrdContents {
    FrdRows places;
    FrdRows contact; ///< contact_values
    FrdRows stress;  ///< SXX, SYY, SZZ
    std::size_t steps = 0;
};

/// Reads an .frd file of CalculiX in text: lines of fixed columns, one for a node. Throws
/// InputError, with the line, for a row that is not as CalculiX writes it, a node with two rows and
/// a file that ends inside a block; of a binary file for its first block.
[[nodiscard]] FrdContents read_frd(std::string_view text, const std::string& file);

/// A result of CalculiX as a table with the names COORD1, COORD2, COORD3, CPRESS, CSHEAR1, COPEN,
/// CSLIP1, S11: a row for each node of the slave surface, with its place before the deformation. If
/// the contact does not lie along COORD1, the first column is x, and S11 is the stress along it. Of
/// the two tangential directions, the one with the larger values is taken.
/// Each row has the number of its line in the file.
///
/// Reads the contact output of an .frd file of CalculiX (in text, of the last step that has
/// CONTACT, with SXX of STRESS). The contact lies along the coordinate with which the pressures
/// change. Nodes of one plane across it are kept if the surface has several. Contact from surface
/// to surface has rows of zeros for all nodes in no face in contact: the rows of the others are
/// kept, and up to three places further on each side, without a gap. Returns nothing for any other
/// text. Throws InputError, with the line, for a file without contact output, a .dat file (which
/// has no places), a binary .frd file, a node without a place, and a row that is not as CalculiX
/// writes it.
[[nodiscard]] std::optional<ResultText> calculix_table(std::string_view text,
                                                       const std::string& file);

} // namespace edgeproof::comparison

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::comparison {

/// A cell of a row of a result file.
struct Cell {
    std::string text;
    bool quoted = false;
};

/// A line of a result file.
struct ResultLine {
    std::size_t number = 0; ///< from 1
    std::string text;       ///< without its end
    bool comment = false;   ///< begins with #, %, !, //, or **
};

/// What separates the cells of a row. `comma_and_blank`: commas that a blank follows, so that the
/// others are decimal commas.
enum class Separator { tab, semicolon, bar, comma, comma_and_blank, blank };
[[nodiscard]] std::string separator_name(Separator separator);

/// The lines that are not blank, of a text in UTF-8 with or without a byte order mark whose lines
/// end in LF, CR LF or CR. Throws InputError for a text in UTF-16 and for one with a zero byte.
[[nodiscard]] std::vector<ResultLine> result_lines(std::string_view text, const std::string& file);

/// The cells of a row, trimmed, quotes taken off. Empty cells at the end do not count.
[[nodiscard]] std::vector<Cell> split_row(std::string_view line, Separator separator);

/// The cell as the plain decimal that it stands for: a decimal comma is a point (unless commas
/// separate and it is not quoted), and Fortran's `1.5-104` has its letter back. Nothing where it is
/// no number; nan and inf are none.
[[nodiscard]] std::optional<std::string> number_of(const Cell& cell, Separator separator);
[[nodiscard]] bool is_nan_or_infinite(const Cell& cell);

/// What separates the cells of the rows of numbers. Throws InputError where there are none with two
/// numbers or more, and where commas may be decimal or separators and `header_cells` decides
/// nothing.
[[nodiscard]] Separator find_separator(const std::vector<ResultLine>& lines,
                                       const std::string& file);

} // namespace edgeproof::comparison

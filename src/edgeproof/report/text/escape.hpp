// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

/// Somebody else's text (names, ids, notes, formulas, file names) as it may stand in each format
/// that is written, so that it is read there as text and as nothing else: one function a place.
/// `escape_html` (html_markup.hpp) and `printable` (precision/message.hpp), which all of them apply
/// first, are of the same kind, for HTML and a terminal.
namespace edgeproof::report {

/// A cell of a CSV row, quoted where it has to be.
[[nodiscard]] std::string csv_cell(std::string_view text);
/// The same, behind what stands in `line`.
void add_csv_cell(std::string& line, std::string_view text);
/// The same for a column of text: a cell that begins with =, +, - or @ and is no number gets an
/// apostrophe in front, or a spreadsheet would take it for a formula and run it.
[[nodiscard]] std::string csv_text_cell(std::string_view text);

/// Between the marks of a Markdown line or table row: no mark, tag or link of its own.
[[nodiscard]] std::string markdown_text(std::string_view text);
/// A Markdown code span in a table row.
[[nodiscard]] std::string markdown_code(std::string_view text);

/// In an attribute or a text of XML.
[[nodiscard]] std::string xml_text(std::string_view text);

/// In a LaTeX paragraph or cell: no command of its own.
[[nodiscard]] std::string latex_text(std::string_view text);

} // namespace edgeproof::report

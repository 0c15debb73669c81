// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

/// Escapes text of other authors (names, ids, notes, formulas, file names) for each output format,
/// so that it is read there as plain text; one function per format. For a terminal this is
/// `printable` (precision/message.hpp), which all of them but `escape_html` apply first.
namespace edgeproof::report {

/// Returns a cell of a CSV row, quoted if necessary.
[[nodiscard]] std::string csv_cell(std::string_view text);
void add_csv_cell(std::string& line, std::string_view text);
/// Returns a cell of a text column: if it begins with =, +, - or @ and is not a number, it gets an
/// apostrophe in front, since a spreadsheet would execute it as a formula.
[[nodiscard]] std::string csv_text_cell(std::string_view text);

/// Returns text for a line or a table row of Markdown, without marks, tags or links of its own.
[[nodiscard]] std::string markdown_text(std::string_view text);
/// Returns a Markdown code span for a table row.
[[nodiscard]] std::string markdown_code(std::string_view text);

/// Returns text for an attribute or a text of XML.
[[nodiscard]] std::string xml_text(std::string_view text);

/// Returns text for a LaTeX paragraph or cell, without commands of its own.
[[nodiscard]] std::string latex_text(std::string_view text);

/// Escapes text for HTML, between tags or in a quoted attribute. Control characters not allowed in
/// HTML become spaces; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string escape_html(std::string_view text);

/// Returns the number of UTF-8 code points as the number of columns; nearly all texts are ASCII.
[[nodiscard]] inline std::size_t text_width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

} // namespace edgeproof::report

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/precision/real.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::io {

/// Separated values according to RFC 4180 (quoted cells, "" for a quote, either line end), with
/// notes: lines that begin with #. The separator is the comma; a header without a comma may use
/// tabs or semicolons, which then apply to the file. A UTF-8 byte order mark is skipped, and a text
/// in UTF-16 with a byte order mark is converted. Blanks around an unquoted cell or around quotes
/// are ignored; other characters next to the quotes, and quotes within an unquoted cell, are
/// errors.
struct Csv {
    struct Row {
        std::size_t line = 0;
        std::vector<std::string> cells;
        std::string fault = {}; ///< why the row cannot be read; empty: it is valid
    };
    std::string file;
    char separator = ',';
    std::vector<std::string> notes;      ///< without the #
    std::vector<std::size_t> note_lines; ///< the line of each note
    Row header;
    std::vector<Row> rows; ///< rows may have different numbers of cells
    bool cut = false;      ///< the file has more rows than most_rows

    [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
};

struct CsvReading {
    /// Keep a row that breaks the rules, with its fault, and read the rows after it. A missing end
    /// of a quote makes one row of all following text.
    bool keep_faults = false;
    std::size_t most_rows = std::numeric_limits<std::size_t>::max(); ///< the rest is not read
};

/// Throws InputError for a text without a header line, for a text in UTF-16 without a byte order
/// mark or with lines that end in CR alone, as utf8_text() does, and for a row that breaks the
/// rules unless such rows are kept.
[[nodiscard]] Csv parse_csv(std::string_view text, const std::string& file,
                            const CsvReading& reading = {});

/// The interpretation of a text that another program wrote for a number.
struct WrittenNumber {
    enum class Kind { number, nan, infinite, other };
    Kind kind = Kind::other;
    Rational value; ///< the exact value of the text, for Kind::number
};

/// The grammar of numbers that other programs write, for the whole text; letters of either case:
///
///     number      = [sign] (decimal | hexadecimal)
///     decimal     = digits-with-a-point [(E | D) [sign] digits]
///     hexadecimal = 0x hex-digits-with-a-point [P [sign] digits]
///     digits-with-a-point: at least one digit and at most one point, before, between or after them
///     nan         = [sign] nan [(letters, digits, _)]
///     infinite    = [sign] (inf | infinity)
///
/// At most one sign, no blanks. A number beyond 10^(+-100000) or of more than 100,000 digits is
/// Kind::other. Never throws.
[[nodiscard]] WrittenNumber written_number(std::string_view text);

/// Returns the exact value of a number of this grammar; nothing for another text.
[[nodiscard]] std::optional<Rational> read_number(std::string_view text);

/// The digits of a number as it is written.
struct DecimalForm {
    bool exact = false; ///< hexadecimal
    bool with_exponent = false;
    bool zero = true;
    int significant = 0;      ///< digits from the first that is not 0
    int carried = 0;          ///< digits from there to the last that is not 0
    int leading = 0;          ///< the power of ten of the first digit that is not 0
    int decimals = 0;         ///< after the point, without regard to the exponent
    int carried_decimals = 0; ///< of the value, to the last digit that is not 0
};
[[nodiscard]] DecimalForm form_of(std::string_view text);

/// Replaces the comma by a point, if the text is then a decimal of the grammar.
[[nodiscard]] std::optional<std::string> with_decimal_point(std::string_view text);

} // namespace edgeproof::io

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/text_file.hpp"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
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

/// Reads rows one by one. A file is read as needed; only one block, or the longest row, is kept in
/// memory, but all of a file in UTF-16.
class CsvReader {
public:
    /// Throws InputError for a text without a header line, for a text in UTF-16 without a byte
    /// order mark or with lines that end in CR alone, and as TextReader and utf8_text() do.
    CsvReader(std::string_view text, const std::string& file);
    CsvReader(const std::filesystem::path& file, const std::string& what);
    ~CsvReader();
    CsvReader(const CsvReader&) = delete;
    CsvReader& operator=(const CsvReader&) = delete;

    /// The header and the notes read so far; no rows.
    [[nodiscard]] const Csv& head() const { return head_; }
    /// The bytes of the file read so far.
    [[nodiscard]] std::size_t bytes() const { return file_ ? file_->bytes() : 0; }
    /// The bytes of the file in memory.
    [[nodiscard]] std::size_t kept() const { return block_.size(); }
    /// Reads the next row, with its fault if it breaks the rules; returns false after the last row.
    [[nodiscard]] bool next(Csv::Row& row);

private:
    class Parser;
    void begin();

    Csv head_;
    std::unique_ptr<TextReader> file_; ///< null: the source is a text
    std::string block_;                ///< a part of the file
    std::unique_ptr<Parser> parser_;
};

/// Throws InputError as CsvReader does, and for a row that breaks the rules unless such rows are
/// kept.
[[nodiscard]] Csv parse_csv(std::string_view text, const std::string& file,
                            const CsvReading& reading = {});

} // namespace edgeproof::io

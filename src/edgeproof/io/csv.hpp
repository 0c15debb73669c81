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

/// Separated values as RFC 4180 has them (quoted cells, "" for a quote, either line end), with
/// notes: lines that begin with #. The separator is the comma; a header without one may use tabs or
/// semicolons, which then hold for the file. A UTF-8 byte order mark is skipped. Blanks around a
/// cell that is not quoted, or around the quotes, do not count; nothing else may stand beside the
/// quotes, and no quote within a cell that is not quoted.
struct Csv {
    struct Row {
        std::size_t line = 0;
        std::vector<std::string> cells;
        std::string fault = {}; ///< why the row cannot be read; empty: it can
    };
    std::string file;
    char separator = ',';
    std::vector<std::string> notes;      ///< without the #
    std::vector<std::size_t> note_lines; ///< of the notes, one each
    Row header;
    std::vector<Row> rows; ///< as many cells as they happen to have
    bool cut = false;      ///< there are more rows than most_rows

    [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
};

struct CsvReading {
    /// A row that breaks the rules is kept, its fault said, and those behind it are read. A quote
    /// that does not end makes one row of all that follows.
    bool keep_faults = false;
    std::size_t most_rows = std::numeric_limits<std::size_t>::max(); ///< the rest is not read
};

/// Rows one by one. Of a file, which is read as it is needed, no more is kept than a block, or the
/// longest row.
class CsvReader {
public:
    /// Throws InputError for a text without a header line, for one in UTF-16 or whose lines end in
    /// CR alone, and as TextReader does.
    CsvReader(std::string_view text, const std::string& file);
    CsvReader(const std::filesystem::path& file, const std::string& what);
    ~CsvReader();
    CsvReader(const CsvReader&) = delete;
    CsvReader& operator=(const CsvReader&) = delete;

    /// The header and the notes that were met so far; no rows.
    [[nodiscard]] const Csv& head() const { return head_; }
    /// Of the file, that were read.
    [[nodiscard]] std::size_t bytes() const { return file_ ? file_->bytes() : 0; }
    /// Of them, that are in memory.
    [[nodiscard]] std::size_t kept() const { return block_.size(); }
    /// The next row, its fault told where it breaks the rules; false behind the last.
    [[nodiscard]] bool next(Csv::Row& row);

private:
    class Parser;
    void begin();

    Csv head_;
    std::unique_ptr<TextReader> file_; ///< null: of a text
    std::string block_;                ///< of the file
    std::unique_ptr<Parser> parser_;
};

/// Throws InputError for a text without a header line, for one in UTF-16 or whose lines end in CR
/// alone, and for a row that breaks the rules unless those are kept.
[[nodiscard]] Csv parse_csv(std::string_view text, const std::string& file,
                            const CsvReading& reading = {});

} // namespace edgeproof::io

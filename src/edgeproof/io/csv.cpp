// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/csv.hpp"

#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::io {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Returns the separator of a header line, outside its quotes: a comma, or else a tab, or else a
/// semicolon.
char separator_of(std::string_view line) {
    bool quoted = false;
    bool tab = false;
    bool semicolon = false;
    for (const char c : line) {
        quoted = quoted != (c == '"');
        if (!quoted && c == ',') {
            return ',';
        }
        tab = tab || (!quoted && c == '\t');
        semicolon = semicolon || (!quoted && c == ';');
    }
    return tab ? '\t' : semicolon ? ';' : ',';
}

/// Throws for a text that does not consist of lines of ASCII or UTF-8.
void check_encoding(std::string_view text, const std::string& file) {
    if (text.substr(0, 2).find('\0') != std::string_view::npos) {
        throw InputError("the file is in UTF-16 without a byte order mark",
                         "save it as CSV in UTF-8")
            .at(file, 1);
    }
    if (text.find('\n') == std::string_view::npos) {
        const std::size_t end = text.find('\r');
        if (end != std::string_view::npos && end + 1 < text.size()) {
            throw InputError("the lines end in CR alone", "end them in LF or CR LF").at(file, 1);
        }
    }
}

void throw_fault(const Csv& csv, const Csv::Row& row) {
    throw InputError(row.fault, "quote a cell as a whole, or not at all, and write \"\" for one "
                                "quote in it")
        .at(csv.file, row.line);
}

/// Parses the rows of a text.
class Parser {
public:
    explicit Parser(std::string_view text) : text_(text) {}

    /// Reads the next row that is neither a note nor blank, with its fault if it breaks the rules;
    /// returns false after the last. The first row determines the separator.
    bool next(Csv& csv, Csv::Row& row) {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            const std::string_view line = text_.substr(at_, end - at_);
            const std::size_t first = line.find_first_not_of(blanks);
            const bool blank = first == std::string_view::npos && !has_cells(line);
            if (!blank && (first == std::string_view::npos || line[first] != '#')) {
                if (separator_ == '\0') {
                    separator_ = separator_of(line);
                    csv.separator = separator_;
                }
                read(row);
                return true;
            }
            if (!blank) {
                csv.notes.emplace_back(trimmed(line.substr(first + 1), blanks));
                csv.note_lines.push_back(line_);
            }
            at_ = std::min(end + 1, text_.size());
            ++line_;
        }
        return false;
    }
    /// The row read was a note; the header is still to come.
    void again() { separator_ = '\0'; }

private:
    /// With tabs as separators, a line of tabs only is a row of empty cells.
    [[nodiscard]] bool has_cells(std::string_view line) const {
        return separator_ == '\t' && line.find('\t') != std::string_view::npos;
    }
    [[nodiscard]] bool is_blank(char c) const {
        return (c == ' ' || c == '\t' || c == '\r') && c != separator_;
    }
    [[nodiscard]] bool ends_cell(std::size_t at) const {
        return at >= text_.size() || text_[at] == separator_ || text_[at] == '\n';
    }

    void read(Csv::Row& row) {
        row = {line_, {}};
        for (bool more = true; more;) {
            cell(row.cells.emplace_back(), row.fault);
            more = at_ < text_.size() && text_[at_] == separator_;
            at_ += more ? 1 : 0;
        }
        at_ = std::min(at_ + 1, text_.size()); // the line end
        ++line_;
    }
    /// Reads a cell up to the separator or the line end, which is not consumed.
    void cell(std::string& cell, std::string& fault) {
        const std::size_t from = at_;
        skip_blanks();
        if (at_ < text_.size() && text_[at_] == '"') {
            ++at_;
            quoted(cell, fault);
            return;
        }
        while (!ends_cell(at_)) {
            if (text_[at_] == '"') {
                fault = "a quote stands within a cell that does not begin with one";
            }
            ++at_;
        }
        cell = trimmed(text_.substr(from, at_ - from), blanks);
    }
    void quoted(std::string& cell, std::string& fault) {
        while (at_ < text_.size()) {
            const char c = text_[at_++];
            if (c != '"') {
                cell += c;
                line_ += c == '\n' ? 1 : 0;
            } else if (at_ < text_.size() && text_[at_] == '"') {
                cell += text_[at_++];
            } else {
                skip_blanks();
                while (!ends_cell(at_)) {
                    fault = "something follows a closing quote";
                    cell += text_[at_++];
                }
                return;
            }
        }
        fault = "a quote begins here and does not end";
    }
    void skip_blanks() {
        while (at_ < text_.size() && is_blank(text_[at_])) {
            ++at_;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    char separator_ = '\0';
};

} // namespace

std::optional<std::size_t> Csv::column(std::string_view name) const {
    const auto at = std::find(header.cells.begin(), header.cells.end(), name);
    return at == header.cells.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(at - header.cells.begin()));
}

Csv parse_csv(std::string_view text, const std::string& file, const CsvReading& reading) {
    Csv csv;
    csv.file = file;
    std::string converted;
    if (is_utf16(text)) {
        converted = utf8_text(std::string(text), file);
        text = converted;
    }
    check_encoding(text, file);
    text.remove_prefix(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    Parser parser(text);
    // A spreadsheet quotes a note that contains a separator.
    for (bool note = true; note;) {
        if (!parser.next(csv, csv.header)) {
            throw InputError("there is no header line", "write the names of the columns first")
                .at(file, 1);
        }
        const std::string& first = csv.header.cells.front();
        note = first.starts_with('#');
        if (note) {
            csv.notes.emplace_back(trimmed(std::string_view(first).substr(1), blanks));
            csv.note_lines.push_back(csv.header.line);
            parser.again();
        }
    }
    if (!csv.header.fault.empty()) {
        throw_fault(csv, csv.header);
    }
    for (Csv::Row row; parser.next(csv, row);) {
        if (csv.rows.size() >= reading.most_rows) {
            csv.cut = true;
            break;
        }
        if (!row.fault.empty() && !reading.keep_faults) {
            throw_fault(csv, row);
        }
        csv.rows.push_back(std::move(row));
    }
    return csv;
}

} // namespace edgeproof::io

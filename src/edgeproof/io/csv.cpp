// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/csv.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::io {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos
               ? std::string{}
               : std::string(text.substr(from, text.find_last_not_of(blanks) - from + 1));
}

/// Of the header line, outside its quotes: a comma, or else a tab, or else a semicolon.
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

class Parser {
public:
    explicit Parser(std::string_view text) : text_(text) {}

    /// The next row that is no note and not blank. The first tells the separator.
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
                csv.notes.push_back(trimmed(line.substr(first + 1)));
            }
            at_ = std::min(end + 1, text_.size());
            ++line_;
        }
        return false;
    }
    /// The header is still to come: what was read was a note.
    void again() { separator_ = '\0'; }

private:
    /// A line of nothing but tabs is a row of empty cells where tabs separate.
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
        row = {line_, {}, {}};
        for (bool more = true; more;) {
            row.cells.push_back(cell(row.fault));
            more = at_ < text_.size() && text_[at_] == separator_;
            at_ += more ? 1 : 0;
        }
        at_ = std::min(at_ + 1, text_.size()); // the line's end
        ++line_;
    }
    /// Up to the separator or the line's end, which it leaves.
    std::string cell(std::string& fault) {
        const std::size_t from = at_;
        skip_blanks();
        if (at_ < text_.size() && text_[at_] == '"') {
            ++at_;
            return quoted(fault);
        }
        while (!ends_cell(at_)) {
            if (text_[at_] == '"') {
                fault = "a quote stands within a cell that does not begin with one";
            }
            ++at_;
        }
        return trimmed(text_.substr(from, at_ - from));
    }
    std::string quoted(std::string& fault) {
        std::string cell;
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
                return cell;
            }
        }
        fault = "a quote begins here and does not end";
        return cell;
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

/// Throws for a text that is no lines of ASCII or UTF-8.
void check_encoding(std::string_view text, const std::string& file) {
    const auto begins = [&](unsigned char first, unsigned char second) {
        return text.size() > 1 && static_cast<unsigned char>(text[0]) == first &&
               static_cast<unsigned char>(text[1]) == second;
    };
    if (begins(0xFF, 0xFE) || begins(0xFE, 0xFF) ||
        text.substr(0, 2).find('\0') != std::string_view::npos) {
        throw InputError("the file is in UTF-16", "save it as CSV in UTF-8").at(file, 1);
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
    check_encoding(text, file);
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    Parser parser(text);
    // A spreadsheet quotes a note that holds a separator.
    for (bool note = true; note;) {
        if (!parser.next(csv, csv.header)) {
            throw InputError("there is no header line", "write the names of the columns first")
                .at(file, 1);
        }
        const std::string& first = csv.header.cells.front();
        note = first.starts_with('#');
        if (note) {
            csv.notes.push_back(trimmed(std::string_view(first).substr(1)));
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/csv.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <utility>

namespace edgeproof::io {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(blanks);
    return from == std::string_view::npos
               ? std::string_view{}
               : text.substr(from, text.find_last_not_of(blanks) - from + 1);
}

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

constexpr std::size_t block_bytes = 1U << 20U;

} // namespace

/// Parses rows of a text that may be given in parts.
class CsvReader::Parser {
public:
    enum class Got {
        row,
        end,
        part ///< the text ends within a row or a note: more text is needed
    };

    /// Sets the text from the current position on; `whole`: it is complete.
    void go_on(std::string_view text, bool whole) {
        text_ = text;
        at_ = 0;
        whole_ = whole;
    }
    [[nodiscard]] std::size_t at() const { return at_; }

    /// Reads the next row that is neither a note nor blank. The first row determines the separator.
    Got next(Csv& csv, Csv::Row& row) {
        while (at_ < text_.size()) {
            const std::size_t found = text_.find('\n', at_);
            const std::size_t end = std::min(found, text_.size());
            if (found == std::string_view::npos && !whole_) {
                return Got::part;
            }
            const std::string_view line = text_.substr(at_, end - at_);
            const std::size_t first = line.find_first_not_of(blanks);
            const bool blank = first == std::string_view::npos && !has_cells(line);
            if (!blank && (first == std::string_view::npos || line[first] != '#')) {
                if (separator_ == '\0') {
                    separator_ = separator_of(line);
                    csv.separator = separator_;
                }
                return read(row) ? Got::row : Got::part;
            }
            if (!blank) {
                csv.notes.emplace_back(trimmed(line.substr(first + 1)));
                csv.note_lines.push_back(line_);
            }
            at_ = std::min(end + 1, text_.size());
            ++line_;
        }
        return whole_ ? Got::end : Got::part;
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

    /// Returns false, without reading, if the text ends within the row.
    bool read(Csv::Row& row) {
        const std::size_t begin = at_;
        const std::size_t first_line = line_;
        row.line = line_;
        row.fault.clear();
        std::size_t cells = 0;
        for (bool more = true; more; ++cells) {
            if (cells == row.cells.size()) {
                row.cells.emplace_back();
            }
            cell(row.cells[cells], row.fault);
            more = at_ < text_.size() && text_[at_] == separator_;
            at_ += more ? 1 : 0;
        }
        row.cells.resize(cells);
        if (at_ >= text_.size() && !whole_) {
            at_ = begin;
            line_ = first_line;
            return false;
        }
        at_ = std::min(at_ + 1, text_.size()); // the line end
        ++line_;
        return true;
    }
    /// Reads a cell up to the separator or the line end, which is not consumed.
    void cell(std::string& cell, std::string& fault) {
        const std::size_t from = at_;
        skip_blanks();
        if (at_ < text_.size() && text_[at_] == '"') {
            ++at_;
            cell.clear();
            quoted(cell, fault);
            return;
        }
        while (!ends_cell(at_)) {
            if (text_[at_] == '"') {
                fault = "a quote stands within a cell that does not begin with one";
            }
            ++at_;
        }
        cell = trimmed(text_.substr(from, at_ - from));
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
    bool whole_ = true;
};

std::optional<std::size_t> Csv::column(std::string_view name) const {
    const auto at = std::find(header.cells.begin(), header.cells.end(), name);
    return at == header.cells.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(at - header.cells.begin()));
}

CsvReader::CsvReader(std::string_view text, const std::string& file)
    : parser_(std::make_unique<Parser>()) {
    head_.file = file;
    if (is_utf16(text)) {
        block_ = utf8_text(std::string(text), file);
        text = block_;
    }
    check_encoding(text, file);
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    parser_->go_on(text, true);
    begin();
}

CsvReader::CsvReader(const std::filesystem::path& file, const std::string& what)
    : file_(std::make_unique<TextReader>(file, what)), parser_(std::make_unique<Parser>()) {
    head_.file = input_name(file);
    bool more = true;
    // All of a text in UTF-16 is read at once, since it is converted as a whole.
    while (more && (block_.find('\n') == std::string::npos || is_utf16(block_))) {
        more = file_->read(block_, block_bytes);
    }
    block_ = utf8_text(std::move(block_), head_.file);
    check_encoding(block_, head_.file);
    if (block_.starts_with(byte_order_mark)) {
        block_.erase(0, byte_order_mark.size());
    }
    parser_->go_on(block_, !more);
    begin();
}

CsvReader::~CsvReader() = default;

void CsvReader::begin() {
    // A spreadsheet quotes a note that contains a separator.
    for (bool note = true; note;) {
        if (!next(head_.header)) {
            throw InputError("there is no header line", "write the names of the columns first")
                .at(head_.file, 1);
        }
        const std::string& first = head_.header.cells.front();
        note = first.starts_with('#');
        if (note) {
            head_.notes.emplace_back(trimmed(std::string_view(first).substr(1)));
            head_.note_lines.push_back(head_.header.line);
            parser_->again();
        }
    }
    if (!head_.header.fault.empty()) {
        throw_fault(head_, head_.header);
    }
}

bool CsvReader::next(Csv::Row& row) {
    Parser::Got got = Parser::Got::part;
    while ((got = parser_->next(head_, row)) == Parser::Got::part) {
        block_.erase(0, parser_->at());
        const bool more = file_->read(block_, std::max(block_bytes, block_.size()));
        parser_->go_on(block_, !more);
    }
    return got == Parser::Got::row;
}

Csv parse_csv(std::string_view text, const std::string& file, const CsvReading& reading) {
    CsvReader reader(text, file);
    std::vector<Csv::Row> rows;
    bool cut = false;
    for (Csv::Row row; reader.next(row);) {
        if (rows.size() >= reading.most_rows) {
            cut = true;
            break;
        }
        if (!row.fault.empty() && !reading.keep_faults) {
            throw_fault(reader.head(), row);
        }
        rows.push_back(std::move(row));
        row = {};
    }
    Csv csv = reader.head();
    csv.rows = std::move(rows);
    csv.cut = cut;
    return csv;
}

} // namespace edgeproof::io

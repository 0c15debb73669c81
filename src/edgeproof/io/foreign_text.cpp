// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/foreign_text.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/message.hpp"
#include "edgeproof/precision/rounding/text.hpp"

#include <algorithm>
#include <charconv>
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

namespace {

using Kind = WrittenNumber::Kind;

constexpr long most_binary_exponent = 332'192; // 2^332192 < 10^100000
constexpr std::size_t most_hexadecimal_digits = 100'000;

/// Reads the text after 0x. <cctype> depends on the locale.
std::optional<Rational> hexadecimal_value(std::string_view text) {
    const std::size_t letter = std::min(text.find('p'), text.size());
    std::string digits(text.substr(0, letter));
    long exponent = 0;
    if (letter < text.size()) {
        text.remove_prefix(letter + 1);
        text.remove_prefix(text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
        const auto read = std::from_chars(text.data(), text.data() + text.size(), exponent);
        if (read.ec != std::errc{} || read.ptr != text.data() + text.size() ||
            exponent < -most_binary_exponent || exponent > most_binary_exponent) {
            return {};
        }
    }
    if (const std::size_t point = digits.find('.'); point != std::string::npos) {
        digits.erase(point, 1);
        exponent -= 4 * static_cast<long>(digits.size() - point);
    }
    if (digits.empty() || digits.size() > most_hexadecimal_digits ||
        digits.find_first_not_of("0123456789abcdef") != std::string::npos) {
        return {};
    }
    const Integer whole("0x" + digits);
    const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
    return exponent < 0 ? Rational(whole, power) : Rational(whole * power);
}

std::optional<Rational> decimal_value(std::string text) {
    std::ranges::replace(text, 'd', 'e');
    if (text.empty() || text.find_first_not_of(".0123456789") == 0 ||
        text.find_first_not_of(".0123456789e+-") != std::string::npos) {
        return {};
    }
    try {
        return parse_decimal(text);
    } catch (const InputError&) { // malformed, too long, or out of range
        return {};
    }
}

/// True for the text after "nan": nothing, or letters, digits and _ in parentheses.
bool is_payload(std::string_view text) {
    return text.empty() ||
           (text.size() > 1 && text.front() == '(' &&
            text.find_first_not_of("0123456789abcdefghijklmnopqrstuvwxyz_", 1) == text.size() - 1 &&
            text.back() == ')');
}

} // namespace

WrittenNumber written_number(std::string_view text) {
    const std::string lower = lower_case(text);
    std::string_view rest = lower;
    const bool negative = rest.starts_with('-');
    rest.remove_prefix(negative || rest.starts_with('+') ? 1 : 0);
    if (rest == "inf" || rest == "infinity") {
        return {Kind::infinite, {}};
    }
    if (rest.starts_with("nan")) {
        return {is_payload(rest.substr(3)) ? Kind::nan : Kind::other, {}};
    }
    const auto value = rest.starts_with("0x") ? hexadecimal_value(rest.substr(2))
                                              : decimal_value(std::string(rest));
    return value ? WrittenNumber{Kind::number, negative ? Rational(-*value) : *value}
                 : WrittenNumber{};
}

std::optional<Rational> read_number(std::string_view text) {
    WrittenNumber written = written_number(text);
    return written.kind == Kind::number ? std::optional(std::move(written.value)) : std::nullopt;
}

DecimalForm form_of(std::string_view text) {
    DecimalForm form;
    if (text.find_first_of("xX") != std::string_view::npos) {
        form.exact = true;
        return form;
    }
    text.remove_prefix(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
    const std::size_t letter = text.find_first_of("eEdD");
    int exponent = 0;
    if (letter != std::string_view::npos) {
        form.with_exponent = true;
        std::string_view digits = text.substr(letter + 1);
        digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        text = text.substr(0, letter);
    }
    const std::size_t point = std::min(text.find('.'), text.size());
    int place = static_cast<int>(point) - 1 + exponent; // power of ten of the current digit
    for (const char c : text) {
        if (c == '.') {
            continue;
        }
        if (form.zero && c != '0') {
            form.zero = false;
            form.leading = place;
        }
        form.significant += form.zero ? 0 : 1;
        if (c != '0') {
            form.carried = form.significant;
            form.carried_decimals = std::max(0, -place);
        }
        --place;
    }
    form.decimals = static_cast<int>(point < text.size() ? text.size() - point - 1 : 0);
    return form;
}

std::optional<std::string> with_decimal_point(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || text.find('.') != std::string_view::npos ||
        text.find_first_of("xX") != std::string_view::npos) {
        return {};
    }
    std::string pointed(text);
    pointed[comma] = '.';
    return read_number(pointed) ? std::optional(pointed) : std::nullopt;
}

} // namespace edgeproof::io
